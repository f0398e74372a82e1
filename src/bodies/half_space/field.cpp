// Every wave number adds (profile in the depth) × (shape along the surface): products of matrices, depths × wave
// numbers by wave numbers × distances, a block of wave numbers at a time.
#include "stoss/bodies/half_space/field.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bodies/field_arguments.hpp"
#include "bodies/half_space/depth_profile.hpp"
#include "bodies/half_space/medium.hpp"
#include "bodies/surface/residual.hpp"
#include "check.hpp"
#include "numeric/gauss_legendre.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::half_space {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Index;

void require_points(const PlaneGrid& points, const ContactPoints& contact) {
  const auto depths = static_cast<long>(points.depth.size()), distances = static_cast<long>(points.distance.size());
  require("depth count", depths, 1, 1'000'000, "depths of the points");
  require("distance count", distances, 1, 1'000'000, "distances of the points from the axis");
  require("point count", depths * distances, 1, 100'000'000, "depths times distances");
  constexpr Range inside{0.0, 1e6, true, true, "0 to 1e6"};
  for (const double depth : points.depth) require("depth", depth, inside, "below the surface");
  for (const double distance : points.distance) require("distance", distance, inside, "from the axis");
  require_nodes(contact, {0.0, 1e6, false, true, "above 0 to 1e6"}, "of the circle of the points");
}

/// kz at which e^{−kz} is below 1e-17.
constexpr double deepest = 40.0;

/// The medium of a half-space of which these are the waves.
Medium medium_of(double poisson, const Body& body) {
  validate(body);
  const auto refuse = [&] {
    throw InvalidInput("body: got '" + body.name + "', allowed the elastic half-space or half-plane of this poisson");
  };
  if (!is_unbounded(body) || body.groups.empty()) refuse();
  Medium its = medium(body.contour, poisson);
  constexpr double rounding = 1e-12;
  for (const ModeGroup& group : body.groups) {
    const double omega = std::min(its.kernel.rayleigh_root * its.shear_speed * group.wave_number, kept_cutoff(body));
    if (!(std::abs(group.omega.front() - omega) <= rounding * omega)) refuse();
  }
  return its;
}

/// Σ over wave numbers of profile × shape.
class ProfileSum {
 public:
  ProfileSum(const Medium& medium, const PlaneGrid& points, const Poll& poll)
      : medium_(medium),
        points_(points),
        poll_(poll),
        lateral_(Matrix::Zero(depths(), distances())),
        normal_(Matrix::Zero(depths(), distances())),
        lateral_profile_(Matrix::Zero(depths(), block)),
        normal_profile_(Matrix::Zero(depths(), block)),
        lateral_shape_(block, distances()),
        normal_shape_(block, distances()) {}

  /// Goes on with the next wave number.
  void start(double wave_number) {
    if (row_ + 1 == block) flush();
    ++row_;
    wave_number_ = wave_number;
    for (Index i = 0; i < distances(); ++i) {
      const double phase = wave_number * points_.distance[static_cast<std::size_t>(i)];
      normal_shape_(row_, i) = medium_.shape(phase);
      lateral_shape_(row_, i) = medium_.slope(phase);
    }
  }

  /// @param profile DepthProfile of kz
  template <typename Profile>
  void add(double amplitude, Profile profile) {
    for (Index i = 0; i < depths(); ++i) {
      const DepthProfile at = profile(wave_number_ * points_.depth[static_cast<std::size_t>(i)]);
      if (at.normal == 0.0 && at.lateral == 0.0) continue;
      reached_ = std::max(reached_, i + 1);
      lateral_profile_(i, row_) += amplitude * at.lateral;
      normal_profile_(i, row_) += amplitude * at.normal;
    }
  }

  [[nodiscard]] Field field() {
    flush();
    return {{lateral_.data(), lateral_.data() + lateral_.size()}, {normal_.data(), normal_.data() + normal_.size()}};
  }

 private:
  static constexpr Index block = 64;
  [[nodiscard]] Index depths() const { return static_cast<Index>(points_.depth.size()); }
  [[nodiscard]] Index distances() const { return static_cast<Index>(points_.distance.size()); }

  void flush() {
    if (poll_) poll_();
    const Index rows = row_ + 1;
    lateral_.topRows(reached_).noalias() +=
        lateral_profile_.topLeftCorner(reached_, rows) * lateral_shape_.topRows(rows);
    normal_.topRows(reached_).noalias() += normal_profile_.topLeftCorner(reached_, rows) * normal_shape_.topRows(rows);
    lateral_profile_.topRows(reached_).setZero();
    normal_profile_.topRows(reached_).setZero();
    reached_ = 0;
    row_ = -1;
  }

