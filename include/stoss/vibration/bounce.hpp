#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/resolution.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// How a body comes back to the wall, how often, and how each of its impacts is computed. Exactly one of `flight_time`
/// and `gravity` is given.
struct BounceOptions {
  long count = 100;                     ///< impacts, 1 … 1e9
  std::optional<double> flight_time{};  ///< from leaving the wall to touching it, of an unexcited body, R/c
  std::optional<double> gravity{};      ///< g, c²/R, 1e-15 … 1e3: the flight lasts 2v/g; in contact nothing weighs
  std::optional<double> decay_time{};   ///< τ, R/c: in flight, vibrational energies fall as e^(−t/τ); 0: at once
  Resolution resolution{};              ///< of each impact
  Vibration vibration{};                ///< before the first impact
  Poll poll{};
};

/// Energies as shares of the initial energy of the first impact of a sequence. The last two are of all that was lost
/// since then, and the sum of all four is 1 but for Bounce::energy_error.
struct SequenceEnergy {
  double translation = 0.0;
  double vibration = 0.0;   ///< of the kept modes
  double dissipated = 0.0;  ///< lost to the material, and between the impacts
  double unresolved = 0.0;  ///< of the modes above the cutoff, and of the waves in a half-space
};

/// One impact of a sequence.
struct Bounce {
  long number = 0;                   ///< 1, 2, …
  double speed = 0.0;                ///< towards the wall, c
  double restitution = 0.0;          ///< ε = −v_f / v_i
  SequenceEnergy before{};           ///< when it begins
  SequenceEnergy after{};            ///< when it is over
  double energy_error = 0.0;         ///< 1 − sum of `after`
  double contact_time = 0.0;         ///< R/c
  double flight_time = 0.0;          ///< after it, R/c
  bool short_flight = false;         ///< before it, too short for the vibration to keep clear of the wall
  double dent = 0.0;                 ///< depth of the dent that plastic flow has left so far, R
  double strain = 0.0;               ///< as in Impact
  bool beyond_small_strain = false;  ///< as in Impact
};

/// Receives the impacts of a sequence in their order, each as soon as it is over. What it throws ends the sequence.
using BounceObserver = std::function<void(const Bounce& bounce, const Impact& impact)>;

/// A sequence that ends too early.
class BounceNotConverged : public NotConverged {
 public:
  BounceNotConverged(const NotConverged& cause, std::vector<Bounce> impacts);
  std::vector<Bounce> done;  ///< the impacts before
};

/// Computes impact after impact of a body that comes back to a wall or a half-space with the vibration that the last
/// impact has left, ω times the flight time further in phase. A body that has stopped vibrating begins each impact as
/// in `impact`, to the bit. The waves in a half-space have left.
///
/// Times are nominal: a flight begins and ends where the body would touch if it were unexcited. A flight too short
/// for the vibration to keep clear of the wall is not followed on its way: the body comes as from afar, with the phases
/// of the nominal time, and short_flight is set. In a lossy material it damps by itself.
///
/// All impacts have the same cutoff and no error bar: without damping small differences grow, and a long sequence
/// does not converge with the resolution. Its means do. With Tail::quasistatic all energy is kept, and
/// if the motion is ergodic the mean share of translation before impacts tends to 1/(N + 1) for N kept modes
/// (docs/theory/bounce.md); with Tail::radiating the modes above the cutoff absorb energy for good.
/// @param speed of the first impact, 1e-8 … 1 c
/// @throws InvalidInput for arguments out of range and two free bodies, which do not come back; NotConverged as
///         `impact`, and if the speed leaves 1e-8 … 1 c
void bounce(const Contact& contact, double speed, const BounceOptions& options, const BounceObserver& observer);

/// Computes a sequence and returns it as a whole. @throws InvalidInput as above; BounceNotConverged
[[nodiscard]] std::vector<Bounce> bounce(const Contact& contact, double speed, const BounceOptions& options);

/// Speed, c, for which a half-space is made that a sequence of this first speed is to end on: a tenth of it.
[[nodiscard]] double slowest_bounce(double speed);

/// Checks a sequence before it is computed. @throws InvalidInput as `bounce`
void validate(const Contact& contact, double speed, const BounceOptions& options);

}  // namespace stoss
