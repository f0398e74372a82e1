#pragma once

#include <vector>

#include "impact/kept_modes.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/impact/state.hpp"

namespace stoss {

/// Bodies that part.
struct Parting {
  double compression = 0.0;  ///< the approach of their undeformed shapes, less than 0 when they are apart
  double velocity = 0.0;     ///< its rate, less than 0
  double range = 0.0;        ///< distance within which nodes feel each other
};

/// Time after which bodies that part, and vibrate freely, stay out of range of each other. They are looked at every
/// step Δt of the modes; between two looks no node is further on than at both by more than ⅛ Δt² times the bound of its
/// acceleration. Where that takes too many looks, the time after which no phase of the modes could bridge the distance.
/// @param modes  at the start, with no force due
/// @param recess of the nodes
[[nodiscard]] double time_to_part(KeptModes modes, const std::vector<double>& recess, const Parting& parting);

/// Time before a touch at which bodies that vibrate freely are still clear of each other, and have been before. In a
/// lossy material, and where only a part of a body is there, no phase of the modes bridges the distance that is left.
/// @param touch when the unexcited bodies would touch; its velocity is that of the approach
[[nodiscard]] double time_before_touch(const Contact& contact, const State& touch);

}  // namespace stoss
