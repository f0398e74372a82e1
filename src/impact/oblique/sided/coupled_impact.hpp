#pragma once

#include <vector>

#include "stoss/impact/oblique.hpp"

namespace stoss {

/// An oblique impact of bodies in which both directions act on each other, as disks (ObliqueCollision).
/// @param along the contact against forces along the surface, of both parities (contacts_along)
/// @throws as oblique_impact; InvalidInput for the quasistatic tail, on which friction flutters; NotConverged where no
///         forces obey Coulomb's law
[[nodiscard]] ObliqueImpact coupled_impact(const Contact& contact, const std::vector<Contact>& along, double speed,
                                           const Obliquity& obliquity, const ImpactOptions& options,
                                           const ObliqueObservation& observation);

}  // namespace stoss
