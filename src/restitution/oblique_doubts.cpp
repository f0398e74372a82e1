#include "restitution/oblique_doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "contact/unit_ratios.hpp"
#include "impact/oblique/frame.hpp"
#include "restitution/doubts.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// A value with an error, and whether it is in units of c/R.
struct Doubtful {
  Estimate ObliqueRestitution::*estimate;
  double (*value)(const ObliqueImpact&);
  bool turns;
};

constexpr std::array doubtful{
    Doubtful{&ObliqueRestitution::sliding_after, [](const ObliqueImpact& its) { return its.sliding_after; }, false},
    Doubtful{&ObliqueRestitution::tangential_after, [](const ObliqueImpact& its) { return its.tangential_after; },
             false},
    Doubtful{&ObliqueRestitution::spin_after, [](const ObliqueImpact& its) { return its.spin_after; }, true},
    Doubtful{&ObliqueRestitution::second_spin_after, [](const ObliqueImpact& its) { return its.second_spin_after; },
             true},
    Doubtful{&ObliqueRestitution::friction_loss, [](const ObliqueImpact& its) { return its.energy.friction; }, false},
    Doubtful{&ObliqueRestitution::vibration,
             [](const ObliqueImpact& its) { return its.energy.vibration + its.energy.second_vibration; }, false}};

/// Rules that ended at one cutoff.
using Group = std::vector<ObliqueRestitution*>;

void add_alternative(const Contact& other, const Contact& resolved, double speed, const ObliqueOptions& options,
                     const Group& group) {
  const double longer = other.first->scale.length / resolved.first->scale.length;
  try {
    const Slides slides(other, speed, options_of(other, resolved, group.front()->finest.normal, options.poll));
    for (ObliqueRestitution* each : group) {
      Obliquity before = each->before;
      before.spin *= longer, before.second_spin *= longer;
      const ObliqueImpact changed = slides.after(before, options.poll);
      for (const auto& [estimate, value, turns] : doubtful) {
        const double unit = turns ? longer : 1.0;
        (each->*estimate).error += std::abs(value(changed) / unit - value(each->finest));
      }
    }
  } catch (const NotConverged&) {  // the body might be one that cannot be computed: nothing is certain
    for (ObliqueRestitution* each : group) {
      for (const Doubtful& its : doubtful) (each->*its.estimate).error = std::numeric_limits<double>::infinity();
    }
  }
}

/// Of both bodies, in units of the first.
double cross_mobility(const Contact& contact, double duration) {
  double sum = 0.0;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || !body->known.cross_mobility) continue;
    const UnitRatios units = units_of(contact, number);
    sum += body->known.cross_mobility(duration / units.time) / units.mass;
  }
  return sum;
}

void add_unknown(const Contact& contact, ObliqueRestitution& result) {
  const ObliqueImpact& finest = result.finest;
  const Obliquity& before = result.before;
  const ObliqueFrame frame(contact, result.speed, {});
  const double impulse = frame.mass * (1.0 + std::abs(finest.restitution)) * result.speed;
  const double given = 2.0 * impulse * cross_mobility(contact, finest.normal.contact_time);
  result.sliding_after.error += given;
  result.tangential_after.error += given;
  if (frame.inertia[0] > 0.0) result.spin_after.error += given / frame.radius[0];
  if (frame.inertia[1] > 0.0) result.second_spin_after.error += given / frame.radius[1];
  result.restitution.error += before.friction * given / (2.0 * result.speed);
}

}  // namespace

void add_oblique_doubts(const RefinableContact& contact, double speed, double stretch, const ObliqueOptions& options,
                        std::vector<ObliqueRestitution>& results) {
  const Contact& probe = contact.at(0, options.poll);
  const auto known = [](const auto& body) { return body == nullptr || !is_known_at_a_point(*body); };
  if (known(probe.first) && known(probe.second)) return;
  std::vector<Group> groups;
  for (ObliqueRestitution& each : results) {
    if (each.runs.size() < 2) continue;
    const auto same = [&each](const Group& group) {
      return group.front()->runs.back().cutoff == each.runs.back().cutoff;
    };
    const auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found == groups.end()) {
      groups.push_back({&each});
    } else {
      found->push_back(&each);
    }
  }
  for (const Group& group : groups) {
    const Contact& resolved = contact.at(group.front()->runs.back().cutoff, stretch, options.poll);
    for (ObliqueRestitution* each : group) add_unknown(resolved, *each);
    const bool rough = std::any_of(group.begin(), group.end(),
                                   [](const ObliqueRestitution* each) { return each->before.friction > 0.0; });
    if (!rough) continue;
    for (const Affects motion : {Affects::both, Affects::along}) {
      for (const Contact& other : alternatives(resolved, motion)) {
        add_alternative(other, resolved, speed, options, group);
      }
    }
  }
  for (ObliqueRestitution& each : results) {
    if (each.sliding != 0.0) each.tangential_restitution.error = each.sliding_after.error / std::abs(each.sliding);
  }
}

}  // namespace stoss
