#pragma once

#include <Eigen/Core>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// Adds the compliance between the points with which the kept modes follow a force at once, beside the kicks of period
/// Δt. Without losses it is what the kicks leave out (docs/numerics.md, section 2): they move a mode under a constant
/// force by (Δt/2ω) cot(ωΔt/2) instead of 1/ω². In a lossy contact it is more, and the kicks are weaker by as much
/// (numeric::stable_kicks). In both the response to slow forces is exact.
/// @param compliance points × points
void add_kick_compliance(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll,
                         Eigen::Ref<Eigen::MatrixXd> compliance);

}  // namespace stoss
