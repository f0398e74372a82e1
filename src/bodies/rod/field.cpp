#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/field_arguments.hpp"
#include "check.hpp"
#include "stoss/bodies/rod/field.hpp"

namespace stoss::bodies::rod {

Field field(const Body& body, std::span<const double> coordinate, double force, const std::vector<double>& place) {
  require_length("coordinate", coordinate.size(), mode_count(body), "one for every kept mode of the rod");
  require_finite("coordinate", coordinate, "of the kept modes");
  require_finite("force", {&force, 1}, "on the struck end, EA");
  Field result;
  for (const double s : place) {
    require("place", s, {0.0, 1.0, true, true, "0 to 1"}, "distance from the struck end, L");
    double displacement = -force * (1.0 / 3.0 - s + 0.5 * s * s), stress = -force * (1.0 - s);
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      for (const double omega : group.omega) {
        const double moved = std::numbers::sqrt2 * coordinate[k++] + 2.0 * force / (omega * omega);
        displacement += moved * std::cos(omega * s);
        stress += moved * omega * std::sin(omega * s);
      }
    }
    result.displacement.push_back(displacement);
    result.stress.push_back(stress);
  }
  return result;
}

}  // namespace stoss::bodies::rod
