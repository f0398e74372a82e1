#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/oblique_snapshot.hpp"

namespace stoss {

/// Whether contact points lie on both sides of the axis; else they are rings, or a single one.
[[nodiscard]] bool is_sided(const Contact& contact);

/// The points of a contact with nothing on them, in order of their places.
[[nodiscard]] std::vector<ObliquePoint> points_at_rest(const Contact& contact, const ContactGrid& grid);

/// Sums up the points of an instant, and says what they do. @param unit force in units of which they are
void show_points(std::vector<ObliquePoint>& points, double unit, ObliqueSnapshot& now);

}  // namespace stoss
