#pragma once

#include <cstddef>
#include <vector>

#include "stoss/relaxation.hpp"

namespace stoss {

/// Points at which bodies can touch: they belong to the contact, and every body is asked about the same ones. They lie
/// at the lateral distances y_i = radius · sin α_i from the axis, α_i = (i + ½) · spacing. Each stands for itself and
/// for its mirror image, or for a whole ring around the axis.
struct ContactPoints {
  double radius = 1.0;   ///< of the circle on which they are equally spaced, in units of the size of the body asked
  double spacing = 0.0;  ///< radians; 0: a single point on the axis
  std::size_t count = 1;

  /// α_i
  [[nodiscard]] double angle(std::size_t i) const { return (static_cast<double>(i) + 0.5) * spacing; }
};

/// The surface of a body at contact points, in the units of the body.
struct Surface {
  std::vector<double> recess;     ///< distance of each point of the body at rest behind the foremost one, R
  std::vector<double> measure;    ///< length of edge that the point stands for, both sides, R; area of a ring, R²
  std::vector<double> impedance;  ///< Z, force per velocity of an outgoing plane wave, ρcR
  std::vector<double> shape;      ///< rows × points, row-major; see ModeGroup
};

/// How the end of a body is shaped that meets something, which decides where it can touch.
enum class Contour {
  flat,      ///< touches as a whole: a single point represents it
  cylinder,  ///< touches along a line of growing width, as a disk in its plane
  ball       ///< touches on a growing circle, as a sphere: points are rings around the axis
};

/// Size, wave speed and mass of a body, in any units common to all bodies that meet.
struct BodyScale {
  double length = 1.0;  ///< R
  double speed = 1.0;   ///< c
  double mass = 1.0;    ///< m
};

/// How many contact points a body needs across the half-width a of a hard contact when points and modes are refined
/// together: with modes up to ω_c the greater of
///
///   points · (ω_c/cutoff)^power   for the pressure, and   along_edge · ω_c √a   for the waves along the edge,
///
/// a in R of the circle of the contact points, ω_c over the time of the contact (R/c at a wall). Of a pair the body
/// that asks for more decides.
struct Sampling {
  double points = 64.0;     ///< at the cutoff below
  double cutoff = 1.0;      ///< c/R
  double power = 0.0;       ///< how they grow with the cutoff
  double along_edge = 0.0;  ///< 0: no waves that the contact must follow
  int fewest = 64;          ///< recommended for one impact by itself
};

/// From which stress on a material yields under von Mises' stress (elastic_plastic.hpp), by how much it hardens with
/// plastic strain, and how its strength grows with the rate of strain ε̇ of an impact: Y (1 + C ln(ε̇/ε̇₀)) above ε̇₀, as
/// G. R. Johnson and W. H. Cook (1983) have it. A model.
struct Strength {
  double yield = 0.0;      ///< Y in simple tension, E of the body; 0: it does not yield
  double hardening = 0.0;  ///< H, by which the strength grows for each unit of plastic strain, E of the body
  double rate = 0.0;       ///< C
  double reference = 1.0;  ///< ε̇₀, c/R

  bool operator==(const Strength&) const = default;
};

/// A thin soft layer on the face of a body, which gives way by the pressure times a compliance where it is pressed, as
/// its thickness over its modulus, h/M, and along the face by h/G (coated).
struct Coat {
  double compliance = 0.0;  ///< h/M with the constrained modulus M, R/E of the body
  double along = 0.0;       ///< h/G with the shear modulus, R/E
  Relaxation relaxation{};  ///< of its material, times in R/c; E is then that at once

  bool operator==(const Coat&) const = default;
};

}  // namespace stoss
