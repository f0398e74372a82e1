#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/vibration/rod_chain.hpp"

namespace stoss {

/// Mass, transit time and impedance of a rod in the units in which it is given.
struct RodMeasures {
  double length, speed, mass, transit, impedance;

  explicit RodMeasures(const Rod& rod)
      : length(rod.length),
        speed(std::sqrt(rod.young / rod.density)),
        mass(rod.density * rod.area * rod.length),
        transit(length / speed),
        impedance(mass / transit) {}
};

/// What becomes of two rods that meet.
struct RodMeeting {
  double restitution = 0.0;
  double unresolved = 0.0;  ///< energy lost
};

/// The vibrations of the rods of a chain, each at its own time, and what they do to a collision.
class RodVibrations {
 public:
  virtual ~RodVibrations() = default;

  /// Lets a rod vibrate freely for a time, and leaves the share `kept` of the energy.
  virtual void age(std::size_t rod, double time, double kept) = 0;

  /// Energy of the vibration of a rod.
  [[nodiscard]] virtual double energy(std::size_t rod) const = 0;

  /// Lets a rod and its right neighbour meet, whose undeformed ends touch now. Afterwards they vibrate as they would if
  /// they had been flying freely since their undeformed ends parted. What it throws leaves the vibrations as they were.
  virtual RodMeeting meet(std::size_t left, std::size_t right, double speed) = 0;

  /// Turns the velocities of a vibration round.
  virtual void reverse(std::size_t rod) = 0;
};

}  // namespace stoss
