#include "restitution/ladder/central_problem.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "check.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/inputs.hpp"
#include "impact/recommended.hpp"
#include "restitution/error_bar.hpp"
#include "restitution/input_uncertainty.hpp"

namespace stoss {
namespace {

/// @param energy initial energy of an impact, over that of the translation
Run summary(const Impact& impact, double energy) {
  return {.cutoff = impact.cutoff,
          .resolution = impact.resolution,
          .lost_fraction = impact.lost_fraction,
          .dissipated = energy * impact.energy.dissipated,
          .unresolved = energy * impact.energy.unresolved,
          .remaining = impact.remaining,
          .contact_time = impact.contact_time,
          .impulse_time = impact.impulse_time,
          .max_force = impact.max_force,
          .max_compression = impact.max_compression,
          .energy_error = impact.energy_error,
          .steps = impact.steps};
}

/// Initial energy over that of the translation.
double whole_energy(const Vibration& vibration) {
  double sum = 1.0;
  for (const Oscillation& mode : vibration) sum += mode.energy;
  return sum;
}

}  // namespace

int lowest_level(const RefinableContact& contact, const Vibration& vibration, const Levels& levels, const Poll& poll) {
  const auto at = [&](int level) -> const Contact& { return contact.at(contact.cutoff(level), 1.0, poll); };
  for (int level = levels.lowest; level <= levels.highest; ++level) {
    if (keeps(at(level), vibration)) return level;
  }
  const Contact& finest = at(levels.highest);
  for (const Oscillation& mode : vibration) {
    require_possible(finest, mode);
    if (keeps(finest, {mode})) continue;
    throw InvalidInput::out_of_range("vibration", named(mode),
                                     "modes that it has up to " + shown_most(contact.cutoff(levels.highest)) +
                                         " c/R, the most that is computed at this speed",
                                     "let fewer modes vibrate");
  }
  return levels.highest;
}

CentralProblem::CentralProblem(const RefinableContact& contact, double speed, const RestitutionOptions& options)
    : where{contact, speed, options.poll, contact.stretch(speed), contact.levels(speed, duration_margin, options.poll)},
      options_(options),
      correction_(curvature_correction(contact, speed, options.poll)),
      order_(convergence_order(where.probe(), speed)),
      energy_(whole_energy(options.vibration)),
      next_{.rungs = second_rung(where.probe())} {
  where.levels.lowest -= levels_below(where.probe(), speed, where.stretch);
  where.levels.lowest = lowest_level(contact, options.vibration, where.levels, options.poll);
  result_.tolerance = options.tolerance;
  result_.absolute = options.absolute;
}

const Contact& CentralProblem::unstretched(int level) const {
  if (where.probe().unbounded) return where.at(level);  // which tells the same, and has been made
  return where.contact.at(where.contact.cutoff(level), 1.0, options_.poll);
}

void CentralProblem::begin(int level) const {
  if (!options_.attempt_observer) return;
  const bool told = result_.runs.size() >= fewest_runs;
  options_.attempt_observer({where.contact.cutoff(level), told ? result_.lost_fraction : Estimate{}});
}

ImpactOptions CentralProblem::options_at(const Contact& resolved) const {
  const double half_width = known_half_width(resolved, where.speed, result_.finest);
  ImpactOptions options{.resolution = refined_resolution(resolved, where.speed, half_width), .poll = options_.poll};
  if (!options_.vibration.empty()) options.start = approach(resolved, where.speed, options_.vibration);
  return options;
}

void CentralProblem::take(Impact impact, int level) {
  result_.finest = std::move(impact);
  correct(correction_, unstretched(level), result_.finest);
}

void CentralProblem::compute(const Contact& resolved, int level) {
  take(impact(resolved, where.speed, options_at(resolved)), level);
}

int CentralProblem::add(int level) {
  result_.runs.push_back(summary(result_.finest, energy_));
  result_.steps += result_.finest.steps;
  const std::size_t runs = result_.runs.size();
  if (runs < 2) return next_.rungs;
  conclude(unstretched(level), where.speed, correction_, result_);
  const int above = where.levels.highest - level;
  if (runs < fewest_runs) return next_.rungs = third_rung(result_, order_, where.highest_cutoff(), above);
  if (result_.converged) return 0;
  const bool stays = result_.finest.remaining > wanted_error(result_);
  where.trouble = stays ? stays_open(result_) : out_of_reach(correction_, result_);
  if (!where.trouble.empty()) return 0;
  if (!first_) first_ = reached(result_);
  next_ = outlook(result_, *first_, order_, where.highest_cutoff());
  if (above > 0) next_.rungs = std::min(next_.rungs, above);
  return next_.worthwhile ? next_.rungs : 0;
}

Restitution CentralProblem::concluded() {
  const std::size_t runs = result_.runs.size();
  if (runs < 2) {
    const Contact& probe = where.probe();
    const std::string none = probe.unbounded ? "'" + short_name(*probe.second) + "' has more waves than are computed"
                                             : "fewer than two cutoffs could be computed";
    throw NotConverged(where.trouble.empty() ? "restitution: " + none : where.trouble);
  }
  const bool converged = runs >= fewest_runs && result_.converged;  // two runs that agree are not enough
  if (!converged) conclude(where.probe(), where.speed, correction_, result_);
  add_input_uncertainty(where.contact, where.speed, where.stretch, options_, result_);
  if (result_.lost_fraction.error <= 1.0) add_doubt_of_laws(where.probe(), result_);
  result_.converged = converged;
  if (converged) return std::move(result_);
  if (result_.lost_fraction.error > 1.0) {
    result_.lost_fraction.error = result_.restitution.error = std::numeric_limits<double>::infinity();
  }
  if (where.trouble.empty() && next_.reachable < result_.tolerance) {
    where.trouble = "no more than " + std::to_string(runs) +
                    " cutoffs could be computed, and so few that agree may do so by chance";
  }
  result_.reason =
      where.trouble.empty() ? beyond_reach(result_, next_, where.highest_cutoff(), where.probe()) : where.trouble;
  throw RestitutionNotConverged(std::move(result_));
}

}  // namespace stoss
