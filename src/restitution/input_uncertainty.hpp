#pragma once

#include <vector>

#include "stoss/restitution/oblique.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Adds to the errors of a result what is not known of bodies of which only a point is (Validity): the difference that
/// each of their alternatives makes to the finest impact, by their squares, and as they are where they are bounds.
/// Whether the result has converged is a matter of its runs alone.
/// @param stretch of the contact, as RefinableContact::at
void add_input_uncertainty(const RefinableContact& contact, double speed, double stretch,
                           const RestitutionOptions& options, Restitution& result);

/// Of which motion the alternatives of a body change something.
enum class Affects { both, along };

/// The contact with each of these alternatives of a body in its place.
[[nodiscard]] std::vector<Contact> alternatives(const Contact& contact, Affects affected);

/// How the impact of a contact is repeated with an alternative in its place, which of another curvature has another
/// unit of length: the same step, and the same motion and gap before.
[[nodiscard]] ImpactOptions options_of(const Contact& other, const Contact& contact, const Impact& impact,
                                       const Poll& poll);

/// Adds to the errors of rules what is not known of bodies of which only a point is (Validity), as
/// add_input_uncertainty: what each alternative changes in their finest runs, and what the motions that are taken to be
/// apart may do to each other, twice the velocity along the surface that the normal impulse gives.
/// @param stretch of the contact, as RefinableContact::at
void add_oblique_input_uncertainty(const RefinableContact& contact, double speed, double stretch,
                                   const ObliqueOptions& options, std::vector<ObliqueRestitution>& results);

}  // namespace stoss
