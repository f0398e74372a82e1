#pragma once

#include "stoss/quasistatic/point_hertz.hpp"

/// Impact of round bodies of a lossy material, stress = (1 + η∂_t) elastic stress (Kelvin and Voigt, one loss time η
/// for all moduli), where nothing but the contact dissipates. With Hertz' elastic force kδ^{3/2}
///
///   growing contact     a² = δR,         F = k(δ^{3/2} + (3/2) η √δ δ̇)
///   shrinking contact   a² = (δ+ηδ̇)R,    F = k(δ + ηδ̇)^{3/2}             (T. C. T. Ting, J. Appl. Mech. 33, 845, 1966)
///
/// (docs/theory/points.md). ε depends on one number, x = (3/2) η (k/m)^{2/5} v^{1/5}:
///
///   ε = 1 − c₁x + c₂x² + O(x³),   c₁ = (4/5)(5/4)^{3/5} B(3/5, 3/2) = 1.153449,   c₂ = ⅗c₁² + (5/18)(5/4)^{1/5}.
namespace stoss::quasistatic {

/// Force of a lossy contact that shrinks.
enum class LossyLaw {
  ting,  ///< the pressure vanishes at the edge, the surface lags behind: exact for a Kelvin-Voigt half-space
  point  ///< as if it grew, until F = 0: the force between points of N. V. Brilliantov and others (1996); c₂ = ⅗c₁²
};

/// What a lossy contact knows of the bodies, in units of one of them: R, c, ρ and E. A ball at a hard wall is
/// {{1, 1 − ν²}, 4π/3, η}.
struct LossyContact {
  PointPair pair;
  double mass = 1.0;       ///< reduced mass, ρR³
  double loss_time = 0.0;  ///< η, R/c
};

/// An impact of lossy round bodies, with the inputs that made it. Relative errors below 1e-13.
struct LossyImpact {
  LossyLaw law{};
  LossyContact contact;
  double speed = 0.0;            ///< v, c
  double loss_number = 0.0;      ///< x = (3/2) η (k/m)^{2/5} v^{1/5}
  double restitution = 0.0;      ///< ε
  double contact_time = 0.0;     ///< from first contact to F = 0, R/c
  double max_compression = 0.0;  ///< R
};

/// Impact of lossy round bodies by one of the laws. It leaves out waves and, as Hertz does, that a contact is no point:
/// for a ball at a wall 1 − ε is low by 1.3 % at v = 1e-4 and by 10 % at 0.01, ν = 0.3 (as viscous_loss says).
/// @param speed of approach, 1e-100 to 1e100 c
/// @throws InvalidInput outside this range, for a pair as point_hertz (its curvature and softness above 0), for a mass
///         outside 1e-100 … 1e100, a negative loss time, and where x is above 1e6
[[nodiscard]] LossyImpact lossy_impact(LossyLaw law, const LossyContact& contact, double speed);

}  // namespace stoss::quasistatic
