#include "quasistatic/pulse.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "check.hpp"

namespace stoss::quasistatic {
namespace {

// Falls ln(F_max/F) beyond which the force adds nothing to the time and to the impulse.
constexpr double end_of_time = 42.0;
constexpr double end_of_impulse = 20.0;

/// (e^{2y} − 1)/y − 2
double excess_slope(double y) {
  if (y > 1e-3) return std::expm1(2.0 * y) / y - 2.0;
  return y * (2.0 + y * (4.0 / 3.0 + y * (2.0 / 3.0 + y * (4.0 / 15.0 + y * (4.0 / 45.0)))));
}

}  // namespace

double solve_fall(double energy_factor, double excess) {
  if (!(excess > 0.0)) return 0.0;
  // The left side is convex and grows, and the start is above the root, so that Newton's iterates descend to it.
  double fall = 2.0 * excess + 2.0 * std::sqrt(excess);
  constexpr int max_steps = 100;
  for (int step = 0; step < max_steps; ++step) {
    const double left = fall - 0.5 * std::log1p(fall / energy_factor);
    const double next = fall - (left - excess) * (energy_factor + fall) / (energy_factor - 0.5 + fall);
    if (!(next < fall)) break;
    fall = std::max(next, 0.0);
  }
  return fall;
}

ForcePulse::ForcePulse(double depth) : depth_(std::max(depth, 1e-14)), width_(std::sqrt(depth_ / (0.5 + depth_))) {}

double ForcePulse::fall_at(double u) const {
  const double x = width_ * std::sinh(u);
  return x * x;
}

double ForcePulse::place_of(double fall) const { return std::asinh(std::sqrt(fall) / width_); }

/// A (e^{2y} − 1 − y/A)/y
double ForcePulse::slope_factor(double y) const { return 2.0 * depth_ + energy_factor() * excess_slope(y); }

/// dt/du
double ForcePulse::rate(double u) const {
  const double y = fall_at(u);
  return 2.0 * width_ * std::cosh(u) * (depth_ + y) / std::sqrt(slope_factor(y));
}

double ForcePulse::fall(double phase) const {
  if (!(phase > 0.0 && phase < std::numbers::pi)) return std::numeric_limits<double>::infinity();
  const double cosine = std::cos(phase);
  // ln(cos θ) = ½ ln(1 + y/A) − y, by whichever of sine and cosine is the more accurate
  const double excess = std::abs(cosine) < 0.5 ? -0.5 * std::log1p(-cosine * cosine) : -std::log(std::sin(phase));
  return solve_fall(energy_factor(), excess);
}

double ForcePulse::time(double fall) const {
  const double end = place_of(std::min(fall, end_of_time));
  const int panels = static_cast<int>(std::ceil(2.0 * end));  // half of one is a third of the way to a singularity
  const auto integrand = [this](double u) { return rate(u); };
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(integrand, end * i / panels, end * (i + 1) / panels);
  }
  return sum;
}

double ForcePulse::contact_time() const { return 2.0 * time(end_of_time); }

double ForcePulse::max_force_rate() const {
  // Ḟ/v = sin θ dF/dδ = sin θ/(D + y) rises from 0 to its only maximum and falls to 0.
  const auto negative_rate = [this](double u) {
    const double y = fall_at(u);
    return -std::sqrt(std::exp(-2.0 * y) * y * slope_factor(y) / energy_factor()) / (depth_ + y);
  };
  constexpr int bits = 26;  // of the place, and twice as many of the value
  return -boost::math::tools::brent_find_minima(negative_rate, 0.0, place_of(end_of_time), bits).second;
}

double ForcePulse::squared_force() const {
  constexpr double step = 0.125;
  double sum = 0.0;
  for (double u = 0.0; fall_at(u) < end_of_impulse; u += step) {
    sum += (u > 0.0 ? 2.0 : 1.0) * rate(u) * std::exp(-2.0 * fall_at(u));
  }
  return step * sum / energy_factor();
}

ForcePulse::Nodes ForcePulse::nodes(double omega) const {
  const double end = place_of(end_of_impulse);
  double fastest = 0.0;
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i) fastest = std::max(fastest, rate(end * i / samples));
  // The rule is exact but for the part of F e^{iωt} dt/du that oscillates at 2π/step. The phase runs no faster than
  // ω fastest; beyond that the part falls off as an Airy function does, over widths that grow as the cube root, and
  // where ω does not matter, as exp(−0.7 · 2π/step). Both constants are measured.
  const double phase_rate = omega * fastest;
  const double sampling = phase_rate + 14.0 * std::cbrt(phase_rate) + 50.0;
  const int count = static_cast<int>(std::ceil(end * sampling / (2.0 * std::numbers::pi)));
  const double step = end / count;
  const double scale = 2.0 * step / std::sqrt(energy_factor());
  const auto integrand = [this](double u) { return rate(u); };
  Nodes result;
  double now = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double u = i * step;
    if (i > 0) now += boost::math::quadrature::gauss<double, 7>::integrate(integrand, u - step, u);
    result.time.push_back(now);
    result.weight.push_back((i > 0 ? scale : 0.5 * scale) * std::exp(-fall_at(u)) * rate(u));
  }
  return result;
}

ForcePulse slow_pulse(CompressionLaw law, double poisson, double speed) {
  const double limit = limit_speed(law, poisson);
  std::ostringstream allowed;
  allowed.precision(std::numeric_limits<double>::digits10);
  allowed << min_slow_speed << " to " << limit << " = limit_speed(law, poisson)";
  require("speed", speed, {min_slow_speed, limit, true, true, allowed.str()},
          "in units of c; the static law has no force for the energy of a faster disk");
  // ln(limit/speed), for speeds near the limit without cancellation
  const double excess = speed > 0.5 * limit ? std::log1p((limit - speed) / speed) : std::log(limit) - std::log(speed);
  return ForcePulse(solve_fall(0.5, excess));
}

}  // namespace stoss::quasistatic
