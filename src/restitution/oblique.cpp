// Runs at rising cutoffs for several obliquities at once, until the error of each s′ is small enough.
#include "stoss/restitution/oblique.hpp"

#include <algorithm>
#include <utility>

#include "check.hpp"
#include "contact/touch.hpp"
#include "restitution/input_uncertainty.hpp"
#include "restitution/ladder/oblique_problem.hpp"
#include "restitution/neglected_coupling.hpp"

namespace stoss {
namespace {

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
  if (!touch(contact.at(0, options.poll)).circle) {
    for (ObliqueRestitution& each : results) (void)ObliqueProblem(contact, options, {&each}, content).solve();
    return results;
  }
  std::vector<ObliqueRestitution*> with_friction, without;
  for (ObliqueRestitution& each : results) (each.before.friction > 0.0 ? with_friction : without).push_back(&each);
  double stretch = 1.0;
  for (const auto& part : {without, with_friction}) {
    if (!part.empty()) stretch = ObliqueProblem(contact, options, part, content).solve();
  }
  if (content == Content::all) {
    NeglectedCoupling neglected(contact, speed, options.poll);
    for (ObliqueRestitution& each : results) each.neglected = neglected.at(each.before);
  }
  add_oblique_input_uncertainty(contact, speed, stretch, options, results);
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
