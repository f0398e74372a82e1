#pragma once

#include <cstddef>
#include <functional>

#include "vector.hpp"

namespace gas {

/// A round particle of density 1 at its own time.
template <std::size_t D>
struct Particle {
  Vector<D> place{};  ///< in the box
  Vector<D> velocity{};
  Spin<D> spin{};
  double radius = 1.0, mass = 0.0, inertia = 0.0;
  double time = 0.0;  ///< at which it is at its place
  std::size_t cell = 0;
  long changes = 0;  ///< of its velocity

  [[nodiscard]] double translation() const { return 0.5 * mass * dot(velocity, velocity); }
  [[nodiscard]] double rotation() const { return 0.5 * inertia * dot(spin, spin); }
};

/// What a collision rule says: ε, and the speed at which the surfaces slide afterwards; below 0 in the other direction.
struct Outcome {
  double restitution = 1.0, sliding_after = 0.0;
};

/// The collision of two particles that approach at a speed, slide along each other at a speed of 0 or more, and have a
/// ratio of radii.
using Rule = std::function<Outcome(double speed, double sliding, double ratio)>;

/// ε of smooth particles at a speed of approach, of a ratio of radii.
using Law = std::function<double(double speed, double ratio)>;

/// The rule of smooth particles: they slide on as they did.
[[nodiscard]] Rule smooth(Law law);

/// Lets two particles collide. Momentum, and angular momentum about any point, are kept to rounding.
/// @param normal from the centre of the first to that of the second, of length 1
/// @return the impulse along it; 0 if they do not approach
template <std::size_t D>
double collide(Particle<D>& first, Particle<D>& second, const Vector<D>& normal, const Rule& rule);

}  // namespace gas
