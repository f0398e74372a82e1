#pragma once

#include <vector>

#include "stoss/cxx20.hpp"

/// What the vibrations and the fields of disks and spheres have in common, in units R = c = ρ = 1.
namespace stoss::bodies {

/// One vibration of a free disk or sphere. `modes` of either says how it is normalised.
struct Mode {
  int order;          ///< n, angular order of a disk, degree of a sphere
  int index;          ///< l, number of the root for this order, from 0
  double omega;       ///< ω, eigenfrequency in c/R; relative error ≤ 1e-12
  double radial;      ///< u_r(R) ≥ 0: C of a disk, U of a sphere
  double tangential;  ///< u_φ(R) = S of a disk, u_θ(R) = V of a sphere
};

/// Displacement of a mode at one radius, in units of its normalisation.
struct Displacement {
  double radial;      ///< u_r(r), to be multiplied by cos nφ of a disk, by P_n(cos θ) of a sphere
  double tangential;  ///< u_φ(r) by sin nφ, or u_θ(r) by dP_n(cos θ)/dθ
};

/// Response of the edge to a load of one order: Σ_l (radial, tangential)(radial, tangential)ᵀ/ω² over its modes.
struct Flexibility {
  double radial = 0.0;      ///< F^CC of a disk, F^UU of a sphere
  double mixed = 0.0;       ///< F^CS, F^UV
  double tangential = 0.0;  ///< F^SS, F^VV
};

/// Points inside a disk, or on a meridian plane of a sphere: every radius with every angle. The angle 0 points to what
/// the body meets, π away from it; negative angles are the other half of the plane.
struct PolarGrid {
  std::vector<double> radius;  ///< 0 … 1, R
  std::vector<double> angle;   ///< radians
};

}  // namespace stoss::bodies
