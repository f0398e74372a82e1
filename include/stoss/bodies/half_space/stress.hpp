#pragma once

#include <vector>

#include "stoss/bodies/half_space/field.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::half_space {

/// Stress at the points of a PlaneGrid, in E, without the mean pressure. Arrays are depths × distances, row-major.
struct Stress {
  std::vector<double> von_mises;             ///< √(½[(σ_1−σ_2)² + (σ_2−σ_3)² + (σ_3−σ_1)²])
  std::vector<double> principal_difference;  ///< of the two in the plane, √((σ_rr − σ_zz)² + 4σ_rz²)
};

/// Elastic stress of a field of displacements, by Hooke's law with
///
///   ε_rr = ∂u_r/∂r,  ε_zz = ∂u_z/∂z,  2ε_rz = ∂u_r/∂z + ∂u_z/∂r,  ε_φφ = u_r/r   (σ_φφ = 0 in a half-plane)
///
/// and the derivatives of parabolas through three neighbours of the grid. At the maximum under a slow ball, on a grid
/// of 0.06 of the radius of the contact, it is that of Hertz to 0.5 %.
/// @param poisson as in HalfSpace (Contour::ball), or HalfPlane (Contour::cylinder)
/// @throws InvalidInput for fewer than three depths or distances, or ones that do not ascend, and a field of other
///         points
[[nodiscard]] Stress stress(Contour contour, double poisson, const PlaneGrid& points, const Field& field);

/// A layer below a surface.
struct ElasticLayer {
  double end;      ///< depth of its lower face; infinite of the last
  double poisson;  ///< as above
  double young;    ///< E, in that of the stress
};

/// The same below a surface of layers that stick together, from the top down. A depth on a face between two belongs to
/// the upper one; where a layer has three depths or more, no derivative goes across its faces.
[[nodiscard]] Stress stress(Contour contour, const std::vector<ElasticLayer>& layers, const PlaneGrid& points,
                            const Field& field);

}  // namespace stoss::bodies::half_space
