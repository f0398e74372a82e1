#pragma once

#include <vector>

#include "inside.hpp"
#include "stoss/bodies/half_space/field.hpp"
#include "stoss/impact/replay.hpp"

namespace stoss::web {

/// The inside of a half-space, or a half-plane, at one instant after another. Its field is linear in what moves it: the
/// answers to the forces of single rings are computed once, so that a frame costs the kept waves only.
class Block {
 public:
  /// @param poisson of a half-plane the 2-D one
  /// @param rest    the body at rest, with its contact points
  Block(double poisson, const BodyFrame& rest, bodies::half_space::PlaneGrid points);

  /// Depths × distances, row-major: displacement away from the axis (tangential) and into the body (radial), stress in
  /// units of its own modulus.
  [[nodiscard]] Interior at(const BodyFrame& seen) const;

 private:
  [[nodiscard]] std::vector<double> on_rings(const std::vector<double>& node_force) const;

  double poisson_;
  Contour contour_;
  bodies::half_space::PlaneGrid points_;
  std::size_t in_ring_, rings_;  // contact points in one of the rings, that a picture needs fewer of
  bodies::half_space::HalfSpaceField field_;
  std::vector<bodies::half_space::Field> answers_;  // to a unit force on each ring
};

}  // namespace stoss::web
