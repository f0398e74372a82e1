#pragma once

#include "yield/body.hpp"

namespace yield_study {

/// A solid of revolution, whose surface by the axis is that of a contact.
struct Solid {
  Mesh mesh;
  int surface;  ///< nodes 0 to surface are on it, from the axis outwards, equally spaced
};

/// Sphere of radius 1 on z = 0. Out to r = `side` there are `elements` equal elements, and as many in depth; from there
/// they grow to the middle.
[[nodiscard]] Solid sphere(int elements, double side);

/// Half-space below z = 0, out to a quarter of a circle of radius `size`. Its surface has the sphere's nodes.
[[nodiscard]] Solid block(int elements, double side, double size);

/// The solid, free but for the axis. @param strength Y over Young's modulus
[[nodiscard]] Body free_body(const Solid& solid, double poisson, double strength);

}  // namespace yield_study
