#include "encounter/seismogram/pulse_loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {

double Course::operator()(double at) const {
  const std::size_t count = time_.size();
  const double step = (time_.back() - time_.front()) / static_cast<double>(count - 1);
  const double place = (at - time_.front()) / step;
  if (!(place > 0.0) || place >= static_cast<double>(count - 1)) return 0.0;
  const auto i = std::min(static_cast<std::size_t>(place), count - 2);
  const double x = place - static_cast<double>(i), y = 1.0 - x;
  const double left = i > 0 ? 0.5 * (value_[i + 1] - value_[i - 1]) : value_[1] - value_[0];
  const double right = i + 2 < count ? 0.5 * (value_[i + 2] - value_[i]) : value_[i + 1] - value_[i];
  return value_[i] * y * y * (1.0 + 2.0 * x) + value_[i + 1] * x * x * (1.0 + 2.0 * y) + x * y * (y * left - x * right);
}

namespace {

using Numbers = std::vector<double>;

/// Three means over so many steps: what a force has of the steps and of the cutoff of its impact would be the most of a
/// velocity.
Numbers smoothed(const Numbers& of, std::size_t width) {
  Numbers its = of, sum(of.size() + 1);
  const std::size_t half = width / 2;
  for (int pass = 0; pass < 3; ++pass) {
    for (std::size_t j = 0; j < its.size(); ++j) sum[j + 1] = sum[j] + its[j];
    for (std::size_t j = 0; j < its.size(); ++j) {
      const std::size_t begin = j < half ? 0 : j - half, end = std::min(its.size(), j + half + 1);
      its[j] = (sum[end] - sum[begin]) / static_cast<double>(width);
    }
  }
  return its;
}

}  // namespace

double duration_of(const Pulse& pulse) {
  constexpr double whole_by_rise = 2.5;
  return std::min(pulse.contact_time.value, whole_by_rise * pulse.rise.value);
}

PulseLoads loads_of(const Pulse& pulse, double until, int points, const OwnUnits& units) {
  constexpr double steps = 400.0, most = 4e6;
  PulseLoads all;
  all.duration = duration_of(pulse) / units.time;
  const double interval = until / units.time / (points - 1);
  const double stride = std::ceil(interval * steps / all.duration);
  if (!(stride * points < most)) {
    throw InvalidInput::out_of_range("until", rounded(until), "an earlier one", "some 10000 times that of the contact");
  }
  all.instants.stride = static_cast<std::size_t>(stride);
  all.instants.step = interval / stride;
  all.instants.outputs = static_cast<std::size_t>(points);
  const double step = all.instants.step * units.time, begin = pulse.time.front(), end = pulse.time.back();
  constexpr double margin = 9.0;  // for the means
  all.instants.before = static_cast<std::size_t>(std::ceil(std::max(0.0, -begin) / step) + margin);
  const double after = std::ceil(end / step) + margin;
  if (!(after < most)) throw InvalidInput::out_of_range("points", std::to_string(points), "fewer, or a later `until`");
  const std::size_t count = all.instants.before + static_cast<std::size_t>(after);
  const Course force(pulse.time, pulse.force), change(pulse.time, pulse.force_change);
  Numbers forces(count), changes(count), radii(count);
  for (std::size_t j = 0; j < count; ++j) {
    const double time = step * (static_cast<double>(j) - static_cast<double>(all.instants.before));
    forces[j] = force(time), changes[j] = change(time) / units.force;
    radii[j] = pulse.finest.max_half_width / units.length *
               std::cbrt(std::clamp(forces[j] / pulse.peak_force.value, 0.0, 1.0));
    forces[j] /= units.force;
  }
  constexpr std::size_t fine = 3, coarse = 5;
  const Numbers smooth = smoothed(forces, fine);
  all.all = {
      {{smooth, radii}, {smooth, Numbers(count)}, {smoothed(changes, fine), radii}, {smoothed(forces, coarse), radii}}};
  return all;
}

}  // namespace stoss
