#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// Projected area that each point and its mirror image stand for, R² or, on a line, R; 1 for flat ends. A sum over
/// rings from the middle of the first on is the integral but for h²/24 times the value on the axis (Euler and
/// Maclaurin), which the first ring lacks here.
[[nodiscard]] std::vector<double> projected_areas(const Contact& contact, const ContactPoints& points);

}  // namespace stoss
