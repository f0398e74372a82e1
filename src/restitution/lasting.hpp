#pragma once

#include <numbers>

#include "impact/whole_bodies.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

inline constexpr double room_to_last = 1.5;  // of a half-space, over what is expected of the contact

/// The same where the time follows from a law that is rough.
inline constexpr double room_on_a_plate = 2.9;

/// compute(contact) with the contact at a cutoff; with a half-space made anew for a longer time where an impact
/// outlasts it. @param stretch of the half-space (RefinableContact::stretch); becomes greater
template <typename Compute>
auto to_its_end(const RefinableContact& contact, double cutoff, double& stretch, const Poll& poll,
                const Compute& compute) {
  const double start = stretch / std::numbers::sqrt2;
  for (;; stretch *= std::numbers::sqrt2) {
    const Contact& resolved = contact.at(cutoff, stretch, poll);
    try {
      return compute(resolved);
    } catch (const Outlasted&) {
      const double room = resolved.gives_way ? room_on_a_plate : room_to_last;
      if (!resolved.unbounded || stretch > room * start) throw;
    }
  }
}

}  // namespace stoss
