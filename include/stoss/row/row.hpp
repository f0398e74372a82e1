#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/poll.hpp"
#include "stoss/quantity.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Several bodies on one line, from left to right, with a wall at either end or none.
///
/// All may touch at once: each contact is that of two bodies as a pair, and each body carries waves and, by its static
/// compliance from pole to pole, forces from one contact to the other (docs/theory/rows.md).
struct Row {
  std::vector<BodyMaker> kinds;  ///< what bodies there are: between two neighbours disks, spheres and rods, at an end
                                 ///< also a body known by its modes, at the right end a half-space or a plate
  std::vector<std::size_t> bodies;  ///< which of these each is: 2 to 100, or one between two walls
  bool wall_before = false;         ///< a rigid wall on the left
  bool wall_after = false;          ///< and on the right
  std::vector<double> gaps{};       ///< between neighbours, walls included, R of the first body; empty: all touch
  /// Of the bodies by their numbers at the start, energies over that of all centres. Bodies that vibrate begin so far
  /// apart that no vibration makes them touch.
  Vibration vibration{};
};

/// How the bodies of a row vibrate: coordinate and momentum of each kept mode of each body, in its own units and in the
/// order of its modes. Only a row at the same cutoff can begin with it.
struct RowState {
  std::vector<std::vector<double>> coordinate, momentum;
};

/// What happens at one contact of a row, by the number of the body on its left (−1: the wall on the left).
struct RowContact {
  int left = 0;
  double first_touch = 0.0;      ///< R/c of the first body after the first touch of the row; NaN: none
  double last_touch = 0.0;       ///< end of the last contact
  int touches = 0;               ///< how many times the bodies come together, waves between them included
  double max_force = 0.0;        ///< in mc²/R of the first body
  double impulse = 0.0;          ///< in mc of the first body
  double max_compression = 0.0;  ///< R of the first body
};

/// Where the energy of a row is at an instant, over that of its centres at first.
struct RowEnergy {
  double translation = 0.0;  ///< of the centres
  double vibration = 0.0;    ///< of the kept modes; of half-spaces and plates what has run away
  double contact = 0.0;      ///< stored in contacts
  double unresolved = 0.0;   ///< taken by modes above the cutoff
  double dissipated = 0.0;   ///< by materials that relax
  double yielded = 0.0;      ///< by plastic flow
};

/// A row at an instant. Refers to what is gone after the call of the observer.
struct RowSnapshot {
  double time;                              ///< R/c of the first body since its first touch
  const std::vector<double>& displacement;  ///< of each centre since the start, R of the first body
  const std::vector<double>& velocity;      ///< of each centre, c of the first body
  const std::vector<double>& force;         ///< of each contact from left to right, mc²/R of the first body
  RowEnergy energy;
};

/// One motion of a row at a cutoff.
struct RowImpact {
  double cutoff = 0.0;  ///< c/R of the first body
  double step = 0.0;    ///< R/c of the first body
  long steps = 0;
  double work = 0.0;                     ///< of the motion: steps times modes, a contact for 600 of them
  double time = 0.0;                     ///< at the end
  std::vector<double> velocities_after;  ///< c of the first body, to the right
  std::vector<RowContact> contacts;      ///< from left to right
  RowEnergy energy;                      ///< at the end
  double energy_error = 0.0;             ///< sum of all less that at first
  double momentum_error = 0.0;           ///< what the bodies have more than before, and no wall has given
  RowState after;                        ///< how they vibrate then
  double strain = 0.0;                   ///< greatest one near a contact, estimated (Impact::strain)
  std::vector<double> open;              ///< by what each velocity may still change, as bodies may meet again; 0: not
};

/// How long a row is watched, and by whom.
struct RowWatch {
  double until = 0.0;  ///< R/c of the first body after the first touch; 0: until no bodies can meet any more
  double settled =
      0.0;        ///< or those that can differ in speed by less than this share of the greatest difference at first
  int every = 1;  ///< steps between two calls; none while all bodies fly freely, but at both ends
  const RowState* start = nullptr;  ///< with which the bodies begin, in place of Row::vibration
  std::function<void(const RowSnapshot&)> observer{};
};

/// Moves a row with all modes up to a cutoff.
/// @param speeds of the bodies at first, to the right, c of the first body
/// @param cutoff c/R of the first body, of all bodies
/// @throws InvalidInput for bodies that cannot be in a row, or numbers out of range; NotConverged if it does not end
[[nodiscard]] RowImpact row_impact(const Row& row, const std::vector<double>& speeds, double cutoff,
                                   const Poll& poll = {}, const RowWatch& watch = {});

struct RowOptions {
  double tolerance = 1e-3;  ///< error of each velocity after over the greatest difference of speeds before
  double until = 0.0;       ///< RowWatch::until: velocities then, whatever comes after
  Poll poll{};
};

/// The velocities after all contacts of a row, with errors.
struct RowResult {
  std::vector<Estimate> velocities_after;  ///< c of the first body, to the right
  Estimate translation;                    ///< share of the energy that is left in translation
  RowImpact finest;                        ///< the motion at the highest cutoff
  std::vector<double> cutoffs;             ///< of all motions
  long steps = 0;                          ///< of all
  bool converged = false;
  std::string reason;  ///< why not
};

/// Moves a row at rising cutoffs until the velocities after have errors below the tolerance.
///
/// The error of a velocity is 6 times its greatest change from coarser motions, scaled to what is left of it at the
/// last cutoff by the power 2 (of rods 1), at least 4 times the greatest of any body, and half the share
/// of the energy that modes above the cutoff have taken; and in addition what bodies that may meet again leave open.
/// @throws as row_impact
[[nodiscard]] RowResult row(const Row& row, const std::vector<double>& speeds, const RowOptions& options = {});

}  // namespace stoss
