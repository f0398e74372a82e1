#include "restitution/ladder/oblique_plan.hpp"

#include <algorithm>
#include <cmath>

#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/recommended.hpp"
#include "restitution/lasting.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

constexpr int last_level = 14;  // cutoff 64 at a wall
constexpr int last_level_of_unstable = 4;
constexpr int last_level_of_too_fine = 8;
constexpr double most_work = 3e9;  // some seconds: what a run without hope may cost

/// Highest level at which whole bodies are computed: the near side of a disk is much less accurate along its edge.
int highest_level_of(const RefinableContact& contact, double stretch, const Poll& poll) {
  if (contact.at(0, poll).unbounded) return std::min(last_level, contact.highest_level(duration_margin * stretch));
  return std::min(last_level, contact.highest_whole_level());
}

/// How two directions that may act on each other err: measured (docs/theory/oblique.md).
/// @param beta     Dundurs' constant
/// @param friction of the one obliquity. With less of it more points slide outward at their limit
void mix(ObliquePlan& plan, double beta, double friction) {
  using namespace calibration;
  plan.spacing *= spacing_where_mixing;
  plan.sign_change = std::min(most_sign_change, sign_change * beta / friction);
  plan.normal = normal_where_mixing * beta * std::min(friction, beta * beta / friction);
  plan.from = beta == 0.0 ? of_one_kind : where_mixing;
}

}  // namespace

ObliquePlan plan_of(const Contact& contact, double speed, const std::vector<Obliquity>& obliquities, double tolerance,
                    const Poll& poll) {
  ObliquePlan plan;
  const ObliqueFrame frame(contact, speed, {});
  double most = 0.0;
  for (const Obliquity& each : obliquities) {
    frame.require(each);
    if (each.friction == 0.0) continue;
    most = std::max(most, each.friction);
    const double sliding = std::abs(frame.sliding(each.tangential, each.spin, each.second_spin));
    plan.allowed = std::min(plan.allowed, tolerance * std::max(1.0, sliding / (each.friction * speed)));
  }
  if (most == 0.0) return plan;
  const std::vector<Contact> along = contacts_along(contact, poll);
  plan.mixing = along.size() > 1;
  plan.spacing = touch(along.front()).softness / touch(contact).softness;
  if (plan.mixing) mix(plan, mixing(along), most);
  plan.unstable = most > stable_friction(along);
  return plan;
}

Levels levels_of(const ObliquePlan& plan, const RefinableContact& contact, double speed, double stretch,
                 const Poll& poll) {
  const int of_stable = plan.mixing && plan.too_fine() ? last_level_of_too_fine : last_level;
  const int last = plan.unstable ? last_level_of_unstable : of_stable;
  const Contact& probe = contact.at(0, poll);
  Levels levels{0, std::min(highest_level_of(contact, stretch, poll), last)};
  const bool known = !is_known_at_a_point(*probe.first) && (!probe.second || !is_known_at_a_point(*probe.second));
  if (known) return levels;
  const Levels of_point = contact.levels(speed, duration_margin, poll, Directions::oblique);
  const int lower = std::max(0, of_point.highest - levels.highest);
  return {of_point.lowest - lower, of_point.highest - lower};
}

bool takes_seconds_after(const Contact& contact, const ObliqueImpact& last, bool rings, std::size_t outcomes) {
  constexpr double growth = 2.0, least_shapes = 8.0;  // with two rungs: √2 times the steps, and more points
  const double points = last.normal.resolution.nodes, modes = static_cast<double>(last.normal.energy.modes.size());
  const auto steps = static_cast<double>(last.normal.steps);
  const double shapes = std::min(points, least_shapes + nyquist_nodes(contact, last.normal.max_half_width));
  const double before = rings ? steps * shapes * shapes : 0.0;
  return growth * steps * (modes + (points * points + before) * static_cast<double>(1 + outcomes)) > most_work;
}

}  // namespace stoss
