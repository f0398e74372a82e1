#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace stoss::bodies {

/// Instants of a load and of what it moves: steps are the same, and some of them are shown.
struct Instants {
  double step;          ///< of the load
  std::size_t before;   ///< steps of the load before t = 0
  std::size_t stride;   ///< steps between two instants that are shown
  std::size_t outputs;  ///< instants that are shown, from t = 0 on
};

/// A normal force on the surface in time, with Hertz's pressure on a circle that grows and shrinks with it.
struct PressedLoad {
  std::vector<double> force;   ///< at each step
  std::vector<double> radius;  ///< of the circle; 0: a point
};

/// Where Hertz's pressure on a circle is replaced by forces on a few points that have the same moments up to the
/// second, and of far waves to the fourth of the largest circle: one in the middle and four around it, √(3/7) of the
/// largest radius away. Its mean square of the distance is ⅖a².
struct Cross {
  double reach;  ///< of the four

  explicit Cross(double largest_radius) : reach(std::sqrt(3.0 / 7.0) * largest_radius) {}

  /// Of a force on a circle, that on the four together.
  [[nodiscard]] double share(double radius) const {
    return reach > 0.0 ? 0.4 * radius * radius / (reach * reach) : 0.0;
  }

  /// Calls visit(distance, weight, radial weight) for what a receiver at a distance from the middle has from the four.
  template <typename Visit>
  void around(double distance, const Visit& visit) const {
    const double near = distance - reach, far = distance + reach, aside = std::hypot(distance, reach);
    visit(std::abs(near), 0.25, near < 0.0 ? -0.25 : 0.25);
    visit(far, 0.25, 0.25);
    visit(aside, 0.5, aside > 0.0 ? 0.5 * distance / aside : 0.0);
  }
};

/// Motion of a point inside or on the surface, at each instant that is shown.
struct Motion {
  std::vector<double> normal, radial;                    ///< into the depth, away from the axis
  std::vector<double> normal_velocity, radial_velocity;  ///< their rates of change

  explicit Motion(std::size_t outputs)
      : normal(outputs), radial(outputs), normal_velocity(outputs), radial_velocity(outputs) {}
};

}  // namespace stoss::bodies
