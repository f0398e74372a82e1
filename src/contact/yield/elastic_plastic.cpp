#include "stoss/contact/elastic_plastic.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "check.hpp"

namespace stoss {
namespace {

constexpr double most_depth = 1e6;

void require_depth(std::string_view name, double depth) {
  require(name, depth, {0.0, most_depth, true, true, "0 to 1e6"}, "compression over that at the onset of yield");
}

void require_speed_ratio(double ratio) {
  require("speed_ratio", ratio, {0.0, 1e5, true, true, "0 to 1e5"}, "speed over that at which yielding begins");
}

/// Fits of own finite elements (studies/yield) at ν = 0.3, in the units of the onset, for d of 1 and more. From d =
/// 1600 on, where the runs end, they go on as powers.
namespace fits {

/// ln of a quantity over that at the onset, Σ b_k (ln d)^k from k = `first` on.
template <std::size_t Terms>
struct Fit {
  int first;
  std::array<double, Terms> terms;

  [[nodiscard]] double value(double x) const {
    double sum = 0.0;
    for (std::size_t i = Terms; i-- > 0;) sum = sum * x + terms[i];
    return sum * std::pow(x, first);
  }

  [[nodiscard]] double slope(double x) const {
    double sum = 0.0;
    for (std::size_t i = Terms; i-- > 0;) sum = sum * x + (first + static_cast<int>(i)) * terms[i];
    return sum * std::pow(x, first - 1);
  }

  /// With the tangent beyond the last run.
  [[nodiscard]] double at(double x) const {
    const double last = std::min(x, end());
    return value(last) + slope(last) * (x - last);
  }
  [[nodiscard]] double slope_at(double x) const { return slope(std::min(x, end())); }

  static double end() {
    static const double last = std::log(1600.0);
    return last;
  }
};

// Of f/d^(3/2), a²/d, (d_m − d_r)/d_m, and the work of the return over that of the compression.
constexpr Fit<7> hardness{
    2, {-3.457802e-02, -1.626393e-02, 1.170131e-02, -3.905304e-03, 7.065046e-04, -6.556353e-05, 2.436239e-06}};
constexpr Fit<7> area{
    2, {1.061446e-01, -5.140971e-02, 2.332555e-02, -7.764317e-03, 1.475124e-03, -1.415663e-04, 5.343506e-06}};
constexpr Fit<6> way{2, {-2.167939e-01, 1.041719e-01, -3.266291e-02, 5.939998e-03, -5.658455e-04, 2.167279e-05}};
constexpr Fit<6> regained{2, {-1.858069e-01, 6.987411e-02, -1.852472e-02, 3.069021e-03, -2.815691e-04, 1.072938e-05}};

/// What hardening adds to the logarithm of each, ηx²(b₀ + b₁x) with η = h/(1 + 5h).
struct Harder {
  double constant, rising;

  [[nodiscard]] double at(double x, double hardening) const {
    return share(hardening) * x * x * (constant + rising * x);
  }
  [[nodiscard]] double slope_at(double x, double hardening) const {
    return share(hardening) * x * (2.0 * constant + 3.0 * rising * x);
  }
  static double share(double hardening) { return hardening / (1.0 + 5.0 * hardening); }
};

constexpr Harder harder{0.0372, 0.0198}, harder_way{0.1309, 0.0105}, harder_regained{0.0906, 0.0279};

double force(double depth, double h) {
  const double x = std::log(depth);
  return depth * std::sqrt(depth) * std::exp(hardness.at(x) + harder.at(x, h));
}

double stiffness(double depth, double h) {
  const double x = std::log(depth);
  return force(depth, h) / depth * (1.5 + hardness.slope_at(x) + harder.slope_at(x, h));
}

double radius(double depth) { return std::sqrt(depth * std::exp(area.at(std::log(depth)))); }

double work(double depth, double h) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const double x = std::log(depth), last = std::min(x, hardness.end());
  const auto integrand = [h](double at) { return force(std::exp(at), h) * std::exp(at); };
  double sum = 0.4;
  constexpr int panels = 4;
  for (int i = 0; i < panels; ++i) sum += Rule::integrate(integrand, last * i / panels, last * (i + 1) / panels);
  if (x == last) return sum;
  const double power = 2.5 + hardness.slope_at(last) + harder.slope_at(last, h);  // of f d beyond
  return sum + integrand(last) * std::expm1(power * (x - last)) / power;
}

Unloading unloading(double deepest, double h) {
  const double x = std::log(deepest), recovers = deepest * std::exp(way.at(x) + harder_way.at(x, h));
  const double most = force(deepest, h), back = work(deepest, h) * std::exp(regained.at(x) + harder_regained.at(x, h));
  return {deepest - recovers, most * recovers / back - 1.0, most * most / (recovers * recovers * recovers)};
}

}  // namespace fits

}  // namespace

double loading_force(double depth, double hardening) {
  require_depth("depth", depth);
  return depth <= 1.0 ? depth * std::sqrt(depth) : fits::force(depth, hardening);
}

double loading_stiffness(double depth, double hardening) {
  require_depth("depth", depth);
  return depth <= 1.0 ? 1.5 * std::sqrt(depth) : fits::stiffness(depth, hardening);
}

double loading_radius(double depth) {
  require_depth("depth", depth);
  return depth <= 1.0 ? std::sqrt(depth) : fits::radius(depth);
}

double loading_work(double depth, double hardening) {
  require_depth("depth", depth);
  return depth <= 1.0 ? 0.4 * depth * depth * std::sqrt(depth) : fits::work(depth, hardening);
}

double depth_of_work(double work, double hardening) {
  const double most = fits::work(most_depth, hardening);
  require("work", work, {0.0, most, true, true, "0 to that of a compression of 1e6"}, "over that of the onset");
  if (work <= 0.4) return std::pow(2.5 * work, 0.4);
  const auto excess = [&](double depth) { return loading_work(depth, hardening) - work; };
  // Below the elastic work, and above that of a constant force.
  const double lowest = std::pow(2.5 * work, 0.4), highest = std::min(most_depth, 1.0 + work);
  constexpr int bits = 50;
  std::uintmax_t steps = 200;
  const auto ends = boost::math::tools::toms748_solve(excess, lowest, highest, excess(lowest), excess(highest),
                                                      boost::math::tools::eps_tolerance<double>(bits), steps);
  return 0.5 * (ends.first + ends.second);
}

Unloading unloading(double deepest, double hardening) {
  require_depth("deepest", deepest);
  return deepest <= 1.0 ? Unloading{} : fits::unloading(deepest, hardening);
}

double unloading_work(double deepest, double hardening) {
  const Unloading back = unloading(deepest, hardening);
  return loading_force(deepest, hardening) * (deepest - back.residual) / (back.exponent + 1.0);
}

double plastic_restitution(double speed_ratio) {
  require_speed_ratio(speed_ratio);
  if (speed_ratio <= 1.0) return 1.0;
  const double depth = depth_of_work(0.4 * speed_ratio * speed_ratio);
  return std::sqrt(unloading_work(depth) / loading_work(depth));
}

}  // namespace stoss
