#pragma once

#include <Eigen/Core>

namespace yield_study {

/// Stress in an axisymmetric body: rr, zz, θθ, rz. The strains that belong to it: εrr, εzz, εθθ, 2εrz.
using Stress = Eigen::Vector4d;
using Stiffness = Eigen::Matrix4d;

/// An isotropic material that yields by von Mises, and hardens isotropically.
struct Material {
  double young, poisson;
  double strength;         ///< Y, infinite of an elastic one
  double hardening = 0.0;  ///< H, what the strength grows by the equivalent plastic strain

  [[nodiscard]] double shear() const { return young / (2.0 * (1.0 + poisson)); }
  [[nodiscard]] double bulk() const { return young / (3.0 * (1.0 - 2.0 * poisson)); }
  [[nodiscard]] Stiffness stiffness() const;
};

/// √(3/2 s:s).
[[nodiscard]] double mises(const Stress& stress);
/// ½ σ:C⁻¹:σ.
[[nodiscard]] double elastic_energy(const Material& material, const Stress& stress);

struct Returned {
  Stress stress;
  Stiffness tangent;  ///< d(stress)/d(strain at the end of the step), consistent with the step, symmetric
  double slip;        ///< increment of the equivalent plastic strain, √(2/3 Δεp:Δεp)
};

/// Radial return of a stress beyond the yield surface, by the implicit Euler rule (Simo and Hughes, Computational
/// Inelasticity, box 3.2 with isotropic hardening).
/// @param trial the stress if the step were elastic
/// @param slip before, by which the material has hardened
[[nodiscard]] Returned radial_return(const Material& material, const Stress& trial, double slip = 0.0);

}  // namespace yield_study