  const Medium& medium_;
  const PlaneGrid& points_;
  const Poll& poll_;
  Matrix lateral_, normal_, lateral_profile_, normal_profile_, lateral_shape_, normal_shape_;
  Index row_ = -1;
  Index reached_ = 0;  // depths with a profile
  double wave_number_ = 0.0;
};

}  // namespace

WaveSpeeds wave_speeds(Contour contour, double poisson) {
  const Medium its = medium(contour, poisson);
  return {its.pressure_speed, its.shear_speed, its.kernel.rayleigh_root * its.shear_speed};
}

struct HalfSpaceField::Parts {
  Medium medium;
  std::vector<ModeGroup> groups;
  std::size_t modes;
  std::vector<double> ring;  // distances of the contact points
  double lowest_unkept;      // wave number
  double highest;            // wave number
  PlaneGrid points;

  /// Load of a wave number.
  [[nodiscard]] double load(double wave_number, std::span<const double> node_force) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += node_force[i] * medium.shape(wave_number * ring[i]);
    return sum;
  }
};

HalfSpaceField::HalfSpaceField(double poisson, const Body& body, const ContactPoints& contact, PlaneGrid points) {
  require_points(points, contact);
  Medium its = medium_of(poisson, body);
  std::vector<double> ring(contact.count);
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = lateral_distance(contact, i);
  const double lowest_unkept = kept_cutoff(body) / (its.kernel.rayleigh_root * its.shear_speed);
  const double top = *std::min_element(points.depth.begin(), points.depth.end());
  const double highest = std::min(std::numbers::pi / (contact.spacing * contact.radius), deepest / top);
  parts_ = std::make_shared<const Parts>(
      Parts{its, body.groups, mode_count(body), std::move(ring), lowest_unkept, highest, std::move(points)});
}

Field HalfSpaceField::at(std::span<const double> coordinate, std::span<const double> node_force,
                         const Poll& poll) const {
  const Parts& its = *parts_;
  require_length("coordinate", coordinate.size(), its.modes, "one for each kept mode");
  require_length("node_force", node_force.size(), its.ring.size(), "one for each ring");
  require_finite("coordinate", coordinate, "Q of the kept modes");
  require_finite("node_force", node_force, "share of each ring in the force");
  const LambKernel& kernel = its.medium.kernel;
  const auto at_rest = [&](double phase) {
    return phase < deepest ? static_profile(kernel.poisson, phase) : DepthProfile{0.0, 0.0};
  };
  ProfileSum sum(its.medium, its.points, poll);

  std::size_t k = 0;
  for (const ModeGroup& group : its.groups) {
    const double unit = its.medium.shear_speed * group.wave_number;  // ω of x = 1
    const double load = its.load(group.wave_number, node_force);
    // Static compliance of all waves of this wave number: that of the Rayleigh wave is a_R/x_R² of it.
    const double compliance = group.upper.front() * group.upper.front() / (unit * unit * kernel.rayleigh_weight);
    sum.start(group.wave_number);
    sum.add(load * compliance, at_rest);
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const double omega = group.omega[l], amplitude = group.upper[l];
      const double unlike_static = coordinate[k] + load * amplitude / (omega * omega);
      const WaveProfile profile(kernel, l == 0 ? kernel.rayleigh_root : omega / unit);
      sum.add(-amplitude * unlike_static, [&](double phase) { return profile.at(phase); });
    }
  }

  const auto loaded = [](double force) { return force != 0.0; };
  if (std::none_of(node_force.begin(), node_force.end(), loaded)) return sum.field();
  constexpr double phase = 16.0;  // by which a shape times the load turns in a panel
  const double reach = its.ring.back() + *std::max_element(its.points.distance.begin(), its.points.distance.end());
  const auto& rule = numeric::gauss_legendre(16);
  for (double from = its.lowest_unkept; from < its.highest;) {
    const double to = std::min({its.highest, 2.0 * from, from + phase / reach});
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double number = 0.5 * (from + to) + 0.5 * (to - from) * rule.node[i];
      sum.start(number);
      sum.add(its.load(number, node_force) * its.medium.compliance(number) * 0.5 * (to - from) * rule.weight[i],
              at_rest);
    }
    from = to;
  }
  return sum.field();
}

}  // namespace stoss::bodies::half_space
