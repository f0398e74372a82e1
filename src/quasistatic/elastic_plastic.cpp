#include "stoss/quasistatic/elastic_plastic.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "check.hpp"
#include "quasistatic/plastic_fits.hpp"
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
