#pragma once

#include <vector>

#include "bodies/half_space/lamb_kernel.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::modal {

/// c₀ of a sphere of radius and modulus 1, as ModalBody::compliance: what is left at its pole of its static response to
/// a force there, without that of a half-space and the logarithm. Summed over the degrees to 1e-10.
///
/// ν = 0: −0.66; 0.3: −0.51 (docs/theory/any_body.md)
[[nodiscard]] double sphere_constant(double poisson);

/// g = (1 − 2ν)²/(2(1 − ν)) of the logarithm.
[[nodiscard]] double logarithm_share(double poisson);

/// c_t of a sphere of radius and modulus 1, as PointTangent::compliance, in the same way.
[[nodiscard]] double sphere_constant_along(double poisson);

/// g_t = (3 − 2ν + 4ν²)/(2(2 − ν)) of its logarithm.
[[nodiscard]] double logarithm_share_along(double poisson);

/// How the static response bends across the point more than that of a sphere, in units of the body: c₂ of
/// G(rᵢ, rⱼ) → G + c₂ (rᵢ² + rⱼ²), from what the listed modes have of it.
///
///   c₂ = Σ φχ/ω² (1 − ω²/Ω²)² − the same of a sphere of the curvature,   Ω = complete_to or less
///
/// The taper lets both sums, which grow as Ω³, differ by what the shape of the body adds: of a hollow sphere with b =
/// 0.8 from Ω = 11 on by 4 %, of b = 0.5 by 0.2 %. 0 of a plane, and without χ.
struct Bending {
  double constant = 0.0;  ///< c₂
  double doubt = 0.0;     ///< by how much it changes from Ω/√2 on
};
[[nodiscard]] Bending bending(const ModalBody& body, const Poll& poll);

/// A kept mode in units of the body, with the mass of the body as its own.
struct KeptMode {
  double omega;
  double displacement;     ///< φ
  double bend;             ///< χ
  double tangential;       ///< ψ
  double tangential_bend;  ///< χ_t
};

/// m, or of a held body one so large that no impact moves it: 1e12 of its own.
[[nodiscard]] double moving_mass(const ModalBody& body);

/// A body as its contact sees it, in units own_length = c = ρ = 1.
struct PointModes {
  double mass;            ///< m
  double constant;        ///< c₀
  double constant_along;  ///< c_t, or 0
  std::vector<KeptMode> kept;
};

/// Those up to a cutoff in these units.
[[nodiscard]] PointModes point_modes(const ModalBody& body, double cutoff);

/// c = √(E/ρ).
[[nodiscard]] double wave_speed(const ModalBody& body);

/// Throws InvalidInput as `modal_body`.
void require_body(const ModalBody& body);

using half_space::Direction;

/// What is local to a point: a sphere of radius 1, or a half-space.
struct PointSurroundings {
  double poisson;
  bool plane;
};

/// Its surface, with the rows 1 and r².
[[nodiscard]] Surface point_surface(const PointSurroundings& its, Direction direction, const ContactPoints& points);

/// Its static compliance without the constant of the sphere.
[[nodiscard]] std::vector<double> local_compliance(const PointSurroundings& its, Direction direction,
                                                   const ContactPoints& points, const Poll& poll);

/// Adds c₂ (rᵢ² + rⱼ²) to a static compliance.
void add_bending(double constant, const ContactPoints& points, std::vector<double>& matrix);

/// Takes the kept modes from a static compliance, whose rows are `stride` long and begin with those of the points.
void take_kept(const PointModes& modes, Direction direction, const ContactPoints& points, std::size_t stride,
               std::vector<double>& matrix);

/// The kept modes as one group of these rows; none, if there are none.
[[nodiscard]] std::vector<ModeGroup> groups_of(const PointModes& modes, Direction direction);

}  // namespace stoss::bodies::modal
