#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/relaxation.hpp"

namespace stoss {

/// What meets, near the first point of contact, in units of the first body: all that a small contact knows of the
/// bodies.
struct Touch {
  bool circle = false;     ///< touches on a growing circle, not along a line
  double curvature = 1.0;  ///< 1/R₁ + 1/R₂
  double softness = 1.0;   ///< D₁/E₁ + D₂/E₂, D = 1 for a disk and 1 − ν² for a sphere
  double slowness = 1.0;   ///< 1/c of the bodies, weighted with their share of the compression
  double loss_time = 0.0;  ///< η of the bodies, weighted in the same way
};

[[nodiscard]] Touch touch(const Contact& contact);

/// Time of Hertz' contact over δ/v.
inline constexpr double hertzian_duration = 2.943;

/// A body that relaxes, and its share of the softness of both; times in R/c of the first.
struct RelaxingBody {
  double share;
  Relaxation relaxation;
};

[[nodiscard]] std::vector<RelaxingBody> relaxing_bodies(const Contact& contact);

/// Share of the first body in what the material of both loses near the contact: losses go with η times the
/// compression, or with what relaxes of it.
[[nodiscard]] double loss_share(const Contact& contact);

/// Compression at which evenly spaced contact points with the edge law begin to push: they answer like a continuous
/// surface that is closer by this, −h²/24 of a line and −h²/12 of a ball in their radius (docs/developer/numerics.md,
/// section 3). Between rough faces by the share of it that the edge law has there, from where the mean planes meet.
/// @param edge that share (edge_left)
[[nodiscard]] double touch_compression(const Contact& contact, const ContactGrid& grid, double edge);

}  // namespace stoss
