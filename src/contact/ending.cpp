#include "contact/ending.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "contact/faces/coats.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"

namespace stoss {
namespace {

/// The longest period of what is held, with the first body on it, in R/c of that; 0 of what is not.
double slowest_swing(const Contact& contact) {
  if (!contact.second || !contact.second->held) return 0.0;
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t k = contact.first_groups; k < contact.groups.size(); ++k) {
    for (const double omega : contact.groups[k].omega) slowest = std::min(slowest, omega);
  }
  const double carried = contact.first->mass / (contact.second->mass * units_of(contact, 1).mass);
  return 2.0 * std::numbers::pi / slowest * std::sqrt(1.0 + carried);
}

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
  // What is held swings back, and may strike the first body again, until that has left it.
  constexpr double swings = 20.0;
  return std::max(of_balls * softer * heavier * longest_time(contact), swings * slowest_swing(contact));
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
