#include "restitution/pulse_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/touch.hpp"

namespace stoss {

double ForceHistory::at(double instant) const {
  if (time.empty() || instant <= time.front() || instant >= time.back()) return 0.0;
  const double place = (instant - time.front()) / step;
  const auto i = std::min(static_cast<std::size_t>(place), time.size() - 2);
  const double share = place - static_cast<double>(i);
  return force[i] + share * (force[i + 1] - force[i]);
}

ForceHistory ForceHistory::smoothed(double window) const {
  const auto half = static_cast<long>(std::lround(0.5 * window / step));
  ForceHistory made{step, {}, {}};
  std::vector<double> sum{0.0};
  for (long i = -half - 1; i < static_cast<long>(force.size()) + half + 1; ++i) {
    const bool known = i >= 0 && i < static_cast<long>(force.size());
    made.time.push_back(time.front() + step * static_cast<double>(i));
    sum.push_back(sum.back() + (known ? force[static_cast<std::size_t>(i)] : 0.0));
  }
  made.force.resize(made.time.size());
  const long count = static_cast<long>(made.time.size());
  for (long i = 0; i < count; ++i) {
    const long begin = std::max(0L, i - half), end = std::min(count, i + half + 1);
    made.force[static_cast<std::size_t>(i)] =
        (sum[static_cast<std::size_t>(end)] - sum[static_cast<std::size_t>(begin)]) / static_cast<double>(2 * half + 1);
  }
  return made;
}

ForceHistory::Interval ForceHistory::above(double least) const {
  Interval its;
  const auto crossing = [&](std::size_t i) {  // between i and i + 1
    const double rise = force[i + 1] - force[i];
    return time[i] + (rise == 0.0 ? 0.5 : std::clamp((least - force[i]) / rise, 0.0, 1.0)) * step;
  };
  bool begun = false;
  for (std::size_t i = 0; i + 1 < force.size(); ++i) {
    if (!begun && force[i] <= least && force[i + 1] > least) its.begin = crossing(i), begun = true;
    if (force[i] > least && force[i + 1] <= least) its.end = crossing(i);
  }
  return its;
}

double ForceHistory::peak_time() const {
  const auto at = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  if (at == 0 || at + 1 >= force.size()) return time[at];
  const double before = force[at] - force[at - 1], after = force[at] - force[at + 1];
  return time[at] + (before + after > 0.0 ? 0.5 * (before - after) / (before + after) : 0.0) * step;
}

double ForceHistory::impulse(double until) const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < time.size() && time[i] < until; ++i) {
    const double share = std::min(1.0, (until - time[i]) / step);
    sum += step * share * (force[i] + 0.5 * share * (force[i + 1] - force[i]));
  }
  return sum;
}

double ForceHistory::amplitude(double omega) const {
  double real = 0.0, imaginary = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (force[i] == 0.0) continue;
    real += force[i] * std::cos(omega * time[i]);
    imaginary += force[i] * std::sin(omega * time[i]);
  }
  return step * std::hypot(real, imaginary);
}

SpectrumMarks marks(const ForceHistory& history, double duration) {
  SpectrumMarks found;
  if (!(duration > 0.0)) return found;
  const double whole = history.amplitude(0.0), unit = 0.05 * std::numbers::pi / duration;
  const auto at = [&](int k) { return history.amplitude(unit * k); };
  double before = whole, here = at(1);
  for (int k = 1; k < 400; ++k) {
    const double after = at(k + 1);
    const double wanted = whole / std::numbers::sqrt2;
    if (found.corner == 0.0 && here <= wanted) {
      found.corner = unit * (k - 1 + (before - wanted) / (before - here));
    }
    if (here < before && here <= after) {
      const double below = before - here, above = after - here;  // of squares, which are parabolas near a null
      found.null = unit * (k + 0.5 * (below - above) / (below + above));
      return found;
    }
    before = here, here = after;
  }
  return found;
}

ForceHistory hertz_pulse(const Contact& contact, double speed) {
  const Touch met = touch(contact);
  if (!met.circle) return {};
  // m δ̈ = −(4/3) δ^{3/2}/(D √curvature), by Runge and Kutta's method; forces over the mass of the first body.
  const double stiffness = 4.0 / 3.0 / (met.softness * std::sqrt(met.curvature)), mass = contact.whole_mass;
  const double unit = whole_mass(*contact.first);
  const auto force = [&](double depth) { return depth > 0.0 ? stiffness * depth * std::sqrt(depth) : 0.0; };
  const double deepest = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
  ForceHistory made;
  made.step = hertzian_duration * deepest / speed / 2000.0;
  const double step = made.step;
  double depth = 0.0, velocity = speed;
  for (int i = 0; depth >= 0.0 && i < 4000; ++i) {
    made.time.push_back(step * i), made.force.push_back(force(depth) / unit);
    const auto turn = [&](double x) { return -force(x) / mass; };
    const double k1 = turn(depth), k2 = turn(depth + 0.5 * step * velocity),
                 k3 = turn(depth + 0.5 * step * velocity + 0.25 * step * step * k1),
                 k4 = turn(depth + step * velocity + 0.5 * step * step * k2);
    depth += step * velocity + step * step * (k1 + k2 + k3) / 6.0;
    velocity += step * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
  }
  return made;
}

double difference(const ForceHistory& history, const ForceHistory& model) {
  if (model.force.empty()) return std::numeric_limits<double>::quiet_NaN();
  double greatest = 0.0;
  for (std::size_t i = 0; i < model.time.size(); ++i) {
    greatest = std::max(greatest, std::abs(history.at(model.time[i]) - model.force[i]));
  }
  return greatest / *std::max_element(model.force.begin(), model.force.end());
}

double difference_from_sine(const ForceHistory& history, const ForceHistory::Interval& contact) {
  const double peak = *std::max_element(history.force.begin(), history.force.end());
  double greatest = 0.0;
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    const double phase = (history.time[i] - contact.begin) / contact.length();
    const double sine = phase > 0.0 && phase < 1.0 ? std::pow(std::sin(std::numbers::pi * phase), 1.5) : 0.0;
    greatest = std::max(greatest, std::abs(history.force[i] / peak - sine));
  }
  return greatest;
}

}  // namespace stoss
