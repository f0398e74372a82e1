#include "stoss/restitution/oblique_restitution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "check.hpp"
#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/oblique_frame.hpp"
#include "impact/recommended.hpp"
#include "impact/whole_bodies.hpp"

namespace stoss {
namespace {

constexpr std::size_t fewest_runs = 3;  // two that agree by chance say nothing
constexpr int rungs = 2;                // to the next run
constexpr int last_level = 14;          // cutoff 64 at a wall
constexpr double room = 1.5;            // of a half-space, over what is expected of the contact

/// What the number of points leaves open of s′, over μv.
double error_of_points(bool mixing, double nodes, double ratio) {
  return mixing ? 0.8 / (nodes * std::sqrt(nodes)) : ratio / (nodes * nodes);
}

/// What a run must resolve.
struct Demands {
  bool mixing;     // both directions act on each other
  double ratio;    // of softness along the surface to that along the normal
  double allowed;  // error of s′ over μv
};

/// Points for that error.
double needed_points(const Demands& demands) {
  constexpr double most = 96.0, share = 0.9;
  const double error = share * demands.allowed;
  const double needed = demands.mixing ? std::pow(0.8 / error, 2.0 / 3.0) : std::sqrt(demands.ratio / error);
  return std::min(needed, most);
}

/// Cutoff, step and points that are refined together. The number of points differs in every run, so that two runs do
/// not err alike.
Resolution oblique_resolution(const Contact& contact, double speed, double half_width, int level,
                              const Demands& demands) {
  Resolution resolution = refined_resolution(contact, speed, half_width);
  const double cutoff = contact.cutoff * time_scale(contact);
  const double usual = demands.mixing ? 7.0 * std::sqrt(cutoff) : 40.0 * std::pow(cutoff / 32.0, 0.7);
  if (demands.mixing) resolution.step = 0.5 * *resolution.step;
  const double nyquist = 1.02 * nyquist_nodes(contact, *resolution.half_width);
  resolution.nodes =
      static_cast<int>(std::lround(std::max({usual, needed_points(demands) + level, 16.0 + level, nyquist})));
  return resolution;
}

Run summary(const ObliqueImpact& impact) {
  const Impact& normal = impact.normal;
  return {.cutoff = normal.cutoff,
          .resolution = normal.resolution,
          .lost_fraction = normal.lost_fraction,
          .dissipated = impact.energy.dissipated,
          .unresolved = impact.energy.unresolved,
          .contact_time = normal.contact_time,
          .impulse_time = normal.impulse_time,
          .max_force = normal.max_force,
          .max_compression = normal.max_compression,
          .energy_error = impact.energy_error,
          .steps = normal.steps};
}

/// Error of the last of the values at rising cutoffs.
double last_error(const std::vector<double>& value, const std::vector<Run>& runs, double order) {
  const std::size_t last = value.size() - 1;
  double most = 0.0;
  for (std::size_t k = last > 2 ? last - 2 : 0; k < last; ++k) {
    const double fallen = std::pow(runs[k].cutoff / runs[last].cutoff, order);
    most = std::max(most, fallen * std::abs(value[k] - value[last]));
  }
  return (value.size() > fewest_runs ? 3.0 : 5.0) * most;
}

/// Highest level at which whole bodies are computed.
int highest_level_of(const RefinableContact& contact, double stretch, const Poll& poll) {
  const Contact& coarse = contact.at(contact.cutoff(0), stretch, poll);
  if (coarse.unbounded) return std::min(last_level, contact.highest_level(room * stretch));
  double most = coarse.first->highest_cutoff;
  if (coarse.second != nullptr) most = std::min(most, coarse.second->highest_cutoff / units_of(coarse, 1).time);
  int level = std::min(last_level, contact.highest_level());
  while (level > 0 && contact.cutoff(level) > most) --level;
  return level;
}

/// One impact, with a half-space made anew for a longer time where the contact outlasts it.
ObliqueImpact oblique_impact_to_its_end(const RefinableContact& contact, int level, double speed,
                                        const Obliquity& obliquity, double half_width, const Demands& demands,
                                        double& stretch, const Poll& poll) {
  const double longest = room * stretch / std::numbers::sqrt2;
  for (;; stretch *= std::numbers::sqrt2) {
    const Contact& resolved = contact.at(contact.cutoff(level), stretch, poll);
    try {
      return oblique_impact(
          resolved, speed, obliquity,
          {.resolution = oblique_resolution(resolved, speed, half_width, level, demands), .poll = poll});
    } catch (const Outlasted&) {
      if (!resolved.unbounded || stretch > longest) throw;
    }
  }
}

ObliqueRestitution without_friction(const RefinableContact& contact, double speed, const Obliquity& obliquity,
                                    const ObliqueRestitutionOptions& options) {
  const Restitution central = restitution(contact, speed, {.tolerance = options.tolerance, .poll = options.poll});
  ObliqueRestitution result;
  const Contact& resolved = contact.at(0, options.poll);
  const ObliqueFrame frame(resolved, speed, {});
  frame.require(obliquity);
  result.finest = frame.joined(central.finest, obliquity, ObliqueFrame::unchanged(obliquity));
  result.restitution = central.restitution;
  result.sliding_after = {result.finest.sliding_after, 0.0};
  result.tangential_restitution = {result.finest.tangential_restitution, 0.0};
  result.tolerance = options.tolerance;
  result.converged = true;
  result.runs = central.runs;
  result.steps = central.steps;
  return result;
}

}  // namespace

ObliqueNotConverged::ObliqueNotConverged(ObliqueRestitution result)
    : NotConverged("oblique: " + result.reason), best(std::move(result)) {}

ObliqueRestitution oblique_restitution(const RefinableContact& contact, double speed, const Obliquity& obliquity,
                                       const ObliqueRestitutionOptions& options) {
  require("tolerance", options.tolerance, {1e-4, 0.5, true, true, "1e-4 to 0.5"}, "error of both coefficients");
  require_speed(speed);
  if (obliquity.friction == 0.0) return without_friction(contact, speed, obliquity, options);
  const bool unbounded = contact.at(0, options.poll).unbounded;
  double stretch = unbounded ? contact.stretch(speed) : 1.0 / contact.part();
  const int highest = highest_level_of(contact, stretch, options.poll);
  const Contact& coarse = contact.at(contact.cutoff(0), stretch, options.poll);
  const std::vector<Contact> along = contacts_along(coarse, options.poll);
  const double push = obliquity.friction * speed;
  const ObliqueFrame frame(coarse, speed, {});
  const double wanted =
      options.tolerance *
      std::max(push, std::abs(frame.sliding(obliquity.tangential, obliquity.spin, obliquity.second_spin)));
  const Demands demands{along.size() > 1, touch(along.front()).softness / touch(coarse).softness, wanted / push};
  const double order = demands.mixing ? 1.0 : 1.4;
  ObliqueRestitution result;
  result.tolerance = options.tolerance;
  result.unstable = obliquity.friction > stable_friction(along);
  std::vector<double> restitution, sliding;
  std::string trouble;
  for (int level = 0; level <= highest; level += rungs) {
    const double width = result.finest.normal.max_half_width;
    try {
      result.finest =
          oblique_impact_to_its_end(contact, level, speed, obliquity, width, demands, stretch, options.poll);
    } catch (const NotConverged& error) {  // too coarse, perhaps
      trouble = error.what();
      continue;
    }
    trouble.clear();
    const ObliqueImpact& finest = result.finest;
    result.runs.push_back(summary(finest));
    result.steps += finest.normal.steps;
    restitution.push_back(finest.restitution);
    sliding.push_back(finest.sliding_after);
    if (result.runs.size() < fewest_runs) continue;
    const double points = push * error_of_points(demands.mixing, finest.normal.resolution.nodes, demands.ratio);
    result.restitution = {finest.restitution, last_error(restitution, result.runs, order)};
    result.sliding_after = {finest.sliding_after, std::max(points, last_error(sliding, result.runs, order))};
    const double scale = std::abs(finest.sliding);
    result.tangential_restitution = {finest.tangential_restitution, scale > 0.0
                                                                        ? result.sliding_after.error / scale
                                                                        : std::numeric_limits<double>::infinity()};
    result.converged = result.restitution.error <= options.tolerance && result.sliding_after.error <= wanted;
    if (result.converged) return result;
  }
  if (result.runs.size() < fewest_runs) {
    throw NotConverged(trouble.empty() ? "oblique: the bodies have more modes than are computed" : trouble);
  }
  result.reason = !trouble.empty() ? trouble
                                   : "the cutoffs that are tried do not meet the tolerance; friction between unlike "
                                     "bodies may have no limit (use a larger tolerance)";
  throw ObliqueNotConverged(std::move(result));
}

}  // namespace stoss
