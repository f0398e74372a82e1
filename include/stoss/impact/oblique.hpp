#pragma once

#include <memory>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/oblique_snapshot.hpp"

namespace stoss {

/// How two surfaces meet that move along each other, in units of the first body.
///
/// The axis x points along the normal, from the first body towards what it meets, and y along the surface; all motion
/// is in this plane. Spins count about z = x × y, so that a positive spin of the first body moves its foremost point
/// along +y, and a positive spin of the second moves its own along −y. The point of the first body that touches slides
/// over what it meets at
///
///   s = v_t + Ω₁R₁ + Ω₂R₂,
///
/// and friction q that acts against +y on the first body, and along +y on the second, takes from all three:
///
///   μ_r v̇_t = −Σ q,   I₁Ω̇₁ = −Σ q R₁,   I₂Ω̇₂ = −Σ q R₂,   μ_r = m₁m₂/(m₁ + m₂).
///
/// Of a body by its modes, R and I are those with which friction turns it, and m the whole mass (PointTangent).
///
/// Turning leaves a round surface where it is. Points beside the foremost one have an arm a little shorter than R
/// (linear kinematics, docs/theory/oblique.md). The contact stays where it is on each body, which takes angles far
/// below a/R during the contact (ObliqueImpact::turned).
struct Obliquity {
  double tangential = 0.0;   ///< v_t: velocity of the centre of the first body along y relative to the second, c
  double spin = 0.0;         ///< Ω₁ of the first body, c/R
  double second_spin = 0.0;  ///< Ω₂ of the second body, c/R of the first; 0 at a wall and of a half-space
  double friction = 0.0;     ///< μ of Coulomb's law, 0 … 5
};

/// Where the energy is after an oblique impact, as shares of what there was before: of all motion relative to the
/// common centre of mass, of the spins and of the vibration. The sum is 1 but for energy_error.
struct ObliqueLedger {
  double translation = 0.0;       ///< along the normal
  double across = 0.0;            ///< along the surface
  double rotation = 0.0;          ///< of the first body
  double second_rotation = 0.0;   ///< of the second; 0 at a wall
  double vibration = 0.0;         ///< of the kept modes of the first
  double second_vibration = 0.0;  ///< of the second
  double dissipated = 0.0;        ///< lost to the material until the end of the impact
  double yielded = 0.0;           ///< taken by plastic flow
  double friction = 0.0;          ///< heat of sliding
  double unresolved = 0.0;        ///< of the modes above the cutoff
  double stored = 0.0;            ///< where a lossy body relaxes
};

/// One oblique impact at a fixed resolution, with the inputs that made it.
struct ObliqueImpact {
  Impact normal;     ///< of the motion along the normal: of bodies in which both directions do not act on each other it
                     ///< is the central impact, bit by bit; else its ledger and its errors are of both directions
  Obliquity before;  ///< what was asked for
  double restitution = 0.0;             ///< ε_n = −v_n′/v_n
  double sliding = 0.0;                 ///< s, c
  double sliding_after = 0.0;           ///< s′
  double tangential_restitution = 0.0;  ///< ε_t = −s′/s: −1 without friction, 1 of a superball; NaN where s = 0
  double tangential_after = 0.0;        ///< v_t′, c
  double spin_after = 0.0;              ///< Ω₁′, c/R
  double second_spin_after = 0.0;       ///< Ω₂′, c/R of the first
  double unsettled_sliding = 0.0;       ///< by how much s′ of a body that stays on a plate may be off, c; else 0
  double unsettled_heat = 0.0;          ///< the same of `friction` in the ledger, which then is vibration
  double impulse = 0.0;                 ///< ∫ Σq dt of friction over the reduced mass, c: the change of v_t
  double turned = 0.0;             ///< largest angle by which a body, or the line between two centres, turns meanwhile
  bool beyond_small_turn = false;  ///< the contact rolls by more than its half-width on a body, R·angle > a: linear
                                   ///< kinematics, which leaves it where it is, is no longer accurate
  ObliqueLedger energy;
  double momentum_error = 0.0;          ///< |impulse + change of momentum| along the surface / (μ_r (v_n + |s|))
  double angular_momentum_error = 0.0;  ///< the same of the spins and the moments of friction, / (I_k (v_n + |s|)/R)
  double energy_error = 0.0;            ///< 1 − sum of the ledger
};

/// Computes one oblique impact with friction, node by node: |q| ≤ μ p; a node slips against q where |q| = μ p, and
/// sticks elsewhere. Without friction, or where nothing slides and both directions do not act on each other, it is the
/// central impact.
///
/// Spheres are taken by rings that move in one direction, without what pressure and friction change in each other: for
/// equal bodies there is nothing of that (docs/theory/oblique.md), else `oblique_restitution` estimates it.
/// @param speed of approach along the normal, as of `impact`
/// @param observation of the impact, which then is computed twice where both directions act on each other
/// @throws InvalidInput for arguments out of range, and with friction for bodies without an answer along their surface,
///         as rods, and at an exponential wall; NotConverged as `impact`
[[nodiscard]] ObliqueImpact oblique_impact(const Contact& contact, double speed, const Obliquity& obliquity,
                                           const ImpactOptions& options = {},
                                           const ObliqueObservation& observation = {});

/// One normal impact with its pressures, from which every angle, spin and friction follows: for bodies in which both
/// directions do not act on each other, as spheres are computed. It costs two impacts to make, and each outcome about
/// as much as the steps of one. Outcomes depend on the obliquity divided by its friction alone, times the friction.
class SharedNormalImpact {
 public:
  /// @throws InvalidInput as oblique_impact, and for disks; NotConverged as `impact`
  explicit SharedNormalImpact(const Contact& contact, double speed, const ImpactOptions& options = {});

  /// The central impact.
  [[nodiscard]] const Impact& normal() const;

  /// The oblique impact that it is with this motion along the surface, and what is seen of it.
  [[nodiscard]] ObliqueImpact with(const Obliquity& obliquity, const Poll& poll = {},
                                   const ObliqueObservation& observation = {}) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace stoss
