#include "contact/demands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stoss {
namespace {

const ExponentialWall* soft_wall(const Contact& contact) { return std::get_if<ExponentialWall>(&contact.wall); }

}  // namespace

double resolving_step(const Contact& contact, Tail tail, double speed) {
  if (const auto* soft = soft_wall(contact)) {
    // The edge layer on the soft wall oscillates at about √(α v ω_c), and what first touches it bounces within 1/(α v).
    const double bounce = soft->hardness * speed;
    return 0.25 / std::sqrt(contact.cutoff * (contact.cutoff + bounce) + 0.5 * bounce * bounce);
  }
  if (tail == Tail::radiating) {
    return std::min(0.25 / (contact.cutoff * (1.0 + mach_number(contact, speed))), contact.stable_step);
  }
  // Without damping, the nodes at the edge of the contact bounce the more the faster it spreads.
  return 0.2 / (contact.cutoff * (1.0 + 16.0 * mach_number(contact, speed)));
}

double pushing_gap(const Contact& contact) {
  const ExponentialWall* soft = soft_wall(contact);
  return soft == nullptr ? 0.0 : 30.0 / soft->hardness;
}

double needed_nodes(const Contact& contact, double half_width) {
  const ExponentialWall* soft = soft_wall(contact);
  return soft == nullptr ? 0.0 : std::max(128.0, soft->hardness * half_width * half_width);
}

double force_free_distance(const Contact& contact, double reach, double speed, double half_width) {
  if (const auto* soft = soft_wall(contact)) {
    constexpr double negligible = 1e-12, edge = 2.0 * std::numbers::pi;  // at least that of any body
    const double energy = 0.5 * contact.mass * speed * speed;
    return reach + std::max(0.0, std::log(soft->strength * edge / (negligible * energy))) / soft->hardness;
  }
  // Beyond the first spacing of nodes, where a hard contact begins to push, and some steps.
  return reach + 0.02 * half_width * half_width + speed / contact.cutoff;
}

}  // namespace stoss
