#include "contact/demands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stoss {
namespace {

double lowest_frequency(const Contact& contact) {
  double lowest = contact.cutoff;
  for (const ModeGroup& group : contact.groups) {
    for (const double omega : group.omega) lowest = std::min(lowest, omega);
  }
  return lowest;
}

}  // namespace

double resolving_step(const Contact& contact, Tail tail, double speed) {
  if (tail == Tail::none) {
    // The edge layer on the soft wall oscillates at about √(α v ω_c), and what first touches it bounces within 1/(α v).
    const double bounce = speed / contact.asperities;
    return 0.25 / std::sqrt(contact.cutoff * (contact.cutoff + bounce) + 0.5 * bounce * bounce);
  }
  if (tail == Tail::radiating) {
    return std::min(0.25 / (contact.cutoff * (1.0 + mach_number(contact, speed))), contact.stable_step);
  }
  // Without damping, the nodes at the edge of the contact bounce the more the faster it spreads.
  return 0.2 / (contact.cutoff * (1.0 + 16.0 * mach_number(contact, speed)));
}

double force_that_counts(const Contact& contact, double speed) {
  if (contact.asperities == 0.0) return 0.0;
  constexpr double share = 1e-3;
  return share * contact.mass * speed * std::min(lowest_frequency(contact), speed / contact.asperities);
}

double pushing_gap(const Contact& contact) { return 30.0 * contact.asperities; }

double needed_nodes(const Contact& contact, Tail tail, double half_width) {
  return tail == Tail::none ? std::max(128.0, half_width * half_width / contact.asperities) : 0.0;
}

double force_free_distance(const Contact& contact, double reach, double speed, double half_width) {
  if (contact.asperities > 0.0) {
    constexpr double negligible = 1e-12, edge = 2.0 * std::numbers::pi;  // at least that of any body
    const double energy = 0.5 * contact.mass * speed * speed;
    return reach + std::max(0.0, std::log(contact.strength * edge / (negligible * energy))) * contact.asperities;
  }
  // Beyond the first spacing of nodes, where a hard contact begins to push, and some steps.
  return reach + 0.02 * half_width * half_width + speed / contact.cutoff;
}

}  // namespace stoss
