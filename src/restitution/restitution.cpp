#include "stoss/restitution/restitution.hpp"

#include <utility>

#include "check.hpp"
#include "restitution/ladder/central_problem.hpp"

namespace stoss {

RestitutionNotConverged::RestitutionNotConverged(Restitution result)
    : NotConverged("restitution: " + result.reason), best(std::move(result)) {}

void validate(const RefinableContact& contact, double speed, const Vibration& vibration, const Poll& poll) {
  require_speed(speed);
  of_own_choice([&] {
    const Levels levels = contact.levels(speed, duration_margin, poll);
    const int lowest = lowest_level(contact, vibration, levels, poll);
    (void)approach(contact.at(contact.cutoff(lowest), 1.0, poll), speed, vibration);
  });
}

Restitution restitution(const RefinableContact& contact, double speed, const RestitutionOptions& options) {
  require_tolerance(options.tolerance, options.absolute);
  require_speed(speed);
  return of_own_choice([&] {
    CentralProblem problem(contact, speed, options);
    climb(problem.where, problem);
    return problem.concluded();
  });
}

Restitution restitution(const BodyMaker& maker, double speed, const RestitutionOptions& options) {
  return restitution(RefinableContact(maker), speed, options);
}

}  // namespace stoss
