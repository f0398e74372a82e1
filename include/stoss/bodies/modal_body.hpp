#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/material.hpp"

namespace stoss {

/// A vibration of a body as the point of contact sees it. Displacements are those along the outward normal there, and
/// along the direction of PointTangent, of the mode normalised to ∫ρ|u|² dV = 1.
struct PointMode {
  double omega = 0.0;               ///< angular frequency
  double displacement = 0.0;        ///< φ at the point, mass^(−1/2)
  double bend = 0.0;                ///< χ: at the distance r from the normal it is φ + χ r², all around on average
  double omega_error = 0.0;         ///< of the frequency
  double displacement_error = 0.0;  ///< of φ
  double tangential = 0.0;          ///< ψ: displacement of the point along the surface, mass^(−1/2)
  double tangential_bend = 0.0;     ///< χ_t: at the distance r it is ψ + χ_t r², all around on average
  double tangential_error = 0.0;    ///< of ψ
};

/// What friction along one direction t of the surface, in the plane of impact, needs of a body in addition to its
/// modes.
///
/// With M and I of the whole body and the lever r from its centre of mass to the point, t moves the point as
///
///   1/m_t = 1/M + (r × t)·I⁻¹(r × t) = 1/M + R²/I_e,   R = |r × t|,   1/I_e = e·I⁻¹e,   e = (r × t)/R.
///
/// So it turns as a round body of the radius R with the moment I_e: v_t is the velocity of its centre of mass along t,
/// its spin the part of its angular velocity along e, and the point slides at v_t + R·spin. Of a sphere R is its radius
/// and I_e = ⅖mR². Without R and I_e it does not turn, M stands for m_t, and v_t is the velocity of the point.
///
/// Pressed by a unit force along t it moves along t at the distance r, all around on average, by
///
///   G_t(r) = (1 + ν)(2 − ν)/(2πE) [1/r − g_t H ln(Hr)] + c_t + O(r),   g_t = (3 − 2ν + 4ν²)/(2(2 − ν)).
struct PointTangent {
  double mass = 0.0;        ///< M
  double inertia = 0.0;     ///< I_e; 0: it does not turn
  double arm = 0.0;         ///< R; 0: it does not turn
  double cross = 0.0;       ///< (r × n)·I⁻¹(r × t): how a force along the normal moves the point along t, 1/mass
  double compliance = 0.0;  ///< c_t
  double compliance_error = 0.0;  ///< of c_t
  bool has_bends = false;         ///< whether the χ_t are known
};

/// Any elastic body that is struck at one smooth point: its modes there and one static number, as finite elements give
/// them, in any consistent units.
///
/// Near the point a body is a half-space whose surface has the mean curvature H. Pushed into it by a unit force, and
/// relative to its rigid motion, it moves at the distance r by
///
///   G(r) = (1 − ν²)/(πE) [1/r − g H ln(Hr)] + c₀ + O(r),   g = (1 − 2ν)²/(2(1 − ν)),
///
/// with no logarithm where it is plane. c₀ is all that the shape of the body adds; the kept modes are taken from it
/// (docs/theory/any_body.md). Good for contacts that are small beside the body: what it leaves out is in the error.
struct ModalBody {
  std::string name = "modal body";
  std::string origin{};  ///< where its numbers come from
  /// m of a central impact; else that of the point along the normal, 1/m + (r × n)·I⁻¹(r × n), inverted.
  double mass = 0.0;
  double curvature = 0.0;             ///< H, the mean of both principal curvatures, ≥ 0; 0: a plane
  double curvature_difference = 0.0;  ///< of the principal ones, ≥ 0; above 2H the surface is a saddle
  double poisson = 0.0;               ///< ν of the material at the point, −0.95 … 0.4999
  double young = 1.0;                 ///< E there
  double density = 1.0;               ///< ρ there
  double loss_time = 0.0;             ///< η of a Kelvin–Voigt material of the whole body
  double compliance = 0.0;            ///< c₀
  double compliance_error = 0.0;      ///< of c₀
  double complete_to = 0.0;           ///< ω up to which all modes that move the point are there
  bool has_bends = false;             ///< whether the χ are known
  std::vector<PointMode> modes;       ///< elastic ones in rising frequency
  /// In clamps or on springs, so that it cannot move as a whole: its modes, from the lowest on, carry all that the
  /// point does, c₀ is the compliance against what holds it, and `mass` is only that of its own, which no impact feels.
  bool held = false;
  /// Where friction can act on it. Without it only impacts without friction are computed, as they are where a mode, or
  /// turning, moves the point in both directions at once: its normal motion must not feel friction.
  std::optional<PointTangent> tangent{};
};

/// The same body in other units. @param length, young, density the new units, in the old ones
[[nodiscard]] ModalBody in_units(const ModalBody& body, double length, double young, double density);

/// 1/H, or of a plane surface the edge of a cube of the same mass: the unit of length of the body.
[[nodiscard]] double own_length(const ModalBody& body);

/// SI values of the units of such a body that is given in SI. @throws InvalidInput as the maker
[[nodiscard]] Scales scales(const ModalBody& body);

/// Makes the body at any cutoff up to complete_to, in its own units own_length = c = ρ = 1.
/// @throws InvalidInput for numbers out of range, modes that are not in rising order, fewer than the local law of Weyl
///         asks for below complete_to, or more compliance in the modes than c₀ allows. Its Body::along throws without a
///         tangent, and where both directions act on each other by more than a share of 0.05
[[nodiscard]] BodyMaker modal_body(ModalBody body);

}  // namespace stoss
