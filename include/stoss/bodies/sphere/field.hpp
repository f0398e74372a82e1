#pragma once

#include <memory>
#include <span>
#include <vector>

#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

using bodies::PolarGrid;

/// Displacement relative to the moving centre of mass, and stress, at the points of a PolarGrid. Arrays are
/// radii × angles, row-major.
struct Field {
  std::vector<double> radial;      ///< u_r, R
  std::vector<double> tangential;  ///< u_θ, R
  std::vector<double> stress_rr;   ///< σ_rr, E; tension is positive
  std::vector<double> stress_tt;   ///< σ_θθ, E
  std::vector<double> stress_pp;   ///< σ_φφ, E: across the plane
  std::vector<double> stress_rt;   ///< σ_rθ, E
};

/// Displacement and stress inside a sphere during an impact: the kept modes as they move, and all others in their
/// static answer to the wall's force,
///
///   u = u_static[F] + Σ_kept (Q − Q_static[F]) u_l,   Q_static = −Σ_i F_i (U cos θ_i P_n − V sin θ_i dP_n/dθ)/ω²,
///
/// and so for the stress, where u_static is the solution for the ring forces F_i with inertia relief, for the degrees
/// up to the Nyquist degree of the contact grid (docs/theory/spheres.md). So the stress at the contact is that of the
/// whole elastic body and not of a truncated series.
class SphereField {
 public:
  /// @param poisson Poisson's ratio, as in sphere(poisson, cutoff)
  /// @param body    that sphere
  /// @param contact the contact points of the impact, in units of the sphere
  /// @throws InvalidInput for points outside the sphere, empty or not finite arrays, and a body that is not that sphere
  SphereField(double poisson, const Body& body, const ContactPoints& contact, PolarGrid points, const Poll& poll = {});

  /// The field at one instant, from Snapshot::coordinate and Snapshot::node_force.
  /// @throws InvalidInput for arrays of other lengths than the body's modes and the grid's nodes, or not finite
  [[nodiscard]] Field at(std::span<const double> coordinate, std::span<const double> node_force,
                         const Poll& poll = {}) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// Von Mises stress √(½[(σ_1−σ_2)² + (σ_2−σ_3)² + (σ_3−σ_1)²]), in E, at the points of the field.
/// @throws InvalidInput for stresses of different lengths
[[nodiscard]] std::vector<double> von_mises(const Field& field);

/// Difference of the principal stresses in the plane, √((σ_rr − σ_θθ)² + 4σ_rθ²), in E.
/// @throws InvalidInput for stresses of different lengths
[[nodiscard]] std::vector<double> principal_difference(const Field& field);

}  // namespace stoss::bodies::sphere
