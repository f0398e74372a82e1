#pragma once

#include <variant>

#include "stoss/cxx20.hpp"

namespace stoss {

/// A rigid wall at x = 0: no node passes it, pressure ≥ 0, and their product is 0 (Signorini).
struct HardWall {};

/// The paper's soft wall, potential V = V₀ ∫ dφ e^{αx(φ)} over the front half of the edge, −π/2 to
/// π/2 on a disk (paper eq. (40)), and over the area of the front half of a sphere. Modes above the cutoff are left
/// out.
struct ExponentialWall {
  double hardness = 500.0;  ///< α, 1/R; 1 … 1e6
  double strength = 1.0;  ///< V₀, ρc²R², of a sphere ρc²R; shifts the wall by ln V₀/α and changes nothing else
};

/// How the modes above the cutoff answer a hard contact (docs/theory/walls.md).
enum class Tail {
  quasistatic,  ///< exact static compliance; stores energy, loses none ("static" on the command line)
  radiating     ///< static compliance at low and plane-wave impedance at high frequency; absorbs energy
};

using Wall = std::variant<HardWall, ExponentialWall>;

/// Checks the constants of a wall. @throws InvalidInput for a hardness or strength out of range
void validate(const Wall& wall);

}  // namespace stoss
