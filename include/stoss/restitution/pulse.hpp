#pragma once

#include <string>
#include <vector>

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// How a pulse of force is computed.
struct PulseOptions {
  double tolerance =
      1e-2;  ///< error of the force at any instant over its maximum; between flat ends of the maximum alone
  double threshold = 0.01;  ///< share of the maximum above which `duration` is taken, 0 … 0.9
  int points = 400;         ///< instants, and frequencies, 16 … 100000
  Poll poll{};
  Vibration vibration{};  ///< of the bodies before
};

/// The force of an impact in time, with its error. Units as in Impact; times from where unexcited bodies would touch.
struct Pulse {
  std::vector<double> time, force, force_error;
  std::vector<double> force_change;  ///< what the last step of the cutoff has changed, times its share in the error
  std::vector<double> hertz;         ///< force of Hertz' pulse of these bodies; NaN on a line
  std::vector<double> frequency;     ///< ω, c/R, from 0 to beyond the first null
  std::vector<double> amplitude, amplitude_error;  ///< |∫ F e^{−iωt} dt|, over the impulse at ω = 0
  Estimate peak_force;                             ///< Impact::max_force
  Estimate rise;                                   ///< from the first force to the maximum
  Estimate contact_time;                           ///< from the first force to the last
  Estimate duration;                               ///< while the force is above the threshold
  Estimate impulse;                                ///< ∫F dt over the mass of the first body, c
  Estimate asymmetry;         ///< 1 less twice the share of the impulse before the maximum: above 0, it falls slowly
  Estimate corner_frequency;  ///< at which the amplitude has fallen to 1/√2
  Estimate first_null;        ///< of the amplitude: its first minimum
  Estimate restitution;       ///< ε
  double from_hertz = 0.0;  ///< greatest difference from Hertz' pulse of these bodies, over its maximum; NaN on a line
  double from_sine = 0.0;   ///< the same from sin^{3/2} of the same maximum and contact time
  double threshold = 0.0;   ///< as asked for
  Impact finest;            ///< the impact at the highest cutoff
  std::vector<double> cutoffs;  ///< of all impacts
  long steps = 0;               ///< of all
  bool converged = false;
  std::string reason;  ///< why not
};

/// Computes the force of an impact in time at rising cutoffs until its error is small enough.
///
/// Errors are 3 times the greatest difference from the coarser impacts, scaled to what is left of it at the last cutoff
/// by the power 3/2 (of rods 1), of a force in the time around an instant in which the highest modes turn once. The
/// force between flat ends jumps, and is shown as its mean over that time.
/// @throws as restitution, and InvalidInput for options out of range
[[nodiscard]] Pulse pulse(const RefinableContact& contact, double speed, const PulseOptions& options = {});

}  // namespace stoss
