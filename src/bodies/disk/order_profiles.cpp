#include "bodies/disk/order_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "bodies/disk/edge_points.hpp"
#include "bodies/disk/mode_field.hpp"
#include "bodies/disk/static_field.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::disk {
namespace {

using Eigen::Index;

std::array<double, OrderProfiles::components> values(const RadialField& field) {
  return {field.radial, field.tangential, field.stress_rr, field.stress_pp, field.stress_rp};
}

/// The powers of one radius for the orders n = first … first + order_block − 1.
class BlockPowers {
 public:
  BlockPowers(double radius, int first) : ring_((1.0 - radius) * (1.0 + radius)) {
    double power = std::pow(radius, std::max(0, first - 2));
    for (auto k = static_cast<std::size_t>(std::max(0, 2 - first)); k < power_.size(); ++k) {
      power_[k] = power;
      power *= radius;
    }
  }

  [[nodiscard]] RadialPowers operator[](std::size_t k) const {
    return {power_[k] * ring_, power_[k + 1], power_[k + 2], power_[k + 3]};
  }

 private:
  double ring_;                                  // r^{n−2} − r^n = r^{n−2}(1 − r²)
  std::array<double, order_block + 3> power_{};  // from r^{first−2}; 0 for negative powers
};

/// Number of orders whose static field is felt at a radius: r^n falls to 1e-20.
int static_orders(double radius, int nyquist) {
  if (radius == 1.0) return nyquist + 1;
  const double last = 3.0 - 46.0 / std::log(std::max(radius, 1e-30));
  return 1 + (last < nyquist ? static_cast<int>(last) : nyquist);
}

/// Checks the Poisson's ratio: only with its own does a mode have these amplitudes at a free edge.
void require_free_edge(double poisson, const Body& body, const Mode& mode, const RadialField& edge) {
  const double amplitude = std::hypot(mode.radial, mode.tangential);
  const double mismatch = std::hypot(edge.radial - mode.radial, edge.tangential - mode.tangential);
  const double traction = std::hypot(edge.stress_rr, edge.stress_rp);
  if (mismatch < 1e-6 * amplitude && traction < 1e-6 * amplitude * (mode.order + mode.omega)) return;
  std::ostringstream line;
  line.precision(10);
  line << "poisson: got " << poisson << ", allowed only that of the body, which is '" << body.name
       << "' (a disk; with another number its modes would not leave the edge free)";
  throw InvalidInput(line.str());
}

}  // namespace

OrderProfiles::OrderProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
                             const Poll& poll)
    : poisson_(poisson),
      node_(static_cast<Index>(contact.count)),
      nyquist_(static_cast<int>(std::lround(std::numbers::pi / (contact.spacing * contact.radius)))),
      radius_(std::move(radius)) {
  for (Index i = 0; i < node_.size(); ++i) node_(i) = edge_angle(contact, static_cast<std::size_t>(i));
  int kept_orders = 0;
  for (const ModeGroup& group : body.groups) {
    keep(body, group, poll);
    kept_orders = std::max(kept_orders, group.order + 1);
  }
  for (const double r : radius_) orders_.push_back(std::max(kept_orders, static_orders(r, nyquist_)));
}

void OrderProfiles::keep(const Body& body, const ModeGroup& group, const Poll& poll) {
  const auto radii = static_cast<Index>(radius_.size());
  const auto size = static_cast<Index>(group.omega.size());
  KeptOrder kept{group.order, modes_, Eigen::VectorXd(size), Eigen::VectorXd(size),
                 Eigen::MatrixXd(static_cast<Index>(components) * radii, size)};
  std::vector<double> with_edge = radius_;
  with_edge.push_back(1.0);
  for (std::size_t l = 0; l < group.omega.size(); ++l) {
    const Mode mode{group.order, static_cast<int>(l), group.omega[l], group.upper[l] + group.lower[l],
                    group.upper[l] - group.lower[l]};
    const std::vector<RadialField> field = mode_field(poisson_, mode, with_edge, poll);
    require_free_edge(poisson_, body, mode, field.back());
    const auto column = static_cast<Index>(l);
    kept.radial[column] = mode.radial / (mode.omega * mode.omega);
    kept.tangential[column] = mode.tangential / (mode.omega * mode.omega);
    for (Index r = 0; r < radii; ++r) {
      Index row = r;
      for (const double value : values(field[static_cast<std::size_t>(r)])) {
        kept.field(row, column) = value;
        row += radii;
      }
    }
  }
  kept_.push_back(std::move(kept));
  modes_ += size;
}

OrderProfiles::Loads OrderProfiles::loads(const Eigen::ArrayXd& node_force, int first) const {
  const Harmonics at = harmonics(node_, first);
  Loads loads{-at.cosine * (node_force * node_.cos()).matrix(), at.sine * (node_force * node_.sin()).matrix()};
  for (int k = 0; k < order_block; ++k) {
    const int order = first + k;
    const double weight = order < nyquist_ ? 1.0 : (order == nyquist_ ? 0.5 : 0.0);
    loads.normal[k] *= order == 0 ? 0.5 : weight;
    loads.shear[k] *= weight;
  }
  return loads;
}

void OrderProfiles::add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const {
  std::array<StaticField, order_block> field;
  for (int k = 0; k < order_block; ++k) {
    field[static_cast<std::size_t>(k)] = static_field(poisson_, first + k, loads.normal[k], loads.shear[k]);
  }
  for (std::size_t r = 0; r < radius_.size(); ++r) {
    if (poll) poll();
    if (orders_[r] <= first) continue;
    const BlockPowers power(radius_[r], first);
    for (std::size_t k = 0; k < field.size(); ++k) {
      const auto value = values(field[k].at(power[k]));
      for (std::size_t i = 0; i < components; ++i) {
        profile[i](static_cast<Index>(r), static_cast<Index>(k)) += value[i];
      }
    }
  }
}

void OrderProfiles::add_kept(const Eigen::VectorXd& coordinate, const Loads& loads, int first, Profile& profile) const {
  const auto radii = static_cast<Index>(radius_.size());
  for (const KeptOrder& kept : kept_) {
    const int k = kept.order - first;
    if (k < 0 || k >= order_block) continue;
    const double normal = kept.order == 0 ? 2.0 * loads.normal[k] : loads.normal[k];  // w_n g_C
    const Eigen::VectorXd excess =
        coordinate.segment(kept.first, kept.radial.size()) - normal * kept.radial - loads.shear[k] * kept.tangential;
    const Eigen::VectorXd sum = kept.field * excess;
    for (std::size_t i = 0; i < components; ++i) {
      profile[i].col(k) += sum.segment(static_cast<Index>(i) * radii, radii);
    }
  }
}

void OrderProfiles::evaluate(const Eigen::VectorXd& coordinate, const Eigen::ArrayXd& node_force, int first,
                             const Poll& poll, Profile& profile) const {
  const auto radii = static_cast<Index>(radius_.size());
  for (Harmonics::Matrix& component : profile) component.setZero(radii, order_block);
  const Loads loads = this->loads(node_force, first);
  add_static(loads, first, poll, profile);
  add_kept(coordinate, loads, first, profile);
}

}  // namespace stoss::bodies::disk
