#pragma once

#include "stoss/quasistatic/compression.hpp"

namespace stoss::quasistatic {

/// 1 − ε of a disk of a lossy material at a hard wall, to first order of its loss time η: stress = (1 + η∂_t) elastic
/// stress (Kelvin and Voigt).
///
/// The strain rates are those of a contact of fixed width, so that the power lost is η δ̇² dF/dδ, and with δ̈ = −F/m
///
///   1 − ε = η∫F² dt/(m²v²) = (2η/√A) ∫₀¹ √(1 − f² (1 − ln f/A)) df
///         = (πη/2√A) [1 − (2 ln 2 − 1)/4A + O(A⁻²)],   A − ½ ln A = ln(F*/v) + ½
///
/// in units of R and c, with the A and F* of slow_impact (docs/theory/quasistatic.md): as v → 0 the loss falls only
/// like 1/√ln(1/v). The integral is good to 1e-13. The loss of the elastic disk comes on top, and the damping of the
/// modes that ring changes the sum: at ν = 0.33 by about 2 % of this at v = 1e-8, by up to 18 % at 1e-4 and 1e-3.
/// @param loss_time η, 0 to 1000 R/c; the next order is about the square of the result
/// @param speed     min_slow_speed … limit_speed(law, poisson), c
/// @throws InvalidInput outside these ranges and for a Poisson's ratio out of range
[[nodiscard]] double viscous_loss(CompressionLaw law, double poisson, double loss_time, double speed);

}  // namespace stoss::quasistatic
