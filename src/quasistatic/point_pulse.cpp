#include "quasistatic/point_pulse.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "check.hpp"
#include "stoss/quasistatic/point_slow_impact.hpp"

namespace stoss::quasistatic {
namespace {

using std::numbers::pi;
constexpr double last_time = 24.0;  // places u beyond which nothing is left of the time and of the impulse
constexpr double last_impulse = 10.0;

/// The phase at a place, 0 … π/2.
double phase_at(double u) { return pi / (1.0 + std::exp(2.0 * u)); }

}  // namespace

PointPulse::PointPulse(PointLaw law, double poisson, double speed) : law_(law, poisson), speed_(speed) {
  const double limit = limit_speed(law, poisson);
  std::ostringstream allowed;
  allowed.precision(std::numeric_limits<double>::digits10);
  allowed << min_point_speed << " to " << limit << " = limit_speed(law, poisson)";
  require("speed", speed, {min_point_speed, limit, true, true, allowed.str()},
          "in units of c; the static law has no force for the energy of a faster sphere");
  greatest_ = law_.at_energy(0.5 * speed * speed);
}

PointPulse::PointPulse(const RadiusLaw& law, double speed)
    : law_(law), speed_(speed), greatest_(law_.at_energy(0.5 * speed * speed)) {}

double PointPulse::place_of(double phase) {
  if (!(phase > 0.0)) return last_time;
  return std::clamp(0.5 * std::log((pi - phase) / phase), 0.0, last_time);
}

double PointPulse::radius(double phase) const {
  const double share = std::sin(phase);
  return std::min(law_.at_energy(0.5 * speed_ * speed_ * share * share), greatest_);
}

PointPulse::Rate PointPulse::rate(double u) const {
  const double phase = phase_at(u), a = radius(phase);
  const double phase_rate = 2.0 * phase * (1.0 - phase / pi);
  return {speed_ * std::sin(phase) / law_.force(a) * phase_rate, a};
}

double PointPulse::time(double u) const {
  const int panels = static_cast<int>(std::ceil(2.0 * u));
  const auto integrand = [this](double at) { return rate(at).time; };
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(integrand, u * i / panels, u * (i + 1) / panels);
  }
  return sum;
}

double PointPulse::contact_time() const { return 2.0 * time(last_time); }

double PointPulse::max_force_rate() const {
  const auto negative_rate = [this](double phase) { return -std::cos(phase) * law_.stiffness(radius(phase)); };
  constexpr int bits = 26;
  return -boost::math::tools::brent_find_minima(negative_rate, 0.0, 0.5 * pi, bits).second;
}

template <typename Function>
double PointPulse::over_pulse(Function f) const {
  constexpr double step = 0.125;  // the nearest singularities are at Im u = π/2
  double sum = 0.0;
  for (int i = 0; i * step < last_time; ++i) {
    const Rate at = rate(i * step);
    sum += (i > 0 ? 2.0 : 1.0) * at.time * f(phase_at(i * step), at.radius);
  }
  return step * sum;
}

double PointPulse::squared_force() const {
  return over_pulse([this](double, double a) { return law_.force(a) * law_.force(a); });
}

double PointPulse::squared_force_rate() const {
  return over_pulse([this](double phase, double a) {
    const double rate = speed_ * std::cos(phase) * law_.stiffness(a);
    return rate * rate;
  });
}

PointPulse::Nodes PointPulse::nodes(double omega) const {
  double fastest = 0.0;
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i) fastest = std::max(fastest, rate(last_impulse * i / samples).time);
  // As for the pulse of a disk: the phase runs no faster than ω fastest, and beyond that the part falls off as an Airy
  // function does.
  const double phase_rate = omega * fastest;
  const double sampling = phase_rate + 14.0 * std::cbrt(phase_rate) + 50.0;
  const int count = static_cast<int>(std::ceil(last_impulse * sampling / (2.0 * pi)));
  const double step = last_impulse / count;
  using Rule = boost::math::quadrature::gauss<double, 7>;
  Nodes result;
  double now = 0.0, stiffness = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double u = i * step;
    for (std::size_t k = 0; i > 0 && k < Rule::abscissa().size(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        if (k == 0 && side > 0.0) continue;  // the middle
        const Rate at = rate(u - 0.5 * step + side * 0.5 * step * Rule::abscissa()[k]);
        const double dt = 0.5 * step * Rule::weights()[k] * at.time;
        now += dt;
        stiffness += dt * law_.stiffness(at.radius);
      }
    }
    const double phase = phase_at(u);
    const double phase_slope = 2.0 * phase * (1.0 - phase / pi);
    result.time.push_back(now);
    result.stiffness.push_back(stiffness);
    result.weight.push_back((i > 0 ? 2.0 : 1.0) * step * std::sin(phase) * phase_slope);
  }
  return result;
}

}  // namespace stoss::quasistatic
