#include "contact/ending.hpp"

#include <algorithm>
#include <cmath>

#include "contact/faces/coats.hpp"
#include "contact/touch.hpp"

namespace stoss {
namespace {

double longest_duration(const Contact& contact) {
  // R/c of the slower body. An impact of disks lasts 5 to 30; that of spheres grows as v^(−1/5), to 200 at v = 1e-8.
  constexpr double usual = 200.0, of_balls = 1000.0;
  const double softer = std::sqrt(1.0 + coat_compliance(contact) / std::max(touch(contact).softness, 1e-12));
  // A contact that outlasts what stands for a half-space is given up soon after.
  if (contact.keeps_displacement) return echo_time(contact);
  if (contact.unbounded) return 2.0 * echo_time(contact);
  if (!touch(contact).circle) return softer * usual * longest_time(contact);
  // Of the mass of a sphere; heavier ones take longer, as Hertz has it.
  constexpr double of_a_sphere = 4.1887902047863910;
  const double heavier = std::pow(std::max(1.0, contact.whole_mass / of_a_sphere), 0.4);
  return of_balls * softer * heavier * longest_time(contact);
}

}  // namespace

Ending ending(const Contact& contact) {
  return {.longest = longest_duration(contact),
          .known = echo_time(contact),
          .is_given_up = contact.unbounded,
          .may_stay = contact.keeps_displacement,
          .foreseen = !loses(contact) && !contact.unbounded};
}

}  // namespace stoss
