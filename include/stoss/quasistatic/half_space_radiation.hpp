#pragma once

#include "stoss/quasistatic/slow_impact.hpp"

/// Loss of a slow ball to an elastic half-space, which carries it away as waves.
///
/// All waves are long against the contact, so that a force F that varies radiates the energy D∫Ḟ² dt, D =
/// C(ν₂)/(ρ₂c_s³) (C in docs/theory/half_space.md). With the pulse of F of a slow impact that is a share
///
///   w(v) = (2D/mv²) ∫Ḟ² dt → k (v/c)^{3/5}
///
/// of the energy. It slows the rebound, and the force with it. With D for −D the motion runs backwards, from the energy
/// after the impact to that before: up to the order D² the loss is therefore that of the pulse of the *mean* energy,
///
///   1 − ε² = λ,   λ = (1 − ½λ) w(v√(1 − ½λ))   (= w − 0.65w² + O(w³) for the power law).
namespace stoss::quasistatic {

/// A ball and the elastic half-space that it meets. E₂ and ρ₂ are in E and ρ of the ball, which set the units.
struct BallOnHalfSpace {
  double poisson = 0.0;             ///< ν of the ball, −0.95 … 0.4999; without effect where it is rigid
  bool rigid = false;               ///< the ball does not yield; E and ρ still set the units, and ρ its mass
  double half_space_poisson = 0.0;  ///< ν₂ of the half-space, −0.95 … 0.4999
  double young = 1.0;               ///< E₂, 1e-3 … 1e6
  double density = 1.0;             ///< ρ₂, 1e-3 … 1e3
};

/// k of 1 − ε² → k (v/c)^{3/5} as v → 0: (15π/2) B(4/5, 3/2) D (5πS/4)^{−6/5} with the softness S = 1/E* of both.
///
/// 1.132 for ball and half-space of one material with ν = 0.3, 2.600 for a rigid ball. The law itself is 2 % low at
/// v = 1e-4 and 9 % low at v = 0.01, where half_space_radiation is better.
/// @throws InvalidInput outside the ranges of BallOnHalfSpace
[[nodiscard]] double radiation_constant(const BallOnHalfSpace& bodies);

/// Highest speed that half_space_radiation accepts, in c, at which the law of the ball's compression ends.
/// @throws InvalidInput outside the ranges of BallOnHalfSpace
[[nodiscard]] double limit_speed(PointLaw law, const BallOnHalfSpace& bodies);

/// Loss of a slow ball to a half-space, with the inputs that made it. Compression, force, radius and contact time are
/// those of the pulse of the mean energy.
struct HalfSpaceRadiation {
  PointLaw law{};
  BallOnHalfSpace bodies;
  double speed = 0.0;                ///< v, c
  double lost_fraction = 0.0;        ///< 1 − ε², λ above
  double lost_fraction_error = 0.0;  ///< what the theory leaves out: λ [(a_m/R)² + λ² + (v/(a_m c_s))²]
  double first_order = 0.0;          ///< w
  double contact_time = 0.0;         ///< R/c
  double max_compression = 0.0;      ///< approach of the centre of mass to the distant half-space, R
  double max_force = 0.0;            ///< mc²/R
  double max_radius = 0.0;           ///< a_m of the contact, R
  bool beyond_perturbation = false;  ///< the error is above a tenth of the loss
};

/// Loss of a slow ball to an elastic half-space. What the ball itself keeps as vibration is not in it: a share of about
/// v/c (docs/theory/points.md).
///
/// At ν = 0.3, one material, with the law of the centre, it differs from the full solution by 0.00, 0.4, 2.3 and 21 %
/// at v = 1e-4, 1e-3, 0.01 and 0.1 (rigid ball: 0.01, 0.08, 0.7, 5 %).
/// @param law   that of the ball's own compression. A rigid ball has Hertz' contact in either case
/// @param speed v, min_point_speed to limit_speed(law, bodies), c
/// @throws InvalidInput outside these ranges
[[nodiscard]] HalfSpaceRadiation half_space_radiation(PointLaw law, const BallOnHalfSpace& bodies, double speed);

}  // namespace stoss::quasistatic
