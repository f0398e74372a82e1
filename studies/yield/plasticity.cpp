#include "plasticity.hpp"

#include <cmath>

namespace yield_study {
namespace {

Stress deviator(const Stress& stress) {
  const double mean = stress.head<3>().sum() / 3.0;
  return stress - mean * Stress(1.0, 1.0, 1.0, 0.0);
}

/// √(s:s), in which the shear stress counts twice.
double norm(const Stress& deviator) { return std::sqrt(deviator.squaredNorm() + deviator[3] * deviator[3]); }

/// 3K times the volumetric and 2G times the deviatoric projection, which act on strains.
Stiffness isotropic(double bulk, double shear) {
  Stiffness stiffness = Stiffness::Zero();
  stiffness.topLeftCorner<3, 3>().setConstant(bulk - 2.0 * shear / 3.0);
  stiffness.diagonal().head<3>().array() += 2.0 * shear;
  stiffness(3, 3) = shear;
  return stiffness;
}

}  // namespace

Stiffness Material::stiffness() const { return isotropic(bulk(), shear()); }

double mises(const Stress& stress) { return std::sqrt(1.5) * norm(deviator(stress)); }

double elastic_energy(const Material& material, const Stress& stress) {
  const double mean = stress.head<3>().sum() / 3.0, shear = norm(deviator(stress));
  return 0.5 * mean * mean / material.bulk() + 0.25 * shear * shear / material.shear();
}

Returned radial_return(const Material& material, const Stress& trial, double slip) {
  const double equivalent = mises(trial), excess = equivalent - material.strength - material.hardening * slip;
  if (excess <= 0.0) return {trial, material.stiffness(), 0.0};
  const Stress shape = deviator(trial), normal = shape / norm(shape);
  const double shear = material.shear(), soft = 3.0 * shear / (3.0 * shear + material.hardening);
  const double kept = 1.0 - soft * excess / equivalent;
  Returned returned;
  returned.stress = trial - (1.0 - kept) * shape;
  returned.tangent =
      isotropic(material.bulk(), kept * shear) - 2.0 * shear * (soft - 1.0 + kept) * normal * normal.transpose();
  returned.slip = soft * excess / (3.0 * shear);
  return returned;
}

}  // namespace yield_study
