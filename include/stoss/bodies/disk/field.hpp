#pragma once

#include <memory>
#include <span>
#include <vector>

#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

using bodies::PolarGrid;

/// Displacement relative to the moving centre of mass, and stress, at the points of a PolarGrid. Arrays are
/// radii × angles, row-major.
struct Field {
  std::vector<double> radial;      ///< u_r, R
  std::vector<double> tangential;  ///< u_φ, R
  std::vector<double> stress_rr;   ///< σ_rr, E; tension is positive
  std::vector<double> stress_pp;   ///< σ_φφ, E
  std::vector<double> stress_rp;   ///< σ_rφ, E
};

/// Displacement and stress inside a disk during an impact: the kept modes as they move, and all
/// others in their static answer to the wall's force,
///
///   u = u_static[F] + Σ_kept (Q − Q_static[F]) u_l,   Q_static = −Σ_i F_i (C c_i + S s_i)/ω²,
///
/// and so for the stress, where u_static is Michell's solution for the node forces F_i with inertia relief, for the
/// orders up to the Nyquist order of the contact grid (docs/theory/modes.md). So the stress at the contact is that
/// of the whole elastic body and not of a truncated series.
///
/// At the nodes the traction of the edge is the pressure of the node forces, to rounding: none outside the contact.
/// From the end of the contact it rings between the nodes, as any band-limited function does (2 % of the peak one node
/// beyond, 0.05 % at twice the half-width). With Tail::quasistatic the nodes in contact are at the wall to rounding.
/// The radiating tail also has inertia and damping, which are left out here: at v = 0.1 and cutoff 25 the nodes are at
/// the wall to 6e-5 R at the maximum force, and to 2e-3 R in the first instants.
class DiskField {
 public:
  /// @param poisson 2-D Poisson's ratio, as in disk(poisson, cutoff)
  /// @param body    that disk
  /// @param contact the contact points of the impact, in units of the disk
  /// @throws InvalidInput for points outside the disk, empty or not finite arrays, and a body that is not that disk
  DiskField(double poisson, const Body& body, const ContactPoints& contact, PolarGrid points, const Poll& poll = {});

  /// The field at one instant, from Snapshot::coordinate and Snapshot::node_force.
  /// @throws InvalidInput for arrays of other lengths than the body's modes and the grid's nodes, or not finite
  [[nodiscard]] Field at(std::span<const double> coordinate, std::span<const double> node_force,
                         const Poll& poll = {}) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// Von Mises stress √(σ_1² − σ_1 σ_2 + σ_2²) of plane stress, in E, at the points of the field.
/// @throws InvalidInput for stresses of different lengths
[[nodiscard]] std::vector<double> von_mises(const Field& field);

/// Difference of the principal stresses, |σ_1 − σ_2| = √((σ_rr − σ_φφ)² + 4σ_rφ²), in E:
/// photoelastic fringes count it.
/// @throws InvalidInput for stresses of different lengths
[[nodiscard]] std::vector<double> principal_difference(const Field& field);

}  // namespace stoss::bodies::disk
