#include "stoss/quasistatic/elastic_plastic.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "check.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss::quasistatic {
namespace {

constexpr double most_depth = 1e6;

void require_depth(std::string_view name, double depth) {
  require(name, depth, {0.0, most_depth, true, true, "0 to 1e6"}, "compression over that at the onset of yield");
}

void require_speed_ratio(double ratio) {
  require("speed_ratio", ratio, {0.0, 1e5, true, true, "0 to 1e5"}, "speed over that at which yielding begins");
}

/// Of Thornton and Ning: p₀ keeps its value, so the force grows by the area, and returns by Hertz' law with R_p/R =
/// d^{3/2}/f.
double capped_force(double depth) { return 1.0 + 1.5 * (depth - 1.0); }
double capped_work(double depth) { return 0.4 + (depth - 1.0) * (1.0 + 0.75 * (depth - 1.0)); }

Unloading capped_unloading(double deepest) {
  const double force = capped_force(deepest), ratio = deepest * std::sqrt(deepest) / force;
  return {deepest - std::cbrt(force * force / ratio), 1.5, ratio};
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

double force(double depth) { return depth * std::sqrt(depth) * std::exp(hardness.at(std::log(depth))); }

double stiffness(double depth) { return force(depth) / depth * (1.5 + hardness.slope_at(std::log(depth))); }

double radius(double depth) { return std::sqrt(depth * std::exp(area.at(std::log(depth)))); }

double work(double depth) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const double x = std::log(depth), last = std::min(x, hardness.end());
  const auto integrand = [](double at) { return force(std::exp(at)) * std::exp(at); };
  double sum = 0.4;
  constexpr int panels = 4;
  for (int i = 0; i < panels; ++i) sum += Rule::integrate(integrand, last * i / panels, last * (i + 1) / panels);
  if (x == last) return sum;
  const double power = 2.5 + hardness.slope_at(last);  // of f d beyond
  return sum + integrand(last) * std::expm1(power * (x - last)) / power;
}

Unloading unloading(double deepest) {
  const double x = std::log(deepest), recovers = deepest * std::exp(way.at(x)), most = force(deepest);
  const double back = work(deepest) * std::exp(regained.at(x));
  return {deepest - recovers, most * recovers / back - 1.0, most * most / (recovers * recovers * recovers)};
}

}  // namespace fits

}  // namespace

double loading_force(YieldLaw law, double depth) {
  require_depth("depth", depth);
  if (depth <= 1.0) return depth * std::sqrt(depth);
  return law == YieldLaw::thornton_ning ? capped_force(depth) : fits::force(depth);
}

double loading_stiffness(YieldLaw law, double depth) {
  require_depth("depth", depth);
  if (depth <= 1.0) return 1.5 * std::sqrt(depth);
  return law == YieldLaw::thornton_ning ? 1.5 : fits::stiffness(depth);
}

double loading_radius(YieldLaw law, double depth) {
  require_depth("depth", depth);
  if (depth <= 1.0 || law == YieldLaw::thornton_ning) return std::sqrt(depth);
  return fits::radius(depth);
}

double loading_work(YieldLaw law, double depth) {
  require_depth("depth", depth);
  if (depth <= 1.0) return 0.4 * depth * depth * std::sqrt(depth);
  return law == YieldLaw::thornton_ning ? capped_work(depth) : fits::work(depth);
}

Unloading unloading(YieldLaw law, double deepest) {
  require_depth("deepest", deepest);
  if (deepest <= 1.0) return {};
  return law == YieldLaw::thornton_ning ? capped_unloading(deepest) : fits::unloading(deepest);
}

double unloading_work(YieldLaw law, double deepest) {
  const Unloading back = unloading(law, deepest);
  return loading_force(law, deepest) * (deepest - back.residual) / (back.exponent + 1.0);
}

double plastic_restitution(YieldLaw law, double speed_ratio) {
  require_speed_ratio(speed_ratio);
  if (speed_ratio <= 1.0) return 1.0;
  const double work = 0.4 * speed_ratio * speed_ratio;
  const auto excess = [&](double depth) { return loading_work(law, depth) - work; };
  // With p₀ kept or growing the compression is less than V/V_y: f ≥ 1 + 3/2 (d − 1), and 0.7 times that of the fits.
  const double highest = 2.0 * speed_ratio;
  constexpr int bits = 50;
  std::uintmax_t steps = 200;
  const auto ends = boost::math::tools::toms748_solve(excess, 1.0, highest, excess(1.0), excess(highest),
                                                      boost::math::tools::eps_tolerance<double>(bits), steps);
  const double depth = 0.5 * (ends.first + ends.second);
  return std::sqrt(unloading_work(law, depth) / loading_work(law, depth));
}

double fully_plastic_restitution(double speed_ratio) {
  require_speed_ratio(speed_ratio);
  constexpr double pressure = 3.0 / yield_pressure_ratio;  // p_d over p₀ at the onset
  static const double square = 2.4 * pressure * std::pow(15.0 / 16.0 * pressure, 0.25);
  return speed_ratio <= square * square ? 1.0 : std::sqrt(square / std::sqrt(speed_ratio));
}

}  // namespace stoss::quasistatic
