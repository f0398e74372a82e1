#pragma once

#include "stoss/contact/contact.hpp"

/// What the law of a contact asks of an impact before it is computed. Lengths are in R, times in R/c.
namespace stoss {

/// Time step that resolves the contact law.
[[nodiscard]] double resolving_step(const Contact& contact, Tail tail, double speed);

/// Force of rough faces from which they count as touching while an impact goes on; 0 between smooth ones.
/// @param speed of an impact with all the energy there is
[[nodiscard]] double force_that_counts(const Contact& contact, double speed);

/// Gap up to which points push that have not touched; 0 at a hard contact.
[[nodiscard]] double pushing_gap(const Contact& contact);

/// Contact points within a half-width that it needs, besides those for the modes.
[[nodiscard]] double needed_nodes(const Contact& contact, Tail tail, double half_width);

/// Distance from first touch at which bodies that vibrate feel nothing of each other.
/// @param reach      of the vibration
/// @param half_width of the contact that is expected
[[nodiscard]] double force_free_distance(const Contact& contact, double reach, double speed, double half_width);

}  // namespace stoss
