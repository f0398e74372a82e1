#pragma once

#include <cmath>
#include <vector>

#include "encounter/seismogram/recorder.hpp"
#include "stoss/body/body.hpp"
#include "stoss/restitution/pulse.hpp"

/// What the pulse of an impact makes act on the ground that is met.
namespace stoss {

/// Units of the ground in those of the first body. A scale has the mass of a body, which has some in its own units.
struct OwnUnits {
  double length, time, force;

  OwnUnits(const Body& first, const Body& second, double stiffness)
      : length(second.scale.length / first.scale.length),
        time(length * first.scale.speed / (second.scale.speed * std::sqrt(stiffness))),
        force(stiffness * unit_of_force(second) / (second.mass * unit_of_force(first))) {}

  static double unit_of_force(const Body& of) {
    return of.scale.mass * of.scale.speed * of.scale.speed / of.scale.length;
  }
};

/// A series of the pulse at any time, by Hermite's cubics through its points; 0 outside.
class Course {
 public:
  Course(const std::vector<double>& time, const std::vector<double>& value) : time_(time), value_(value) {}

  [[nodiscard]] double operator()(double at) const;

 private:
  const std::vector<double>&time_, &value_;
};

/// What acts on the ground, and its instants.
struct PulseLoads {
  bodies::Instants instants{};
  ground::Loads all;
  double duration = 0.0;  ///< of a single contact
};

/// Time of a single contact of a pulse.
[[nodiscard]] double duration_of(const Pulse& pulse);

/// @throws InvalidInput for more steps than are computed
[[nodiscard]] PulseLoads loads_of(const Pulse& pulse, double until, int points, const OwnUnits& units);

}  // namespace stoss
