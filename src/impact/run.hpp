#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "contact/demands.hpp"
#include "contact/ending.hpp"
#include "impact/ending.hpp"
#include "impact/inputs.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/resolution.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// Steps in which bodies that vibrate, and part so slowly that they have not yet cleared each other, will have done so.
template <typename Motion>
double steps_to_leave(const Motion& motion, double step) {
  const double velocity = motion.velocity();
  if (velocity >= 0.0 || motion.vibration() < motion.translation()) return 0.0;
  return std::max(0.0, (motion.compression() + motion.clearance()) / (-velocity * step));
}

/// Moves two bodies step by step until they have parted, or one stays on what gives way.
/// @param motion `Collision` or `CoupledCollision`, at the start
/// @param watch  called after each step
/// @returns whether and how a body stays; empty if the contact outgrew the grid, so that all is void
/// @throws NotConverged if the impact does not end, and for a contact that spreads over the whole body; Outlasted
template <typename Motion, typename Watch>
std::optional<Rest> run(const Contact& contact, double speed, const FixedResolution& resolution, const Poll& poll,
                        Motion& motion, const Watch& watch) {
  const double step = resolution.step;
  const Ending its = ending(contact);
  const double flight = std::max(0.0, -motion.compression()) + 4.0 * motion.clearance();
  double steps = (its.longest + flight / speed) / step;
  if (steps > most_steps) {
    throw NotConverged("impact: would take more than " + std::to_string(static_cast<long>(most_steps)) + " steps",
                       "step", "use a larger step, or a hard wall instead of an exponential one");
  }
  Rest rest(contact, speed, steps);
  for (long done = 1; !motion.over(); ++done) {
    if (static_cast<double>(done) > steps) {
      if (rest.ends(motion.slowing())) break;
      if (its.is_given_up) throw Outlasted(static_cast<double>(done) * step, its.known);
      steps += steps_to_leave(motion, step);
    }
    if (static_cast<double>(done) > std::min(steps, most_steps)) {
      const bool held = contact.second && contact.second->held;
      throw NotConverged("impact: the contact has not ended after " + std::to_string(done) + " steps" +
                         (held ? ": what is held swings back to what hit it, again and again (a stiffer hold, or a "
                                 "lighter body that hits it)"
                               : ""));
    }
    if (poll) poll();
    motion.advance();
    rest.watch(done, [&] { return motion.slowing(); });
    if (motion.overflows()) {
      if (resolution.half_width < greatest_half_width(contact)) return std::nullopt;
      if (pushing_gap(contact) == 0.0) {
        throw NotConverged("impact: the contact spreads over the whole body (speed too high for this model)");
      }
    }
    watch(done);
  }
  return rest;
}

/// Tries again on wider grids until the contact does not outgrow them. @param resolution in: of the first try; out: of
/// the last
template <typename Try>
auto on_a_grid_that_suffices(const Contact& contact, FixedResolution& resolution, const Try& attempt) {
  auto result = attempt(resolution);
  while (!result) {
    resolution = widened(contact, resolution);
    result = attempt(resolution);
  }
  return *std::move(result);
}

}  // namespace stoss
