#pragma once

#include <optional>

#include "stoss/contact/elastic_plastic.hpp"
#include "stoss/material.hpp"
#include "stoss/quasistatic/point_hertz.hpp"

namespace stoss::quasistatic {

/// Speed of approach at which a sphere begins to yield at a rigid wall, m/s; nothing where the material has no yield
/// strength. In Hertz' quasi-static impact the energy ½mv² is (8/15) E* R³ (πp₀/2E*)⁵ when the maximum pressure is
/// p₀, so that with E* = E/(1 − ν²)
///
///   v² = (16/15) (E* R³/m) (πp₀/2E*)⁵ = 25.5 Y⁵/(E*⁴ρ),   p₀ = 1.6 Y
///
/// (Johnson, eqs. 11.31 to 11.35, whose constant is 26). It does not depend on the radius.
/// @param radius m
/// @throws InvalidInput as scales
[[nodiscard]] std::optional<double> yield_speed(const Material& material, double radius);

/// Speed of approach of two spheres at which the one of less yield strength begins to yield, m/s: as above with
/// 1/E* = Σ(1 − ν²)/E, 1/R = Σ 1/R_k, 1/m = Σ 1/m_k. Nothing where neither has a yield strength; one that has none is
/// taken not to yield.
///
/// A half-space is a sphere of infinite radius, and so of infinite mass; a rigid sphere, which does not yield, one of
/// infinite Young's modulus. Of each there may be one.
/// @throws InvalidInput as scales
[[nodiscard]] std::optional<double> yield_speed(const Material& first, double first_radius, const Material& second,
                                                double second_radius);

/// The same of any round bodies in consistent units, of reduced mass m: v² = (16/15) (E* R³/m) (πp₀/2E*)⁵, p₀ = 1.6 Y.
/// @throws InvalidInput as point_hertz, and for a mass or a strength outside 1e-100 … 1e100
[[nodiscard]] double yield_speed(const PointPair& pair, double mass, double yield_strength);

}  // namespace stoss::quasistatic
