#include "restitution/input_uncertainty.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "contact/unit_ratios.hpp"
#include "impact/oblique/frame.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Curvature of what the first or the second body meets, in its units of length.
double curvature_met(const Contact& contact, bool first) {
  if (contact.second == nullptr) return 0.0;
  const double length = units_of(contact, 1).length;
  return first ? contact.second->curvature / length : contact.first->curvature * length;
}

struct Affected {
  Estimate Restitution::*estimate;
  double Impact::*value;
  int length;  ///< power of the unit of length in its unit
};

/// An error to which others are added: those of numbers, which have nothing to do with each other, by their squares.
struct Sum {
  double squares = 0.0, bounds = 0.0;

  Sum() = default;
  explicit Sum(double error) : squares(error * error) {}
  void add(double change, bool is_bound) { is_bound ? bounds += std::abs(change) : squares += change * change; }
  [[nodiscard]] double error() const { return std::sqrt(squares) + bounds; }
};

constexpr double nothing_certain = std::numeric_limits<double>::infinity();

bool is_bound(const Contact& other) {
  return other.first->known.is_bound || (other.second != nullptr && other.second->known.is_bound);
}

constexpr std::array affected{Affected{&Restitution::lost_fraction, &Impact::lost_fraction, 0},
                              Affected{&Restitution::contact_time, &Impact::contact_time, 1},
                              Affected{&Restitution::impulse_time, &Impact::impulse_time, 1},
                              Affected{&Restitution::max_force, &Impact::max_force, -1},
                              Affected{&Restitution::max_compression, &Impact::max_compression, 1}};

}  // namespace

std::vector<Contact> alternatives(const Contact& contact, Affects motion) {
  std::vector<Contact> all;
  for (const bool first : {true, false}) {
    const std::shared_ptr<const Body>& body = first ? contact.first : contact.second;
    if (body == nullptr) continue;
    const auto& others = motion == Affects::both ? body->known.alternatives : body->known.alternatives_along;
    if (!others) continue;
    for (Body& each : others(curvature_met(contact, first))) {
      auto other = std::make_shared<const Body>(std::move(each));
      if (contact.second == nullptr) {
        all.push_back(stoss::contact(std::move(other), contact.wall));
      } else {
        all.push_back(first ? stoss::contact(std::move(other), contact.second)
                            : stoss::contact(contact.first, std::move(other)));
      }
    }
  }
  return all;
}

ImpactOptions options_of(const Contact& other, const Contact& contact, const Impact& impact, const Poll& poll) {
  const double length = other.first->scale.length / contact.first->scale.length;
  ImpactOptions own{.resolution = Resolution(impact.resolution), .poll = poll};
  own.start = impact.start;
  if (own.resolution.step) *own.resolution.step /= length;
  if (own.resolution.half_width) *own.resolution.half_width /= length;
  if (!own.start) return own;
  own.start->center = (contact.extent + own.start->center) / length - other.extent;
  for (double& each : own.start->coordinate) each /= length;
  for (double& each : own.start->momentum) each *= other.mass / contact.mass;
  return own;
}

void add_input_uncertainty(const RefinableContact& contact, double speed, double stretch,
                           const RestitutionOptions& options, Restitution& result) {
  const Impact& finest = result.finest;
  const Contact& resolved = contact.at(result.runs.back().cutoff, stretch, options.poll);
  const std::vector<Contact> others = alternatives(resolved, Affects::both);
  if (others.empty()) return;
  // Of few modes the energies above the cutoff, by which the ladder judges, may be smaller than what is gained or lost.
  result.lost_fraction.error += std::abs(finest.energy_error);
  std::array<Sum, affected.size()> sums{};
  for (std::size_t k = 0; k < affected.size(); ++k) sums[k] = Sum((result.*affected[k].estimate).error);
  for (const Contact& other : others) {
    const double length = other.first->scale.length / resolved.first->scale.length;
    try {
      const Impact changed = impact(other, speed, options_of(other, resolved, finest, options.poll));
      for (std::size_t k = 0; k < affected.size(); ++k) {
        const auto& [estimate, value, power] = affected[k];
        sums[k].add(changed.*value * std::pow(length, power) - finest.*value, is_bound(other));
      }
    } catch (const NotConverged&) {  // the body might be one that cannot be computed: nothing is certain
      sums.fill(Sum(nothing_certain));
    }
  }
  for (std::size_t k = 0; k < affected.size(); ++k) (result.*affected[k].estimate).error = sums[k].error();
  const double error = result.lost_fraction.error, left = std::max(0.0, 1.0 - result.lost_fraction.value);
  result.restitution.error =
      std::isinf(error) ? error : error / (std::sqrt(left + error) + std::abs(result.restitution.value));
}

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

