#pragma once

#include <memory>
#include <span>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// Points of a plane through the axis of the impact: every depth with every distance from the axis.
struct PlaneGrid {
  std::vector<double> distance;  ///< r, 0 or more, in the unit of length of the half-space
  std::vector<double> depth;     ///< z below the surface, 0 or more
};

/// Displacement at the points of a PlaneGrid. Arrays are depths × distances, row-major.
struct Field {
  std::vector<double> lateral;  ///< u_r, away from the axis
  std::vector<double> normal;   ///< u_z, into the half-space
};

/// Speeds of the waves of a half-space, √(E/ρ).
struct WaveSpeeds {
  double pressure = 0.0;  ///< c_p
  double shear = 0.0;     ///< c_s
  double rayleigh = 0.0;  ///< c_R: along the surface
};

/// Those of a half-space (Contour::ball), or of a half-plane (Contour::cylinder) with its 2-D Poisson's ratio.
/// @throws InvalidInput for a Poisson's ratio that they cannot have
[[nodiscard]] WaveSpeeds wave_speeds(Contour contour, double poisson);

/// Displacement inside a half-space or a half-plane during an impact: the kept waves as they move, and all others in
/// their static answer to the forces,
///
///   u = u_static[F] + Σ_kept (Q − Q_static[F]) u_l,   Q_static = −Σ_i F_i A_l J₀(kr_i)/ω²,
///
/// where the wave l of wave number k has u_z = −A_l g_z(kz) J₀(kr), u_r = −A_l g_r(kz) J₁(kr) (in a half-plane cos kx
/// and sin kx), and u_static is the solution for the forces F_i on the rings, of wave numbers up to the π/h that
/// contact points of spacing h resolve (docs/theory/half_space.md). It is good where the time since the first force and
/// twice that of a shear wave from the axis to the point are together shorter than the contact that the half-space was
/// made for.
class HalfSpaceField {
 public:
  /// @param poisson Poisson's ratio, as in HalfSpace or HalfPlane
  /// @param body    that half-space or half-plane
  /// @param contact the contact points of the impact, in the unit of length of the half-space
  /// @throws InvalidInput for points outside it, empty or not finite arrays, and a body that is not that half-space
  HalfSpaceField(double poisson, const Body& body, const ContactPoints& contact, PlaneGrid points);

  /// The field at one instant, from Snapshot::coordinate and Snapshot::node_force; with their rates of change, its
  /// velocity.
  /// @throws InvalidInput for arrays of other lengths than the body's modes and the grid's nodes, or not finite
  [[nodiscard]] Field at(std::span<const double> coordinate, std::span<const double> node_force,
                         const Poll& poll = {}) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace stoss::bodies::half_space
