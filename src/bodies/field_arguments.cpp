#include "bodies/field_arguments.hpp"

#include <limits>
#include <numbers>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {

void require_finite(std::string_view name, std::span<const double> numbers, std::string_view hint) {
  constexpr double largest = std::numeric_limits<double>::max();
  for (const double number : numbers) require(name, number, {-largest, largest, true, true, "finite numbers"}, hint);
}

void require_length(const std::string& name, std::size_t length, std::size_t wanted, const std::string& hint) {
  if (length == wanted) return;
  throw InvalidInput::out_of_range(name, std::to_string(length) + " values", std::to_string(wanted), hint);
}

void require_points(const bodies::PolarGrid& points, const std::string& kind) {
  const auto radii = static_cast<long>(points.radius.size()), angles = static_cast<long>(points.angle.size());
  require("radius count", radii, 1, 1'000'000, "radii of the points");
  require("angle count", angles, 1, 1'000'000, "angles of the points");
  require("point count", radii * angles, 1, 100'000'000, "radii times angles");
  constexpr Range inside{0.0, 1.0, true, true, "0 to 1"};
  for (const double radius : points.radius) require("radius", radius, inside, "in units of the radius of the " + kind);
  require_finite("angle", points.angle, "radians from the direction of the wall");
}

void require_nodes(const ContactPoints& contact, const Range& radius, const std::string& hint) {
  require("contact nodes", static_cast<long>(contact.count), 1, 5'000'000, "of the grid of the impact");
  require("contact radius", contact.radius, radius, hint);
  constexpr Range circle{2e-7, std::numbers::pi, true, true, "2e-7 to pi"};
  require("contact spacing", contact.spacing, circle, "of the points on their circle, radians");
}

}  // namespace stoss
