#pragma once

#include "stoss/cxx20.hpp"

/// Hertz' contact of round bodies under a constant normal force N that is then pushed along the wall, with Coulomb
/// friction μ (Cattaneo 1938, Mindlin 1949; K. L. Johnson, Contact Mechanics, section 7.2). With the displacement δ of
/// distant points along the wall, δ_max = μd/κ where d is the normal approach, and the radius a of the contact,
///
///   T = μN [1 − (1 − δ/δ_max)^{3/2}],   c = a (1 − T/μN)^{1/3}
///
/// up to δ_max, where the whole contact slides. The circle r < c sticks.
namespace stoss::quasistatic {

/// κ = 2(1 − ν)/(2 − ν), tangential over normal stiffness of a contact of one material, or with a rigid body.
///
/// Of two materials 1/κ is the mean of theirs, weighted with (1 − ν²)/E. Different materials also couple both
/// directions, which these laws neglect.
/// @param poisson −0.95 … 0.4999
/// @throws InvalidInput outside that range
[[nodiscard]] double mindlin_ratio(double poisson);

/// T/μN of a displacement, to 1e-15. @param displacement δ/δ_max, any; the force has its sign
/// @throws InvalidInput for a displacement that is not finite
[[nodiscard]] double mindlin_force(double displacement);

/// δ/δ_max of a force, to 1e-15. @param tangential T/μN, −1 … 1
/// @throws InvalidInput outside that range
[[nodiscard]] double mindlin_displacement(double tangential);

/// c/a, the radius of the circle that sticks. @param tangential T/μN, −1 … 1
/// @throws InvalidInput outside that range
[[nodiscard]] double mindlin_stick_radius(double tangential);

/// Tangential traction over μp₀: √(1 − r²/a²) − (c/a) √(1 − r²/c²), the second term only inside of c.
/// @param tangential T/μN, −1 … 1
/// @param distance   r/a ≥ 0 from the axis
/// @throws InvalidInput outside these ranges
[[nodiscard]] double mindlin_traction(double tangential, double distance);

}  // namespace stoss::quasistatic
