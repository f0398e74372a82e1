#pragma once

#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// The contact points of an impact, and what all bodies together are there, in units of the first.
struct ContactGrid : Surface {
  ContactPoints points;            ///< for the first body
  std::vector<double> coordinate;  ///< arc length on the circle of the points, R; ascending
};

/// Largest half-width that the contact points can cover, R; 0 for a single point.
[[nodiscard]] double greatest_half_width(const Contact& contact);

/// Half-width of the contact that Hertz' theory expects of an impact at this speed, R; 0 for a single point.
[[nodiscard]] double expected_half_width(const Contact& contact, double speed);

/// How long Hertz' theory expects an impact on a growing contact to last, R/c; on a plate, that of Zener.
[[nodiscard]] double expected_duration(const Contact& contact, double speed);

/// Points from the axis to at least half_width, and what the bodies are there.
/// @throws InvalidInput for a half-width or a number of points that the contact cannot have
[[nodiscard]] ContactGrid contact_grid(const Contact& contact, double half_width, int nodes);

/// What the bodies are at given points.
[[nodiscard]] ContactGrid contact_grid(const Contact& contact, const ContactPoints& points);

/// W of all bodies together: relative displacement of the bodies at point i per force on point j.
[[nodiscard]] std::vector<double> residual_compliance(const Contact& contact, const ContactGrid& grid,
                                                      const Poll& poll = {});

/// V of all bodies together.
[[nodiscard]] std::vector<double> residual_second_moment(const Contact& contact, const ContactGrid& grid,
                                                         const Poll& poll = {});

}  // namespace stoss
