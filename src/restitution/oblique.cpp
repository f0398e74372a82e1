// Runs at rising cutoffs for several obliquities at once, until the error of each s′ is small enough.
#include "stoss/restitution/oblique.hpp"

#include <algorithm>
#include <utility>

#include "check.hpp"
#include "contact/touch.hpp"
#include "restitution/input_uncertainty.hpp"
#include "restitution/ladder/oblique_problem.hpp"
#include "restitution/neglected_coupling.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

/// @returns the stretch of the last contact
double refine(const RefinableContact& contact, const ObliqueOptions& options, std::vector<ObliqueRestitution*> open,
              Content content) {
  ObliqueProblem problem(contact, options, std::move(open), content);
  try {
    climb(problem.where, problem.between(), problem);
  } catch (const DoesNotEnd& error) {
    problem.where.trouble = error.what();
  }
  problem.conclude();
  return problem.where.stretch;
}

std::vector<ObliqueRestitution> results_of(const RefinableContact& contact, double speed,
                                           const std::vector<Obliquity>& obliquities, const ObliqueOptions& options,
                                           Content content) {
  require_tolerance(options);
  require_speed(speed);
  std::vector<ObliqueRestitution> results;
  for (const Obliquity& obliquity : obliquities) {
    results.emplace_back();
    results.back().speed = speed, results.back().before = obliquity, results.back().tolerance = options.tolerance;
  }
  if (results.empty()) return results;
  const bool shared = touch(contact.at(0, options.poll)).circle;
  std::vector<ObliqueRestitution*> all;
  for (ObliqueRestitution& each : results) {
    all.push_back(&each);
    if (!shared) (void)refine(contact, options, {&each}, content);
  }
  const double stretch = shared ? refine(contact, options, all, content) : 1.0;
  if (shared && content == Content::all) {
    NeglectedCoupling neglected(contact, speed, options.poll);
    for (ObliqueRestitution& each : results) each.neglected = neglected.at(each.before);
  }
  const auto like_central = [&](const ObliqueRestitution& each) {
    return content == Content::all && (shared || each.before.friction == 0.0);
  };
  if (std::any_of(results.begin(), results.end(), like_central)) {
    const Restitution central =
        best_restitution(contact, speed, {.poll = options.poll, .vibration = options.vibration});
    for (ObliqueRestitution& each : results) {
      if (like_central(each)) each.restitution = central.restitution;
    }
  }
  if (shared) add_oblique_input_uncertainty(contact, speed, stretch, options, results);
  return results;
}

}  // namespace

std::vector<ObliqueRestitution> motion_along(const RefinableContact& contact, double speed,
                                             const std::vector<Obliquity>& obliquities, const ObliqueOptions& options) {
  return results_of(contact, speed, obliquities, options, Content::motion_along);
}

std::vector<ObliqueRestitution> oblique_restitution(const RefinableContact& contact, double speed,
                                                    const std::vector<Obliquity>& obliquities,
                                                    const ObliqueOptions& options) {
  return results_of(contact, speed, obliquities, options, Content::all);
}

ObliqueRestitution oblique_restitution(const RefinableContact& contact, double speed, const Obliquity& obliquity,
                                       const ObliqueOptions& options) {
  ObliqueRestitution result = std::move(oblique_restitution(contact, speed, std::vector{obliquity}, options).front());
  if (result.runs.size() < 2) throw NotConverged(result.reason);
  return result;
}

}  // namespace stoss
