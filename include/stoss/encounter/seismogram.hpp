#pragma once

#include <vector>

#include "stoss/encounter/encounter.hpp"
#include "stoss/poll.hpp"
#include "stoss/quantity.hpp"
#include "stoss/restitution/pulse.hpp"

/// What a receiver on or in a block or a plate records of an impact.
namespace stoss {

/// Where a receiver is, in R of the first body.
struct Receiver {
  double distance = 0.0;  ///< along the surface, from where the bodies first touch
  double depth = 0.0;     ///< below the surface that is hit; the thickness of a plate: on its other face
};

/// How a seismogram is computed.
struct SeismogramOptions {
  double until = 0.0;  ///< last instant, R/c; 0: when all waves have passed, of a plate with its first echoes
  int points = 500;    ///< instants from first touch on, 2 … 20000
  Poll poll{};
};

/// One instant of a seismogram, in units of the first body; times as those of the pulse.
struct RecordedInstant {
  double time = 0.0;
  Estimate force;                             ///< of the contact
  Estimate normal, radial;                    ///< displacement into the depth, and away from the axis, R
  Estimate normal_velocity, radial_velocity;  ///< c
};

/// The motion of a receiver in time, with its error.
struct Seismogram {
  Receiver receiver;
  double arrival = 0.0;                               ///< of the first wave, straight, R/c
  Estimate max_normal, max_radial;                    ///< greatest displacements, either way, R
  Estimate max_normal_velocity, max_radial_velocity;  ///< c
  std::vector<RecordedInstant> instants;
};

/// Computes how a point of a half-space or a plate moves under the force of an impact (docs/theory/seismograms.md).
///
/// Waves are elastic, and the force has Hertz's pressure on a circle that grows as F^{1/3} to that of the impact. The
/// error adds up four parts. A smoother force and the waves near the cutoff would change the motion, and so does the
/// last change of the force by a finer cutoff. Of the size of the contact a share counts, and of the loss in the
/// material all.
/// @param pulse of this encounter
/// @throws InvalidInput unless the second body is a half-space or a plate that a ball meets, with tan δ up to 0.1, and
/// for a
///         receiver outside of it or nearer to the contact than twice its radius, options out of range, and where
///         more waves would be needed than are computed
[[nodiscard]] Seismogram seismogram(const Encounter& encounter, const Pulse& pulse, const Receiver& receiver,
                                    const SeismogramOptions& options = {});

/// Quantities of a seismogram, and of one of its instants.
[[nodiscard]] const Quantities<Seismogram>& seismogram_quantities();
[[nodiscard]] const Quantities<RecordedInstant>& recorded_instant_quantities();

}  // namespace stoss
