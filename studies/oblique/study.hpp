#pragma once

#include <string>
#include <vector>

#include "stoss/quasistatic/oblique/maw.hpp"
#include "stoss/restitution/oblique.hpp"

/// What the tables of this study share. Each is computed and written by one function.
///
/// x = s/(μ v_n) is how oblique an impact is: s is the sliding speed of the contact before the impact.
namespace study {

/// ν of all spheres of one material, and 2-D ν of all disks, where nothing else is said.
inline constexpr double sphere_poisson = 0.3;
inline constexpr double disk_poisson = 0.33;

/// 1 + mR²/I of a sphere: how much easier its surface moves along itself than it as a whole.
inline constexpr double sphere_yield = 3.5;

/// κ = 2(1 − ν)/(2 − ν), and χ of two spheres of one material, or of one at a wall.
[[nodiscard]] constexpr double kappa(double poisson) { return 2.0 * (1.0 - poisson) / (2.0 - poisson); }
[[nodiscard]] constexpr double chi(double poisson) { return 0.5 * kappa(poisson) * sphere_yield; }

/// Maw's ε_t of slow spheres.
[[nodiscard]] inline double maw_restitution(double x, double kappa, double chi) {
  return -stoss::quasistatic::maw(kappa * x, chi, 1e-5).psi2 / (kappa * x);
}

/// a/R of Hertz' contact of a sphere at its maximum, the sphere being at a rigid wall, or on a half-space of its
/// material.
[[nodiscard]] double contact_radius(double poisson, double speed, bool half_space);

/// The rules at these x, all with one friction and without spin.
[[nodiscard]] std::vector<stoss::ObliqueRestitution> rules(const stoss::RefinableContact& contact, double speed,
                                                           double friction, const std::vector<double>& obliquities,
                                                           double tolerance);

/// from, from + step, …, to
[[nodiscard]] std::vector<double> range(double from, double to, double step);

/// A disk at a rigid wall, and two equal disks: at twice the speeds they are the same without what both directions do
/// to each other.
[[nodiscard]] stoss::RefinableContact disk_at_wall(double poisson);
[[nodiscard]] stoss::RefinableContact equal_disks(double poisson);

void write_curves(const std::string& name);
void write_size(const std::string& name);
void write_glass(const std::string& name);
void write_coupling(const std::string& name);
void write_normal(const std::string& name);
void write_superball(const std::string& name);
void write_dem(const std::string& name);
void write_finite_elements(const std::string& name);

}  // namespace study
