#pragma once

#include <string>
#include <vector>

#include "stoss/impact/oblique.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// One oblique impact on the way to a converged value.
struct ObliqueRun {
  double cutoff = 0.0;
  FixedResolution resolution;
  double restitution = 0.0;
  double sliding_after = 0.0;
  double tangential_after = 0.0;
  double spin_after = 0.0;
  double second_spin_after = 0.0;
  double friction_loss = 0.0;
  double vibration = 0.0;
  double unresolved = 0.0;
  double energy_error = 0.0;
  long steps = 0;
};

/// What may change in values of rings that move in one direction because pressure and friction act on each other: by
/// how much a model with this coupling differs from that without, both computed coarsely (docs/theory/oblique.md). All
/// are 0 where nothing is left out: for disks, equal bodies and μ = 0. NaN: unknown.
struct Coupling {
  double dundurs = 0.0;        ///< Dundurs' |β| of the bodies, 0 … ¾: how much pressure moves one along the other
  double restitution = 0.0;    ///< change of ε_n of a central impact, by friction of surfaces that pressure moves
  double sliding_after = 0.0;  ///< change of s′
  double tangential_restitution = 0.0;  ///< of ε_t; 0 where s = 0
  double tangential_after = 0.0;        ///< of v_t′
  double spin_after = 0.0;              ///< of Ω₁′
  double second_spin_after = 0.0;       ///< of Ω₂′
};

/// The collision rule of two bodies at one normal speed and obliquity, with its errors and the runs that led to it.
/// Units and signs as in ObliqueImpact. An infinite error means that it is unknown.
struct ObliqueRestitution {
  double speed = 0.0;  ///< v_n, c
  Obliquity before;
  double sliding = 0.0;             ///< s
  Estimate restitution;             ///< ε_n
  Estimate tangential_restitution;  ///< ε_t = −s′/s; where s = 0 it is 0 with an infinite error: s′ says what happens
  Estimate sliding_after;           ///< s′
  Estimate tangential_after;        ///< v_t′
  Estimate spin_after;              ///< Ω₁′
  Estimate second_spin_after;       ///< Ω₂′
  Estimate friction_loss;           ///< share of the initial energy that became heat of friction
  Estimate vibration;               ///< share of it with which the bodies vibrate
  Coupling neglected;               ///< what the errors do not contain: the coupling that rings leave out
  double tolerance = 0.0;
  bool converged = false;  ///< whether the error of s′ is at most tolerance × the greater of |s| and μ v_n
  std::string reason;      ///< why not
  bool unstable = false;   ///< friction between unlike bodies so high that waves of any length grow while all slides:
                           ///< nothing has a limit then, and all errors are unknown
  std::vector<ObliqueRun> runs;  ///< from coarse to fine; NaN of s′ in impacts along the normal that ε_n needs alone
  ObliqueImpact finest;          ///< the last with s′
  long steps = 0;                ///< of all runs
};

struct ObliqueOptions {
  double tolerance = 1e-2;  ///< error of s′ over the greater of |s| and μ v_n, 1e-6 … 0.5
  Poll poll{};
  Vibration vibration{};  ///< of the bodies before the impact
};

/// Collision rules at one normal speed, for many angles, spins and frictions, from impacts at rising cutoffs. Of bodies
/// in which both directions do not act on each other one normal impact at each cutoff serves them all, and ε_n: that of
/// `restitution` within both errors, as s′ chooses the first cutoffs and points. Without friction it is that of
/// `restitution`, bit by bit.
///
/// The error of s′, and of what follows from it, is the maximum difference from all runs before the last, scaled by the
/// order at which such differences fall with the cutoff, times a factor; and at least what so many contact points leave
/// open, which is most where directions act on each other and friction is low (docs/theory/oblique.md). How often the
/// errors hold: docs/developer/validation.md. What spheres are computed without is estimated beside it (Coupling), for
/// bodies at rest. Much larger bodies take part as a whole. A rule that misses the tolerance has converged false, with
/// a reason.
/// @param speed of approach along the normal, 1e-8 … 1, in c
/// @throws InvalidInput as oblique_impact and for options out of range; NotConverged if no two impacts end
[[nodiscard]] std::vector<ObliqueRestitution> oblique_restitution(const RefinableContact& contact, double speed,
                                                                  const std::vector<Obliquity>& obliquities,
                                                                  const ObliqueOptions& options = {});

/// The rule at one obliquity.
[[nodiscard]] ObliqueRestitution oblique_restitution(const RefinableContact& contact, double speed,
                                                     const Obliquity& obliquity, const ObliqueOptions& options = {});

}  // namespace stoss
