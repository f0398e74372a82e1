#include "quasistatic/pulse.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <sstream>

#include "check.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

namespace stoss::quasistatic {

double Pulse::time(double u) const {
  const int panels = static_cast<int>(std::ceil(2.0 * u));  // half of one is a third of the way to a singularity
  const auto rate = [this](double place) { return at(place).rate; };
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(rate, u * i / panels, u * (i + 1) / panels);
  }
  return sum;
}

double Pulse::max_force_rate() const {
  // Ḟ = δ̇ dF/dδ rises from 0 to its only maximum and falls to 0.
  const auto negative_rate = [this](double u) {
    const Course here = at(u);
    return -here.velocity * here.stiffness;
  };
  constexpr int bits = 26;  // of the place, and twice as many of the value
  return -boost::math::tools::brent_find_minima(negative_rate, 0.0, end_of_time_, bits).second;
}

template <typename Function>
double Pulse::squared(Function f) const {
  constexpr double step = 0.125;  // the nearest singularities of a sphere are at Im u = π/2
  double sum = 0.0;
  for (int i = 0; i * step < end_of_time_; ++i) {
    const Course here = at(i * step);
    const double value = f(here);
    sum += (i > 0 ? 2.0 : 1.0) * here.rate * value * value;
  }
  return step * sum;
}

double Pulse::squared_force() const {
  return squared([](const Course& here) { return here.force; });
}

double Pulse::squared_force_rate() const {
  return squared([](const Course& here) { return here.velocity * here.stiffness; });
}

Pulse::Nodes Pulse::nodes(double omega) const {
  double fastest = 0.0;
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i) fastest = std::max(fastest, at(end_of_impulse_ * i / samples).rate);
  // The rule is exact but for the part of F e^{iωt} dt/du that oscillates at 2π/step. The phase runs no faster than
  // ω fastest; beyond that the part falls off as an Airy function does, over widths that grow as the cube root, and
  // where ω does not matter, as exp(−0.7 · 2π/step). Both constants are measured, of disks.
  const double phase_rate = omega * fastest;
  const double sampling = phase_rate + 14.0 * std::cbrt(phase_rate) + 50.0;
  const int count = static_cast<int>(std::ceil(end_of_impulse_ * sampling / (2.0 * std::numbers::pi)));
  const double step = end_of_impulse_ / count;
  using Rule = boost::math::quadrature::gauss<double, 7>;
  Nodes result;
  double now = 0.0, stiffness = 0.0;
  const auto pass = [&](double u, double weight) {
    const Course there = at(u);
    const double dt = 0.5 * step * weight * there.rate;
    now += dt;
    stiffness += dt * there.stiffness;
  };
  for (int i = 0; i <= count; ++i) {
    const double u = i * step;
    for (std::size_t k = 0; i > 0 && k < Rule::abscissa().size(); ++k) {
      const double middle = u - 0.5 * step, aside = 0.5 * step * Rule::abscissa()[k];
      pass(middle - aside, Rule::weights()[k]);
      if (k > 0) pass(middle + aside, Rule::weights()[k]);
    }
    const Course here = at(u);
    result.time.push_back(now);
    result.stiffness.push_back(stiffness);
    result.weight.push_back((i > 0 ? 2.0 : 1.0) * step * here.impulse);
  }
  return result;
}

std::unique_ptr<const Pulse> slow_pulse(StaticLaw law, double poisson, double speed) {
  const auto* line = std::get_if<CompressionLaw>(&law);
  const double least = line != nullptr ? min_slow_speed : min_point_speed, limit = limit_speed(law, poisson);
  std::ostringstream allowed;
  allowed.precision(std::numeric_limits<double>::digits10);
  allowed << least << " to " << limit << " = limit_speed(law, poisson)";
  require("speed", speed, {least, limit, true, true, allowed.str()},
          "in units of c; the static law has no force for the energy of a faster body");
  if (line == nullptr) {
    return std::make_unique<const PointPulse>(RadiusLaw(std::get<PointLaw>(law), poisson), speed);
  }
  // ln(limit/speed), for speeds near the limit without cancellation
  const double excess = speed > 0.5 * limit ? std::log1p((limit - speed) / speed) : std::log(limit) - std::log(speed);
  const double depth = solve_fall(0.5, excess);
  const double force = speed / std::sqrt(LinePulse(depth).energy_factor());
  return std::make_unique<const LinePulse>(depth, std::min(force, limit_force(law, poisson)));
}

}  // namespace stoss::quasistatic
