#pragma once

#include "stoss/quasistatic/point_hertz.hpp"

/// Adhesion of smooth round bodies by K. L. Johnson, K. Kendall and A. D. Roberts (Proc. R. Soc. Lond. A 324, 301,
/// 1971): a model, as the work of adhesion is no elastic constant.
///
/// With a work of adhesion w (energy that it takes to part a unit of area), 1/R the curvature and 1/E* the softness,
///
///   F = 4E*a³/(3R) − √(8πwE*a³),   δ = a²/R − √(2πwa/E*).
///
/// Bodies that approach jump into contact at δ = 0, and part at δ = −δ_f, where dF/da ends: the work between, taken by
/// the two jumps, is 7.09 (w⁵R⁴/E*²)^{1/3}.
namespace stoss::quasistatic {

/// Energy that the jumps into and out of contact take from an impact, ER³: 7.09 (w⁵R⁴/E*²)^{1/3}, with
/// 7.09 = (2π)^{5/3} (3/10 + (1/2) s⁴ + (8/15) s¹⁰ − (4/3) s⁷) at s³ = 1/4.
/// @param work_of_adhesion w in ER; 0 to 1e100
/// @throws InvalidInput outside that range, and as point_hertz
[[nodiscard]] double adhesion_energy(const PointPair& pair, double work_of_adhesion);

/// Speed below which elastic bodies stick, c: (2/m · adhesion_energy)^{1/2} = (14.18/m)^{1/2} (w⁵R⁴/E*²)^{1/6} (C.
/// Thornton and Z. Ning, Powder Technol. 99, 154, 1998). Where nothing else is lost ε = √(1 − (v_s/v)²) above it.
/// @param mass reduced mass m, ρR³, 1e-100 to 1e100. @throws InvalidInput as above
[[nodiscard]] double sticking_speed(const PointPair& pair, double work_of_adhesion, double mass);

}  // namespace stoss::quasistatic
