#pragma once

#include "stoss/cxx20.hpp"

/// Slow contact of round bodies of which one yields: elastic and ideally plastic, von Mises, without hardening. Models.
///
/// While strains are small, compression and force are functions of d = δ/δ_y and f = F/F_y alone, those of the onset
/// of yield, p₀ = 1.6 Y: f = d^{3/2} up to d = 1. After the deepest compression d_m the contact returns elastically,
///
///   f = f_m ((d − d_r)/(d_m − d_r))^n,
///
/// and an impression of depth d_r remains. What is lost in a slow impact is the work between the two, so ε depends on
/// V/V_y alone. Fits of the finite elements, which are for ν = 0.3, hold to 1 % in f and in ε² up to d = 1600, V/V_y =
/// 4500; at ν = 0.2 and 0.45 ε² is up to 3 % above and 4 % below. True spheres at finite strain have an ε² that is 2 %
/// lower at a/R = 0.14 and 9 % at 0.34 (docs/theory/real_contact.md).
namespace stoss::quasistatic {

enum class YieldLaw {
  finite_elements,  ///< fits of own finite elements (studies/yield)
  thornton_ning     ///< C. Thornton and Z. Ning, Powder Technol. 99, 154 (1998): the pressure stays below p₀ = 1.6 Y
};

/// f of a first compression, and its slope df/dd. @param depth d, 0 to 1e6. @throws InvalidInput outside
[[nodiscard]] double loading_force(YieldLaw law, double depth);
[[nodiscard]] double loading_stiffness(YieldLaw law, double depth);

/// Radius of the contact over that at the onset, √d up to d = 1; of the finite elements within 2 %, single ones 5 %.
/// @throws InvalidInput as above
[[nodiscard]] double loading_radius(YieldLaw law, double depth);

/// ∫f dd from 0 to d: ⅖ at d = 1. @throws InvalidInput as above
[[nodiscard]] double loading_work(YieldLaw law, double depth);

/// How a contact returns from its deepest compression.
struct Unloading {
  double residual = 0.0;      ///< d_r, depth of the impression that remains
  double exponent = 1.5;      ///< n
  double radius_ratio = 1.0;  ///< R_p/R of a sphere that would return so by Hertz' law: flatter than before
};

/// The return from a compression d_m. @param deepest 0 to 1e6; up to 1 nothing has yielded
/// @throws InvalidInput outside
[[nodiscard]] Unloading unloading(YieldLaw law, double deepest);

/// ∫f dd of the return from a compression, f_m (d_m − d_r)/(n + 1). @throws InvalidInput as above
[[nodiscard]] double unloading_work(YieldLaw law, double deepest);

/// ε of a slow impact in which nothing but yield takes energy: ε² = unloading_work/loading_work at the depth where
/// loading_work is ⅖(V/V_y)². @param speed_ratio V/V_y, 0 to 1e5; 1 up to 1. @throws InvalidInput outside
[[nodiscard]] double plastic_restitution(YieldLaw law, double speed_ratio);

/// ε of a fully plastic impact, 2.28 (V_y/V)^{1/4}, 1 at most: under a constant pressure p_d = 3 Y the compression is
/// a²/(2R), and it returns by Hertz' law, so that ε² = (3π^{5/4} 4^{3/4}/10) (p_d/E*) (½mV²/(p_d R³))^{−1/4} (K. L.
/// Johnson, Contact Mechanics, eq. 11.45), of a ball 1.72² (p_d⁵/(E*⁴ρ))^{1/4} V^{−1/2}.
/// @throws InvalidInput as above
[[nodiscard]] double fully_plastic_restitution(double speed_ratio);

}  // namespace stoss::quasistatic
