#pragma once

#include "body.hpp"

namespace yield_study {

/// Displacement (r, z) of an elastic half-space z ≤ 0 by a unit force downwards at the origin (Boussinesq; Johnson,
/// Contact Mechanics, eq. 3.18).
[[nodiscard]] Eigen::Vector2d point_load_displacement(const Material& material, double r, double z);
/// Its stress (Johnson, eqs. 3.19 and 3.20).
[[nodiscard]] Stress point_load_stress(const Material& material, double r, double z);
/// Twice the elastic energy outside the cylinder r < size, z > −size.
[[nodiscard]] double point_load_energy(const Material& material, double size);

/// A half-space, from the axis and the free surface out to a cylinder of radius and depth `size`. Beyond, it is elastic
/// and deforms as under a point load, whose magnitude is one more unknown: the last.
struct HalfSpace {
  Body body;
  std::vector<int> surface;  ///< nodes from the axis outwards
};

struct Grid {
  double fine;     ///< length up to which elements are equally large, in r and z
  double element;  ///< their size
  double growth;   ///< ratio of neighbours beyond
  double size;     ///< of the cylinder
};

[[nodiscard]] HalfSpace half_space(const Material& material, const Grid& grid);

}  // namespace yield_study
