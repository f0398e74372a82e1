// Each slip is computed for every way in which the bodies can slide. Without mixing directions all slips of a speed
// share their normal impacts, and a friction stands for all.
#include "table/computed_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/oblique_frame.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {
namespace {

constexpr double any_friction = 0.01;  // the sliding stays far below c

/// The ways to slide at s, each with a share 1 of it.
std::vector<Obliquity> ways(const ObliqueFrame& frame, double sliding, double friction) {
  std::vector<Obliquity> all{{.tangential = sliding, .friction = friction}};
  if (sliding == 0.0) return all;
  if (frame.inertia[0] > 0.0) all.push_back({.spin = sliding / frame.radius[0], .friction = friction});
  if (frame.inertia[1] > 0.0) all.push_back({.second_spin = sliding / frame.radius[1], .friction = friction});
  return all;
}

/// Computes rules until both errors are small enough.
std::vector<ObliqueRestitution> accurate(const RuleRequest& request, const std::vector<Obliquity>& before,
                                         const RuleDemand& demand, const std::string& place, const Poll& poll) {
  constexpr double least = 1e-6;
  double tolerance = std::min(demand.sliding, 0.5);
  for (;;) {
    std::vector<ObliqueRestitution> found =
        oblique_restitution(*request.contact, request.speed, before, {.tolerance = tolerance, .poll = poll});
    bool enough = true;
    for (const ObliqueRestitution& each : found) {
      if (!each.converged) throw NotConverged("oblique: at " + place + " " + each.reason);
      enough = enough && (!demand.friction || each.restitution.error <= demand.restitution);
    }
    if (enough) return found;
    tolerance *= 0.5;
    if (tolerance < least) throw NotConverged("oblique: at " + place + " the error of the restitution stays too large");
  }
}

/// Mean of values, with the largest of their errors, and half of their range.
std::pair<Estimate, double> mean(const std::vector<Estimate>& values) {
  double low = values.front().value, high = low, error = 0.0;
  for (const Estimate& each : values) {
    low = std::min(low, each.value), high = std::max(high, each.value), error = std::max(error, each.error);
  }
  return {{0.5 * (low + high), error}, 0.5 * (high - low)};
}

std::vector<RulePoint> computed(const RuleRequest& request, const RuleDemand& demand, const std::string& place,
                                const Poll& poll) {
  const double friction = demand.friction.value_or(any_friction), limit = friction * request.speed;
  const ObliqueFrame frame(request.contact->at(0, poll), request.speed, {});
  std::vector<Obliquity> before;
  std::vector<std::size_t> count;
  for (const double z : request.slips) {
    const std::vector<Obliquity> own = ways(frame, limit * (1.0 + z) / (1.0 - z), friction);
    before.insert(before.end(), own.begin(), own.end());
    count.push_back(own.size());
  }
  const std::vector<ObliqueRestitution> found = accurate(request, before, demand, place, poll);
  std::vector<RulePoint> points;
  auto next = found.begin();
  for (std::size_t i = 0; i < count.size(); ++i) {
    const double sliding = std::abs(next->sliding), scale = sliding + limit;
    std::vector<Estimate> normal, along;
    for (std::size_t k = 0; k < count[i]; ++k, ++next) {
      normal.push_back(next->restitution);
      along.push_back({next->sliding_after.value / scale, next->sliding_after.error / scale});
    }
    const auto [restitution, restitution_half] = mean(normal);
    const auto [after, after_half] = mean(along);
    points.push_back({restitution, after, restitution_half, sliding > 0.0 ? after_half * scale / sliding : 0.0});
  }
  return points;
}

}  // namespace

bool mixes(const RefinableContact& contact, const Poll& poll) {
  const Contact& probe = contact.at(0, poll);
  if (touch(probe).circle) return false;
  if (probe.second == nullptr || probe.unbounded || contact.part() < 1.0) return true;
  constexpr double rounding = 1e-12;
  const UnitRatios units = units_of(probe, 1);
  const auto one = [](double ratio) { return std::abs(ratio - 1.0) < rounding; };
  return !one(units.length) || !one(units.time) || !one(units.mass) || !one(units.softness) ||
         mixing(contacts_along(probe, poll)) > rounding;
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
    for (const double z : each.slips) jobs.emplace_back(i, RuleRequest{each.contact, each.speed, {z}});
  }
  std::vector<Points> results(requests.size());
  const auto job = [&](std::size_t k, const Poll& heed) {
    return computed(jobs[k].second, demand, place(jobs[k].first), heed);
  };
  const auto deliver = [&](std::size_t k, Points&& points) {
    Points& own = results[jobs[k].first];
    own.insert(own.end(), points.begin(), points.end());
  };
  run_in_order<Points>(jobs.size(), threads, job, deliver, poll);
  return results;
}

}  // namespace stoss
