#pragma once

#include "stoss/cxx20.hpp"

/// Contact of round bodies of which one yields: elastic and ideally plastic, von Mises, or with linear hardening. A
/// model.
///
/// While strains are small, compression and force are functions of d = δ/δ_y and f = F/F_y alone, those of the onset
/// of yield, p₀ = 1.6 Y: δ_y = R (πp₀/2E*)², F_y = (4/3)E*√R δ_y^{3/2}, and f = d^{3/2} up to d = 1. After the deepest
/// compression d_m the contact returns elastically,
///
///   f = f_m ((d − d_r)/(d_m − d_r))^n,
///
/// and an impression of depth d_r remains. What is lost in a slow impact is the work between the two, so ε depends on
/// V/V_y alone. Fits of own finite elements (studies/yield), which are for ν = 0.3, hold to 1 % in f and in ε² up to d
/// = 1600, V/V_y = 4500, from where they go on as powers; at ν = 0.2 and 0.45 ε² is up to 3 % above and 4 % below. True
/// spheres at finite strain have an ε² that is 2 % lower at a/R = 0.14 and 9 % at 0.34 (docs/theory/real_contact.md).
///
/// Linear hardening, a strength that grows by H for each unit of plastic strain, changes the curves by H/E of the body
/// that yields and by nothing else: fits hold to 1 % for H/E up to 0.03 and d up to 500.
namespace stoss {

/// Maximum contact pressure over the yield strength at which a sphere begins to yield, p₀ = 1.6 Y (K. L. Johnson,
/// Contact Mechanics, eq. 6.9): below the contact, on the axis, the difference of the principal stresses reaches Y,
/// which is 0.62 p₀ at ν = 0.3. For ν from 0 to ½ the exact ratio is 1.30 to 1.88, and 1.61 at 0.3.
inline constexpr double yield_pressure_ratio = 1.6;

/// Deepest compression of the finite elements, over that at the onset. @param hardening H/E, here and below
[[nodiscard]] constexpr double deepest_computed(double hardening) { return hardening > 0.0 ? 500.0 : 1600.0; }

/// f of a first compression, and its slope df/dd. @param depth d, 0 to 1e6. @throws InvalidInput outside
[[nodiscard]] double loading_force(double depth, double hardening = 0.0);
[[nodiscard]] double loading_stiffness(double depth, double hardening = 0.0);

/// Radius of the contact over that at the onset, √d up to d = 1; within 2 %, single ones 5 %.
/// @throws InvalidInput as above
[[nodiscard]] double loading_radius(double depth);

/// ∫f dd from 0 to d: ⅖ at d = 1. @throws InvalidInput as above
[[nodiscard]] double loading_work(double depth, double hardening = 0.0);

/// d of a first compression that takes a work: the inverse of loading_work. @param work 0 to that of d = 1e6
/// @throws InvalidInput outside
[[nodiscard]] double depth_of_work(double work, double hardening = 0.0);

/// How a contact returns from its deepest compression.
struct Unloading {
  double residual = 0.0;      ///< d_r, depth of the impression that remains
  double exponent = 1.5;      ///< n
  double radius_ratio = 1.0;  ///< R_p/R of a sphere that would return so by Hertz' law: flatter than before
};

/// The return from a compression d_m. @param deepest 0 to 1e6; up to 1 nothing has yielded
/// @throws InvalidInput outside
[[nodiscard]] Unloading unloading(double deepest, double hardening = 0.0);

/// ∫f dd of the return from a compression, f_m (d_m − d_r)/(n + 1). @throws InvalidInput as above
[[nodiscard]] double unloading_work(double deepest, double hardening = 0.0);

/// ε of a slow impact in which nothing but yield takes energy: ε² = unloading_work/loading_work at the depth where
/// loading_work is ⅖(V/V_y)². @param speed_ratio V/V_y, 0 to 1e5; 1 up to 1. @throws InvalidInput outside
[[nodiscard]] double plastic_restitution(double speed_ratio);

}  // namespace stoss
