#pragma once

#include <Eigen/Core>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// What the rings of an outward impact feel in a step.
struct OutwardStep {
  Eigen::VectorXd force;     ///< f of each
  Eigen::VectorXd friction;  ///< q, outward on what meets the first body
  Eigen::VectorXd slip;      ///< how far each has slid outward in the step
  Eigen::VectorXd give;      ///< D of each, where both directions are equally soft (edge_compliance_along)
};

/// A central impact of balls whose surfaces rub each other as pressure moves them inward, then lets them go.
struct OutwardImpact {
  ObliqueImpact impact;
  double momentum = 0.0;  ///< along the normal that is left to a ball that stays on a plate, and goes into it
  FixedResolution resolution;
  std::vector<OutwardStep> steps;  ///< from the first force to the first after the last
};

/// Computes a central impact of balls at rest with Coulomb's law at every ring, which moves along the axis and outward:
/// both directions act on each other. Friction is no less than 0; without it both still act on each other in the modes
/// above the cutoff, so that ε_n differs from that of `impact` by some 1e-6.
/// @param outward the contact against forces alike all around the axis (contact_outward)
/// @throws InvalidInput for a speed, and a resolution, out of range; NotConverged as coupled_impact
[[nodiscard]] OutwardImpact outward_impact(const Contact& contact, const Contact& outward, double speed,
                                           double friction, const Resolution& resolution, const Poll& poll = {});

}  // namespace stoss
