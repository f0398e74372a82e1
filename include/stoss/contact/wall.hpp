#pragma once

#include <variant>

#include "stoss/cxx20.hpp"

namespace stoss {

/// A rigid wall at x = 0: no node passes it, pressure ≥ 0, and their product is 0 (Signorini).
struct HardWall {};

/// A rigid wall with a rough face, whose elastic asperities push with the pressure αV₀ e^{αx} at a depth x: the paper's
/// soft wall (its eq. (40)), of asperities of the length u₀ = 1/α. Pressure acts on the projected area.
struct ExponentialWall {
  double hardness = 500.0;  ///< α, 1/R; 1 … 1e8
  double strength = 1.0;    ///< V₀, ρc²R; shifts the wall by ln V₀/α and changes nothing else
};

/// How the modes above the cutoff answer (docs/theory/walls.md).
enum class Tail {
  quasistatic,  ///< exact static compliance; stores energy, loses none ("static" on the command line)
  radiating,    ///< static compliance at low and plane-wave impedance at high frequency; absorbs energy
  none          ///< not at all, as in the paper, whose wall pushes on the length of the edge: for rough faces alone
};

using Wall = std::variant<HardWall, ExponentialWall>;

/// Checks the constants of a wall. @throws InvalidInput for a hardness or strength out of range
void validate(const Wall& wall);

}  // namespace stoss
