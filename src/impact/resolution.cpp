#include "stoss/impact/resolution.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "impact/grid_size.hpp"

namespace stoss {

double recommended_step(const Contact& contact, double speed, Tail tail) {
  require_speed(speed);
  if (const auto* soft = std::get_if<ExponentialWall>(&contact.wall)) {
    // The edge layer on the soft wall oscillates at about √(α v ω_c), and what first touches it bounces within 1/(α v).
    const double bounce = soft->hardness * speed;
    return 0.25 / std::sqrt(contact.cutoff * (contact.cutoff + bounce) + 0.5 * bounce * bounce);
  }
  if (tail == Tail::radiating) {
    return std::min(0.25 / (contact.cutoff * (1.0 + own_speed(contact, speed))), contact.stable_step);
  }
  // Without damping, the nodes at the edge of the contact bounce the more the faster it spreads.
  return 0.2 / (contact.cutoff * (1.0 + 16.0 * own_speed(contact, speed)));
}

int recommended_nodes(const Contact& contact, double speed) {
  require_speed(speed);
  return nodes_within(contact, initial_half_width(contact, speed));
}

}  // namespace stoss
