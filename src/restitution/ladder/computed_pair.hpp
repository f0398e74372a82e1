#pragma once

#include <cmath>
#include <numbers>

#include "stoss/contact/contact.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// Below the modes of all bodies: at this cutoff one can be asked what it is by itself.
inline constexpr double least_cutoff = 1e-6;

inline constexpr int fewest_levels = 10;  // for an error

/// Of a level, over 1/time_scale.
[[nodiscard]] inline double cutoff_at(int level) { return 4.0 * std::numbers::sqrt2 * std::exp2(0.25 * level); }

/// Duration of the shortest contacts with a half-space, over time_scale.
inline constexpr double shortest_contact = 6.0;

/// Two bodies that meet, and which part of each is computed.
struct Pair {
  BodyMaker first, second;
  Contact probe;                               // without modes
  double first_size = 1.0, second_size = 1.0;  // of the parts that are computed
  double yielding = 0.0;  // compliance by the shape of a first body that is known at a point, where it is large
};

[[nodiscard]] Pair pair_of(const BodyMaker& first, const BodyMaker& second);

/// Of a contact, over time_scale.
[[nodiscard]] double pair_duration(const Pair& pair, double speed);

/// @param stretch of the part, where there is one; it ends with the whole
[[nodiscard]] Contact pair_contact(const Pair& pair, double cutoff, double stretch, const Poll& poll);

/// Highest cutoff of both bodies as wholes, c/R of the first.
[[nodiscard]] double whole_cutoff(const Pair& pair);

/// Highest cutoff of both bodies or of their parts, c/R of the first.
[[nodiscard]] double pair_cutoff(const Pair& pair);

}  // namespace stoss
