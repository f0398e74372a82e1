#pragma once

#include <vector>

#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// Adds to the errors of rules what is not known of bodies of which only a point is (Knowledge), as add_doubts: what
/// each alternative changes in their finest runs, and what the motions
/// that are taken to be apart may do to each other, twice the velocity along the surface that the normal impulse gives.
/// @param stretch of the contact, as RefinableContact::at
void add_oblique_doubts(const RefinableContact& contact, double speed, double stretch, const ObliqueOptions& options,
                        std::vector<ObliqueRestitution>& results);

}  // namespace stoss
