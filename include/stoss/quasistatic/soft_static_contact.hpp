#pragma once

#include <optional>
#include <string>

#include "stoss/contact/contact.hpp"
#include "stoss/poll.hpp"

namespace stoss::quasistatic {

/// Resolution of a static contact with an exponential wall.
struct SoftStaticContactOptions {
  std::optional<int> nodes{};  ///< of the contact grid, 64 … 2048; otherwise as many as the wall and the modes need
  Poll poll{};
};

/// A body held at rest in front of an exponential wall.
struct SoftStaticContact {
  std::string body;
  ExponentialWall wall;
  double compression = 0.0;  ///< δ beyond the plane V₀e^{αx} = 1, R
  double force = 0.0;        ///< F, πRE = mc²/R for a disk
  double energy = 0.0;       ///< of modes and wall, mc²; dU/dδ = F
  double wall_energy = 0.0;  ///< share of the wall's potential in it, mc²
  int modes = 0;
  int nodes = 0;
  int newton_steps = 0;
};

/// Static contact of a body with an exponential wall, as the paper computes it (section V): with
/// the centre of mass held, the modes of the body take the coordinates that minimise the energy,
///
///   U = Σ ½mω²Q² + V₀ ∫_{−π/2}^{π/2} e^{αx(φ)} dφ,   x(φ) = x₀ + cos φ + Σ Q (C c + S s)(φ).
///
/// Modes above the body's cutoff are left out. As in Impact::max_compression the compression counts from the plane
/// V₀e^{αx} = 1 (an energy ρc²R² per radian), δ = R + x₀ + ln V₀/α, so that V₀ has no effect. A pressure p (in E)
/// stands ln(α/p)/α before that plane: 0.017 R for αR = 500 and p = 0.1, by which a hard wall is farther away.
///
/// The energy is convex. Newton's method finds its minimum, with the node forces as unknowns, which determine the
/// modes, at walls of increasing hardness. At the end the forces that hold the modes and those of the wall agree to
/// 2e-12 of the sum (2e-9 for α = 1e6).
/// @param body        with its kept modes: a disk with cutoff 54 has 1300 at ν = 0.33
/// @param compression δ, −0.5 … 0.5 R
/// @throws InvalidInput for arguments out of range; NotConverged if Newton's method does not find the minimum
[[nodiscard]] SoftStaticContact soft_static_contact(const Body& body, const ExponentialWall& wall, double compression,
                                                    const SoftStaticContactOptions& options = {});

}  // namespace stoss::quasistatic
