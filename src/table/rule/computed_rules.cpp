// Where directions do not mix a friction stands for all; of balls all slips at a speed share their normal impacts.
#include "table/rule/computed_rules.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "check.hpp"
#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/oblique/frame.hpp"
#include "restitution/oblique_errors.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {
namespace {

constexpr std::string_view of_value = " (use a larger tolerance";  // than that of a value, not of the table
constexpr double any_friction = 0.01;                              // the sliding stays far below c

/// Motions that slide at s: with equal shares of velocity and spins, then, to compare, by each alone.
std::vector<Obliquity> motions_of(const ObliqueFrame& frame, double sliding, double friction, bool compare) {
  std::vector<Obliquity> single{{.tangential = sliding, .friction = friction}};
  if (sliding != 0.0 && frame.inertia[0] > 0.0) {
    single.push_back({.spin = sliding / frame.radius[0], .friction = friction});
  }
  if (sliding != 0.0 && frame.inertia[1] > 0.0) {
    single.push_back({.second_spin = sliding / frame.radius[1], .friction = friction});
  }
  const double share = 1.0 / static_cast<double>(single.size());
  std::vector<Obliquity> all{{.friction = friction}};
  for (const Obliquity& each : single) {
    all[0].tangential += share * each.tangential;
    all[0].spin += share * each.spin;
    all[0].second_spin += share * each.second_spin;
  }
  if (compare) all.insert(all.end(), single.begin(), single.end());
  return all;
}

/// Refuses the tolerance of a table. @param least of a value
[[noreturn]] void refuse(const std::string& place, std::string reason, double least, const RuleDemand& demand) {
  const std::size_t hint = reason.find(of_value);
  if (hint != std::string::npos) reason.resize(hint);
  throw NotConverged("oblique: at " + place + " " + reason +
                     way_out("allow a larger tolerance", demand.tolerance * least / std::min(demand.sliding, 0.5)));
}

/// Computes rules until both errors are small enough.
std::vector<ObliqueRestitution> accurate(const RuleRequest& request, const std::vector<Obliquity>& before,
                                         const RuleDemand& demand, const std::string& place, const Poll& poll) {
  constexpr double finest = 1e-6;
  double reached = 0.0;  // error of the restitution
  for (double tolerance = std::min(demand.sliding, 0.5); tolerance > finest; tolerance *= 0.5) {
    std::vector<ObliqueRestitution> found;
    try {
      found = motion_along(*request.contact, request.speed, before, {.tolerance = tolerance, .poll = poll});
    } catch (const OutOfReach& error) {
      if (reached > 0.0) break;
      refuse(place, error.what(), error.least, demand);
    }
    const auto open = std::find_if(found.begin(), found.end(), [](const auto& each) { return !each.converged; });
    if (open != found.end() && reached > 0.0) break;
    if (open != found.end() && open->reason.find(of_value) == std::string::npos) {
      throw NotConverged("oblique: at " + place + " " + open->reason);
    }
    if (open != found.end()) refuse(place, open->reason, open->sliding_after.error / scale_of(*open), demand);
    reached = 0.0;
    for (const ObliqueRestitution& each : found) reached = std::max(reached, each.restitution.error);
    if (!demand.friction || reached <= demand.restitution) return found;
  }
  throw NotConverged("oblique: at " + place + " the error of the restitution stays at " + rounded(reached) +
                     ", where the table needs " + rounded(demand.restitution) + " (allow a larger error)");
}

/// Difference of a quantity between two rules, of the finest runs that both have: what runs are off by is alike then.
double difference(const ObliqueRestitution& a, const ObliqueRestitution& b, double ObliqueRun::*quantity) {
  const std::size_t last = std::min(a.runs.size(), b.runs.size()) - 1;
  return std::abs(a.runs[last].*quantity - b.runs[last].*quantity);
}

std::vector<RulePoint> computed(const RuleRequest& request, const RuleDemand& demand, const std::string& place,
                                const Poll& poll) {
  const double friction = demand.friction.value_or(any_friction), limit = friction * request.speed;
  const ObliqueFrame frame(request.contact->at(0, poll), request.speed, {});
  std::vector<Obliquity> before;
  std::vector<std::size_t> begin{0};
  for (const auto& [z, compare] : request.slips) {
    const std::vector<Obliquity> own = motions_of(frame, limit * (1.0 + z) / (1.0 - z), friction, compare);
    before.insert(before.end(), own.begin(), own.end());
    begin.push_back(before.size());
  }
  const std::vector<ObliqueRestitution> found = accurate(request, before, demand, place, poll);
  std::vector<RulePoint> points;
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    const ObliqueRestitution& mixed = found[begin[i]];
    const double sliding = std::abs(mixed.sliding), scale = sliding + limit;
    RulePoint point{mixed.restitution, {mixed.sliding_after.value / scale, mixed.sliding_after.error / scale}};
    for (std::size_t k = begin[i] + 1; k < begin[i + 1]; ++k) {
      const double along = difference(mixed, found[k], &ObliqueRun::sliding_after) / sliding;
      const double normal = difference(mixed, found[k], &ObliqueRun::restitution);
      point.sliding_difference = std::max(point.sliding_difference, along);
      point.restitution_difference = std::max(point.restitution_difference, normal);
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

bool mixes(const RefinableContact& contact, const Poll& poll) {
  const Contact& probe = contact.at(0, poll);
  const std::vector<Contact> along = contacts_along(probe, poll);  // refuses what has none
  if (touch(probe).circle) return false;
  if (probe.second == nullptr || probe.unbounded || contact.part() < 1.0) return true;
  constexpr double rounding = 1e-12;
  const UnitRatios units = units_of(probe, 1);
  const auto one = [](double ratio) { return std::abs(ratio - 1.0) < rounding; };
  return !one(units.length) || !one(units.time) || !one(units.mass) || !one(units.softness) || mixing(along) > rounding;
}

std::vector<std::vector<RulePoint>> computed_rules(const std::vector<RuleRequest>& requests, const RuleDemand& demand,
                                                   int threads, const Poll& poll,
                                                   const std::function<std::string(std::size_t)>& place) {
  using Points = std::vector<RulePoint>;
  // Slips that share nothing are jobs of their own.
  std::vector<std::pair<std::size_t, RuleRequest>> jobs;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const RuleRequest& each = requests[i];
    if (touch(each.contact->at(0, poll)).circle) {
      jobs.emplace_back(i, each);
      continue;
    }
    for (const RuleSlip& slip : each.slips) jobs.emplace_back(i, RuleRequest{each.contact, each.speed, {slip}});
  }
  std::vector<Points> results(requests.size());
  const auto job = [&](std::size_t k, const Poll& own) {
    return computed(jobs[k].second, demand, place(jobs[k].first), own);
  };
  const auto deliver = [&](std::size_t k, Points&& points) {
    Points& own = results[jobs[k].first];
    own.insert(own.end(), points.begin(), points.end());
  };
  run_in_order<Points>(jobs.size(), threads, job, deliver, poll);
  return results;
}

}  // namespace stoss
