#include "contact/faces/coats.hpp"

#include <cmath>
#include <numbers>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"

namespace stoss {

double coat_compliance(const Contact& contact) {
  double sum = 0.0;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || body->coat.compliance == 0.0) continue;
    const UnitRatios units = units_of(contact, number);
    sum += body->coat.compliance * units.length / units.stress;
  }
  return sum;
}

double coat_compression(const Contact& contact, double speed) {
  const double compliance = coat_compliance(contact), energy = 0.5 * contact.whole_mass * speed * speed;
  if (compliance == 0.0) return 0.0;
  const Touch met = touch(contact);
  if (has_single_point(contact)) return std::sqrt(2.0 * energy * compliance);
  // Overlap of the surfaces over the compliance: F = πδ²/κC on a circle, (4√2/3) δ^{3/2}/√κC on a line.
  if (met.circle) return std::cbrt(3.0 * energy * met.curvature * compliance / std::numbers::pi);
  return std::pow(1.875 / std::numbers::sqrt2 * energy * std::sqrt(met.curvature) * compliance, 0.4);
}

}  // namespace stoss
