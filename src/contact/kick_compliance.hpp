#pragma once

#include <Eigen/Core>

#include "stoss/contact/contact.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// Adds what kicks of period Δt leave out of the static compliance of the kept modes between the points
/// (docs/numerics.md, section 2): they move a mode under a constant force by (Δt/2ω) cot(ωΔt/2) instead of 1/ω², or by
/// what damping makes of it. With the difference the response to slow forces is exact.
/// @param compliance points × points
void add_kick_compliance(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll,
                         Eigen::MatrixXd& compliance);

}  // namespace stoss
