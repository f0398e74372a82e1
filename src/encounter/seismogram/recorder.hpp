#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bodies/surface/pressed.hpp"
#include "stoss/encounter/seismogram.hpp"
#include "stoss/encounter/solid.hpp"

/// How a half-space or a plate moves a receiver, in its own units.
namespace stoss::ground {

/// What acts on it in an impact: its force on its circle, the same on a point, how the force has changed last, and the
/// force with less of what is fast.
enum Kind : std::size_t { whole, point, change, coarse };
using Loads = std::array<bodies::PressedLoad, 4>;

/// What loads move a receiver by.
struct Recorded {
  std::vector<bodies::Motion> motions;  ///< of each load
  bodies::Motion unresolved;            ///< what waves near the cutoff, which is left out, would add to the first

  [[nodiscard]] const bodies::Motion& of(Kind kind) const { return motions[kind]; }
};

/// @param duration of a single contact @throws InvalidInput where more waves would be needed than are computed
[[nodiscard]] Recorded recorded(const Solid& solid, const Receiver& receiver, const bodies::Instants& instants,
                                const Loads& loads, double duration, const Poll& poll);

/// Time of the first wave to the receiver, straight.
[[nodiscard]] double arrival(const Solid& solid, const Receiver& receiver);

/// Time after which all waves have passed the receiver, of a plate with its first echoes.
[[nodiscard]] double passing_time(const Solid& solid, const Receiver& receiver);

}  // namespace stoss::ground