/// The errors of each rule of a group.
using Sums = std::vector<std::array<Sum, doubtful.size()>>;

void add_alternative(const Contact& other, const Contact& resolved, double speed, const ObliqueOptions& options,
                     const Group& group, Sums& sums) {
  const double longer = other.first->scale.length / resolved.first->scale.length;
  try {
    const SharedNormalImpact shared(other, speed,
                                    options_of(other, resolved, group.front()->finest.normal, options.poll));
    for (std::size_t j = 0; j < group.size(); ++j) {
      Obliquity before = group[j]->before;
      before.spin *= longer, before.second_spin *= longer;
      const ObliqueImpact changed = shared.with(before, options.poll);
      for (std::size_t k = 0; k < doubtful.size(); ++k) {
        const auto& [estimate, value, turns] = doubtful[k];
        sums[j][k].add(value(changed) / (turns ? longer : 1.0) - value(group[j]->finest), is_bound(other));
      }
    }
  } catch (const NotConverged&) {  // the body might be one that cannot be computed: nothing is certain
    for (auto& each : sums) each.fill(Sum(nothing_certain));
  }
}

void add_alternatives(const Contact& resolved, double speed, const ObliqueOptions& options, const Group& group) {
  Sums sums(group.size());
  for (std::size_t j = 0; j < group.size(); ++j) {
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      sums[j][k] = Sum((group[j]->*doubtful[k].estimate).error);
    }
  }
  for (const Affects motion : {Affects::both, Affects::along}) {
    for (const Contact& other : alternatives(resolved, motion)) {
      add_alternative(other, resolved, speed, options, group, sums);
    }
  }
  for (std::size_t j = 0; j < group.size(); ++j) {
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      (group[j]->*doubtful[k].estimate).error = sums[j][k].error();
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

void add_oblique_input_uncertainty(const RefinableContact& contact, double speed, double stretch,
                                   const ObliqueOptions& options, std::vector<ObliqueRestitution>& results) {
  const Contact& probe = contact.at(0, options.poll);
  const auto known = [](const auto& body) { return body == nullptr || !is_known_at_a_point(*body); };
  if (known(probe.first) && known(probe.second)) return;
  std::vector<Group> groups;
  for (ObliqueRestitution& each : results) {
    if (each.runs.size() < 2) continue;
    const auto same = [&each](const Group& group) {
      return group.front()->finest.normal.cutoff == each.finest.normal.cutoff;
    };
    const auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found == groups.end()) {
      groups.push_back({&each});
    } else {
      found->push_back(&each);
    }
  }
  for (const Group& group : groups) {
    const Contact& resolved = contact.at(group.front()->finest.normal.cutoff, stretch, options.poll);
    const bool rough = std::any_of(group.begin(), group.end(),
                                   [](const ObliqueRestitution* each) { return each->before.friction > 0.0; });
    if (rough) add_alternatives(resolved, speed, options, group);
    for (ObliqueRestitution* each : group) add_unknown(resolved, *each);
  }
  for (ObliqueRestitution& each : results) {
    if (each.sliding != 0.0) each.tangential_restitution.error = each.sliding_after.error / std::abs(each.sliding);
  }
}

}  // namespace stoss
