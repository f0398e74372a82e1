#pragma once

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Adds to the errors of a result what is not known of bodies of which only a point is (Knowledge): the difference that
/// each of their alternatives makes to the finest impact, and the share that is neglected. Whether the result has
/// converged is a matter of its runs alone.
/// @param stretch of the contact, as RefinableContact::at
void add_doubts(const RefinableContact& contact, double speed, double stretch, const RestitutionOptions& options,
                Restitution& result);

}  // namespace stoss
