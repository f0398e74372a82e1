// The kept waves as they move, and the static answer of all others: Σ (profile in the depth) × (shape along the
// surface).
#include "stoss/bodies/half_space/field.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "bodies/field_arguments.hpp"
#include "bodies/half_space/medium.hpp"
#include "bodies/surface/profile_sum.hpp"
#include "bodies/surface/residual.hpp"
#include "check.hpp"
#include "numeric/quadrature.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::half_space {
namespace {

/// kz at which e^{−kz} is below 1e-17.
constexpr double deepest = 40.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::complex<double> root_above_branch_point(double square) {
  return square >= 0.0 ? std::complex<double>(std::sqrt(square)) : std::complex<double>(0.0, std::sqrt(-square));
}

/// How the wave (k, x) moves the half-space below the surface, over its displacement of the surface into it,
///
///   g_z = Im{a [(1 + b²) e^{−akz} − 2e^{−bkz}]/R}/D,   g_r = Im{[(1 + b²) e^{−akz} − 2ab e^{−bkz}]/R}/D,
///
/// with a² = 1 − η̂x², b² = 1 − x², both roots above their branch points on the positive imaginary axis,
/// R = (1 + b²)² − 4ab and D = −Im{ax²/R}; for the Rayleigh wave, x = x_R, with 1 for 1/R and no Im. A wave of the
/// continuum is a standing one in the depth: what comes from there and what leaves.
class WaveProfile {
 public:
  /// @param x speed of the wave along the surface over c_s: x_R, or above 1
  WaveProfile(const LambKernel& kernel, double x);

  /// @param phase kz
  [[nodiscard]] DepthProfile at(double phase) const;

 private:
  using Complex = std::complex<double>;
  Complex pressure_decay_, shear_decay_;  // a, b
  Complex pressure_lateral_, shear_lateral_, pressure_normal_, shear_normal_;
};

WaveProfile::WaveProfile(const LambKernel& kernel, double x)
    : pressure_decay_(root_above_branch_point(1.0 - kernel.squared_ratio * x * x)),
      shear_decay_(root_above_branch_point(1.0 - x * x)) {
  const double square = x * x, sum = 2.0 - square;  // 1 + b²
  const Complex a = pressure_decay_, b = shear_decay_;
  // What belongs to the Rayleigh wave is real: i makes it an imaginary part like the others.
  const Complex inverse = x > 1.0 ? 1.0 / (sum * sum - 4.0 * a * b) : Complex(0.0, 1.0);
  const double surface = -(a * square * inverse).imag();
  const Complex unit = inverse / surface;
  pressure_lateral_ = sum * unit;
  shear_lateral_ = -2.0 * a * b * unit;
  pressure_normal_ = a * pressure_lateral_;
  shear_normal_ = -2.0 * a * unit;
}

DepthProfile WaveProfile::at(double phase) const {
  const Complex pressure = std::exp(-pressure_decay_ * phase), shear = std::exp(-shear_decay_ * phase);
  return {(pressure_lateral_ * pressure + shear_lateral_ * shear).imag(),
          (pressure_normal_ * pressure + shear_normal_ * shear).imag()};
}

/// The same under a static load: e^{−kz}(kz − 1 + 2ν)/(2 − 2ν) and e^{−kz}(1 + kz/(2 − 2ν)).
DepthProfile static_profile(double poisson, double phase) {
  const double decay = std::exp(-phase), half = 0.5 / (1.0 - poisson);
  return {decay * (phase - 1.0 + 2.0 * poisson) * half, decay * (1.0 + phase * half)};
}

/// The medium of a half-space of which these are the waves.
Medium medium_of(double poisson, const Body& body) {
  validate(body);
  const auto refuse = [&] {
    throw InvalidInput::out_of_range("body", "'" + body.name + "'",
                                     "the elastic half-space or half-plane of this poisson");
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
  require_points(points, contact, infinity);
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
  ProfileSum sum(its.medium, its.points, poll);
  double wave_number = 0.0;
  const auto phase = [&](std::size_t depth) { return wave_number * its.points.depth[depth]; };
  const auto at_rest = [&](std::size_t depth) {
    return phase(depth) < deepest ? static_profile(kernel.poisson, phase(depth)) : DepthProfile{0.0, 0.0};
  };
  const auto start = [&](double next) {
    wave_number = next;
    sum.start(next);
  };

  std::size_t k = 0;
  for (const ModeGroup& group : its.groups) {
    const double unit = its.medium.shear_speed * group.wave_number;  // ω of x = 1
    const double load = its.load(group.wave_number, node_force);
    // Static compliance of all waves of this wave number: that of the Rayleigh wave is a_R/x_R² of it.
    const double compliance = group.upper.front() * group.upper.front() / (unit * unit * kernel.rayleigh_weight);
    start(group.wave_number);
    sum.add(load * compliance, at_rest);
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const double omega = group.omega[l], amplitude = group.upper[l];
      const double unlike_static = coordinate[k] + load * amplitude / (omega * omega);
      const WaveProfile profile(kernel, l == 0 ? kernel.rayleigh_root : omega / unit);
      sum.add(-amplitude * unlike_static, [&](std::size_t depth) { return profile.at(phase(depth)); });
    }
  }

  const auto loaded = [](double force) { return force != 0.0; };
  if (std::none_of(node_force.begin(), node_force.end(), loaded)) return sum.field();
  constexpr double turn = 16.0;  // by which a shape times the load turns in a panel
  const double reach = its.ring.back() + *std::max_element(its.points.distance.begin(), its.points.distance.end());
  const auto& rule = numeric::gauss_legendre(16);
  for (double from = its.lowest_unkept; from < its.highest;) {
    const double to = std::min({its.highest, 2.0 * from, from + turn / reach});
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double number = 0.5 * (from + to) + 0.5 * (to - from) * rule.node[i];
      start(number);
      sum.add(its.load(number, node_force) * its.medium.compliance(number) * 0.5 * (to - from) * rule.weight[i],
              at_rest);
    }
    from = to;
  }
  return sum.field();
}

}  // namespace stoss::bodies::half_space
