#pragma once

#include <array>
#include <cstddef>

#include "stoss/table/rule_table.hpp"

namespace stoss {

/// A round body that moves in a plane (2) or in space (3).
template <std::size_t dimension>
struct MovingBody {
  double inverse_mass = 1.0;     ///< 1/m; 0 of what does not move, as a wall
  double inverse_inertia = 0.0;  ///< 1/I about the centre, 2.5/(m R²) of a sphere, 2/(m R²) of a disk; 0: never turns
  double radius = 1.0;           ///< R, 0 or more
  std::array<double, dimension> velocity{};
  std::array<double, dimension == 3 ? 3 : 1> spin{};  ///< in a plane, positive from x to y
};

/// The collision of two bodies by a rule: changes their velocities and spins, at once and where they are.
///
/// With v_n along the normal, the velocity s along the surface of the first body's point of contact against the
/// second's, and s′ of the same direction, the second receives the impulse
///
///   (1 + ε_n) v_n/(1/m₁ + 1/m₂) n + (|s| − s′)/(1/m₁ + 1/m₂ + R₁²/I₁ + R₂²/I₂) s/|s|,
///
/// and the first its opposite, at arms R₁ and R₂. Momentum, and the angular momentum of bodies that touch, are kept to
/// rounding, energy is never gained, and spins about the normal do not change. What the rule does not say, how the
/// impulse divides s′ between velocity and spin, is that of these arms.
///
/// Velocities are in the unit of the table, and spins times radii. Bodies that move apart, or do not move, keep their
/// motion. Beyond the range of a table without values there (Beyond::error) velocities and spins become NaN.
/// @param normal from the first body to the second, of any length but 0
/// @return whether they approached
/// @throws InvalidInput for a normal without a direction, a number that is not finite, a negative mass, moment of
///         inertia or radius and, if they approach, a friction or ratio of radii that RuleTable refuses; nothing
///         changes
bool collide(const RuleTable& rule, MovingBody<2>& first, MovingBody<2>& second, const std::array<double, 2>& normal,
             double friction);
bool collide(const RuleTable& rule, MovingBody<3>& first, MovingBody<3>& second, const std::array<double, 3>& normal,
             double friction);

}  // namespace stoss
