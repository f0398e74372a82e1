#include "stoss/restitution/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "check.hpp"
#include "impact/resolution.hpp"

namespace stoss {
namespace {

constexpr int first_runs = 4;  // two that agree by chance say nothing
constexpr int first_rungs = 2;
constexpr double slow_order = 1.5;
constexpr double safety = 6.0;
constexpr double unknown = std::numeric_limits<double>::infinity();
constexpr double slack = 1.1;  // the error may turn out smaller than the order of convergence says

/// Order of convergence in the cutoff, as observed: with one point of contact the force jumps, on a surface it grows.
double convergence_order(const Contact& contact) { return has_single_point(contact) ? 1.0 : 2.5; }

/// Quantity of the last run, with six times the largest difference from an earlier one, scaled to what is left of it.
Estimate estimate(const std::vector<Run>& runs, double order, double Run::*quantity) {
  const Run& last = runs.back();
  double error = 0.0;
  for (auto run = runs.begin(); run + 1 < runs.end(); ++run) {
    const double shrunk = std::pow(run->cutoff / last.cutoff, order);
    error = std::max(error, safety * shrunk * std::abs((*run).*quantity - last.*quantity));
  }
  return {last.*quantity, error};
}

/// An error as large as the value leaves nothing of it.
void judge(Estimate& estimate) {
  if (estimate.error >= std::abs(estimate.value)) estimate.error = unknown;
}

Run summary(const Impact& impact) {
  return {impact.cutoff,       impact.step,      impact.nodes,           impact.half_width,   impact.lost_fraction,
          impact.contact_time, impact.max_force, impact.max_compression, impact.energy_error, impact.steps};
}

void conclude(Restitution& result, double order) {
  const std::vector<Run>& runs = result.runs;
  result.lost_fraction = estimate(runs, order, &Run::lost_fraction);
  // Instants and peaks converge more slowly. A contact is noticed and lost within half a step each.
  const double slow = std::min(order, slow_order);
  result.contact_time = estimate(runs, slow, &Run::contact_time);
  result.contact_time.error = std::max(result.contact_time.error, runs.back().step);
  result.max_force = estimate(runs, slow, &Run::max_force);
  result.max_compression = estimate(runs, order, &Run::max_compression);
  for (Estimate* each : {&result.contact_time, &result.max_force, &result.max_compression}) judge(*each);
  const double value = result.finest.restitution;
  const double error = result.lost_fraction.error;
  result.restitution = {value, error / (std::sqrt(value * value + error) + std::abs(value))};
  result.converged = error <= result.tolerance * std::abs(result.lost_fraction.value);
}

}  // namespace

RestitutionNotConverged::RestitutionNotConverged(Restitution result)
    : NotConverged("restitution: " + result.reason), best(std::move(result)) {}

Restitution restitution(const RefinableContact& contact, double speed, const RestitutionOptions& options) {
  require_tolerance(options.tolerance);
  require_speed(speed);
  const double order = convergence_order(contact.at(0, options.poll));
  Restitution result;
  result.tolerance = options.tolerance;
  std::string trouble;
  int level = 0;
  for (int rungs = first_rungs; level <= contact.highest_level(); level += rungs) {
    ImpactOptions resolution = refined_resolution(contact.at(level, options.poll), speed, result.finest.max_half_width);
    resolution.poll = options.poll;
    try {
      result.finest = impact(contact.at(level), speed, resolution);
    } catch (const NotConverged& error) {  // too coarse, perhaps
      trouble = error.what();
      continue;
    }
    trouble.clear();
    result.runs.push_back(summary(result.finest));
    result.steps += result.finest.steps;
    if (result.runs.size() < first_runs) continue;
    conclude(result, order);
    if (result.converged) return result;
    // To the rung at which the error will be small enough, if it falls as it should.
    const double missing = result.lost_fraction.error / (options.tolerance * std::abs(result.lost_fraction.value));
    const double factor = std::pow(missing / slack, 1.0 / order);  // between the cutoffs
    rungs = static_cast<int>(std::clamp(std::ceil(4.0 * std::log2(factor)), 1.0, 8.0));
    if (level < contact.highest_level()) rungs = std::min(rungs, contact.highest_level() - level);
  }
  if (result.runs.size() < 2) throw NotConverged(trouble);
  conclude(result, order);
  if (result.lost_fraction.error > 1.0) result.lost_fraction.error = result.restitution.error = unknown;
  result.converged = false;  // two or three runs that agree are not enough
  result.reason = trouble.empty()
                      ? "the tolerance asks for a higher cutoff than " +
                            std::to_string(std::lround(result.runs.back().cutoff)) + " (use a larger tolerance)"
                      : trouble;
  throw RestitutionNotConverged(std::move(result));
}

Restitution restitution(const BodyMaker& maker, double speed, const RestitutionOptions& options) {
  return restitution(RefinableContact(maker), speed, options);
}

}  // namespace stoss
