#pragma once

#include <limits>
#include <vector>

#include "row/solid.hpp"

namespace stoss {

inline constexpr long never = std::numeric_limits<long>::max();

/// Two neighbours that fly freely, lengths in R of the first of them.
struct Flight {
  const RowSolid& one;
  Face face;
  const RowSolid* other;              ///< null at a wall
  double length;                      ///< R of the other
  const std::vector<double>& recess;  ///< of the points
  double place;                       ///< overlap of the undeformed faces, beyond where the points begin to feel it
  double stride;                      ///< by which it grows in a step
};

/// Steps in which no point of one face can come to feel the other: until the bodies would meet at the worst phase of
/// all modes or, from there on, by looking ahead as `time_to_part` does; `never` if they part for good.
[[nodiscard]] long steps_apart(const Flight& flight);

}  // namespace stoss
