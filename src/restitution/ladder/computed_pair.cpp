// Which part of each body is computed: one much larger or slower than the other is its near side.
#include "restitution/ladder/computed_pair.hpp"

#include <algorithm>
#include <utility>

#include "contact/unit_ratios.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

/// The near side of a body stands for it where the whole has at least twice its size, as it is faster to compute from
/// there on (to a tolerance of 1e-3), or where the whole has too many modes.
constexpr double least_surplus = 2.0;

/// Least size of the part, in what waves of the speed c travel within time_scale.
constexpr double least_size = 16.0;

/// Time until its first echo, over time_scale, of a part in which pressure waves are much faster; else it is longer, 60
/// at ν = 0.33. A contact lasts 6 to 8 times time_scale at v > 0.01, and 14 times at 1e-8.
constexpr double least_echo = 36.0;

Contact probed(const BodyMaker& first, const BodyMaker& second) {
  const Body one = first(least_cutoff, {}), other = second(least_cutoff, {});
  require_ratios(one, other);
  constexpr double alike = 1e6;
  const double time = UnitRatios(other, one).time, cutoff = time > alike ? least_cutoff / time : least_cutoff;
  return contact(first(cutoff, {}), second(cutoff * time, {}));
}

/// @param unit of time of the body, over time_scale
double computed_size(const Body& body, double unit) {
  if (is_unbounded(body)) return shortest_contact / unit;
  if (!body.near_side) return 1.0;
  const double largest = body.highest_cutoff / cutoff_at(fewest_levels - 1) / unit;
  const double echo = body.near_side(1.0, least_cutoff, {}).part.echo;
  const double size = std::min(std::max(least_size, least_echo / echo) / unit, largest);
  return size < (largest < 1.0 ? 1.0 : 1.0 / least_surplus) ? size : 1.0;
}

/// The part of a body, or the body.
Body made(const BodyMaker& maker, const Body& probe, double size, double cutoff, const Poll& poll) {
  return size < 1.0 || is_unbounded(probe) ? probe.near_side(size, cutoff, poll) : maker(cutoff, poll);
}

/// c₀ of a body of which only a point is known: what the compliance of a ring has beside what falls with its radius.
double yielding_of(const Body& body) {
  constexpr double small = 0.05;
  const auto compliance = [&](double radius) {
    return body.residual_compliance({.radius = 1.0, .spacing = 2.0 * radius, .count = 1}, {}).front();
  };
  return std::max(0.0, 2.0 * compliance(2.0 * small) - compliance(small));
}

}  // namespace

Pair pair_of(const BodyMaker& first, const BodyMaker& second) {
  Pair pair{first, second, probed(first, second)};
  const double unit = time_scale(pair.probe);
  pair.first_size = computed_size(*pair.probe.first, 1.0 / unit);
  pair.second_size = computed_size(*pair.probe.second, UnitRatios(*pair.probe.second, *pair.probe.first).time / unit);
  if (is_known_at_a_point(*pair.probe.first) && is_unbounded(*pair.probe.second)) {
    pair.yielding = yielding_of(*pair.probe.first);
  }
  return pair;
}

double pair_duration(const Pair& pair, double speed) {
  // A hollow body is a spring, half of whose period lasts longer than its contact would by Hertz.
  const double of_shape = std::numbers::pi * std::sqrt(pair.probe.mass * pair.yielding);
  return std::max(stoss::expected_duration(pair.probe, speed), of_shape) / time_scale(pair.probe);
}

Contact pair_contact(const Pair& pair, double cutoff, double stretch, const Poll& poll) {
  const auto size = [stretch](const Body& body, double usual) {
    if (is_unbounded(body)) return usual * stretch;
    return usual < 1.0 ? std::min(usual * stretch, 1.0) : 1.0;
  };
  const double time = UnitRatios(*pair.probe.second, *pair.probe.first).time;
  return contact(
      made(pair.first, *pair.probe.first, size(*pair.probe.first, pair.first_size), cutoff, poll),
      made(pair.second, *pair.probe.second, size(*pair.probe.second, pair.second_size), cutoff * time, poll));
}

double whole_cutoff(const Pair& pair) {
  const Body &one = *pair.probe.first, &other = *pair.probe.second;
  return std::min(one.highest_cutoff, other.highest_cutoff / UnitRatios(other, one).time);
}

double pair_cutoff(const Pair& pair) {
  const Body &one = *pair.probe.first, &other = *pair.probe.second;
  if (is_unbounded(other)) return one.highest_cutoff / pair.first_size;  // depends on the duration: highest_level
  return std::min(one.highest_cutoff / pair.first_size,
                  other.highest_cutoff / pair.second_size / UnitRatios(other, one).time);
}

}  // namespace stoss
