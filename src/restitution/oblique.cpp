// Runs at rising cutoffs for several obliquities at once, until the error of each s′ is small enough.
#include "stoss/restitution/oblique.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "check.hpp"
#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/recommended.hpp"
#include "restitution/input_uncertainty.hpp"
#include "restitution/lasting.hpp"
#include "restitution/neglected_coupling.hpp"
#include "restitution/oblique_errors.hpp"
#include "restitution/own_choice.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

constexpr int rungs = 2;        // to the next run
constexpr int last_level = 14;  // cutoff 64 at a wall
constexpr int last_level_of_unstable = 4;
constexpr int last_level_of_too_fine = 8;
constexpr double doubt_of_points = 1.25;   // of what is left by them at the last level
constexpr double most_without_hope = 3e9;  // of `work`, some seconds: what a run without hope may cost

/// Highest level at which whole bodies are computed: the near side of a disk is much less accurate along its edge.
int highest_level_of(const RefinableContact& contact, double stretch, const Poll& poll) {
  if (contact.at(0, poll).unbounded) return std::min(last_level, contact.highest_level(duration_margin * stretch));
  return std::min(last_level, contact.highest_whole_level());
}

/// The levels of the runs of a plan: all, or those at which bodies are known of which only a point is.
Levels levels_of(const RefinableContact& contact, double speed, double stretch, int last, const Poll& poll) {
  const Contact& probe = contact.at(0, poll);
  Levels levels{0, std::min(highest_level_of(contact, stretch, poll), last)};
  const bool known = !is_known_at_a_point(*probe.first) && (!probe.second || !is_known_at_a_point(*probe.second));
  if (known) return levels;
  const Levels of_point = contact.levels(speed, duration_margin, poll, Directions::oblique);
  const int lower = std::max(0, of_point.highest - levels.highest);
  return {of_point.lowest - lower, of_point.highest - lower};
}

/// How two directions that may act on each other err: measured (docs/theory/oblique.md).
/// @param beta     Dundurs' constant
/// @param friction of the one obliquity. With less of it more points slide outward at their limit
void mix(ObliquePlan& plan, double beta, double friction) {
  constexpr double of_spacing = 0.1, of_places = 0.1, most_of_places = 1.5, of_normal = 0.2;
  plan.spacing *= of_spacing;
  plan.places = std::min(most_of_places, of_places * beta / friction);
  plan.normal = of_normal * beta * std::min(friction, beta * beta / friction);
  const bool apart = beta == 0.0;
  plan.order = apart ? 1.7 : 1.0;
  plan.safety = apart ? 2.0 : 2.5;
  plan.of_few = apart ? 3.0 : 3.5;
}

/// What the run after one asks of the machine: steps, times the modes and the entries of the matrices between points,
/// of rings also for all steps before (WaveMemory).
double work_after(const Contact& contact, const ObliqueImpact& last, bool rings, std::size_t outcomes) {
  constexpr double growth = 2.0, least_shapes = 8.0;  // with two rungs: √2 times the steps, and more points
  const double points = last.normal.resolution.nodes, modes = static_cast<double>(last.normal.energy.modes.size());
  const auto steps = static_cast<double>(last.normal.steps);
  const double shapes = std::min(points, least_shapes + nyquist_nodes(contact, last.normal.max_half_width));
  const double before = rings ? steps * shapes * shapes : 0.0;
  return growth * steps * (modes + (points * points + before) * static_cast<double>(1 + outcomes));
}

/// What several obliquities of one contact have in common.
ObliquePlan plan_of(const Contact& contact, double speed, const std::vector<Obliquity>& obliquities, double tolerance,
                    const Poll& poll) {
  ObliquePlan plan;
  const ObliqueFrame frame(contact, speed, {});
  double most = 0.0;
  for (const Obliquity& each : obliquities) {
    frame.require(each);
    if (each.friction == 0.0) continue;
    most = std::max(most, each.friction);
    const double sliding = std::abs(frame.sliding(each.tangential, each.spin, each.second_spin));
    plan.allowed = std::min(plan.allowed, tolerance * std::max(1.0, sliding / (each.friction * speed)));
  }
  if (most == 0.0) return plan;
  const std::vector<Contact> along = contacts_along(contact, poll);
  plan.mixing = along.size() > 1;
  plan.spacing = touch(along.front()).softness / touch(contact).softness;
  if (plan.mixing) mix(plan, mixing(along), most);
  plan.unstable = most > stable_friction(along);
  return plan;
}

enum class Content { motion_along, all };

/// One ladder of impacts for results that share it: those with one normal impact at each cutoff, or one by itself.
/// @returns the stretch of the last contact
double refine(const RefinableContact& contact, const ObliqueOptions& options, std::vector<ObliqueRestitution*> open,
              Content content) {
  const double speed = open.front()->speed;
  const Contact& probe = contact.at(0, options.poll);
  double stretch = probe.unbounded ? contact.stretch(speed) : 1.0 / contact.part(), width = 0.0;
  std::vector<Obliquity> obliquities;
  obliquities.reserve(open.size());
  for (const ObliqueRestitution* each : open) obliquities.push_back(each->before);
  if (!probe.unbounded) (void)contact.highest_whole_level();  // which refuses bodies that are too unequal
  const Contact& coarse = contact.at(contact.cutoff(0), stretch, options.poll);
  const ObliquePlan plan = plan_of(coarse, speed, obliquities, options.tolerance, options.poll);
  const bool rough = touch(coarse).circle && std::any_of(obliquities.begin(), obliquities.end(),
                                                         [](const auto& each) { return each.friction > 0.0; });
  const auto impacts_at = [&](const Contact& resolved, int level) {
    ImpactOptions of_one{.resolution = plan.resolution(resolved, speed, width, level), .poll = options.poll};
    if (!options.vibration.empty()) of_one.start = approach(resolved, speed, options.vibration);
    std::vector<ObliqueImpact> impacts;
    if (rough) {
      const SharedNormalImpact shared(resolved, speed, of_one);
      for (const ObliqueRestitution* each : open) impacts.push_back(shared.with(each->before, options.poll));
    } else {
      for (const ObliqueRestitution* each : open) {
        impacts.push_back(oblique_impact(resolved, speed, each->before, of_one));
      }
    }
    return impacts;
  };
  const int of_stable = plan.mixing && plan.too_fine() ? last_level_of_too_fine : last_level;
  const int asked = plan.unstable ? last_level_of_unstable : of_stable;
  const Levels levels = levels_of(contact, speed, stretch, asked, options.poll);
  // Three runs make a value: of bodies so unequal that there are but three levels, at each of them.
  const int between = levels.highest - levels.lowest < 2 * rungs ? 1 : rungs;
  for (int level = levels.lowest; level <= levels.highest && !open.empty(); level += between) {
    std::vector<ObliqueImpact> impacts;
    try {
      impacts = of_own_choice([&] {
        return retry_until_contact_ends(
            contact, contact.cutoff(level), speed, stretch, options.poll,
            [&](const Contact& resolved) { return impacts_at(resolved, level - levels.lowest); });
      });
    } catch (const DoesNotEnd& error) {
      for (ObliqueRestitution* each : open) each->reason = error.what();
      break;
    } catch (const NotConverged& error) {  // too coarse, perhaps
      for (ObliqueRestitution* each : open) each->reason = error.what();
      continue;
    }
    for (std::size_t k = 0; k < open.size(); ++k) {
      width = std::max(width, known_half_width(coarse, speed, impacts[k].normal));
      add_run(plan, std::move(impacts[k]), *open[k]);
    }
    const auto done = [](const ObliqueRestitution* each) { return each->converged; };
    open.erase(std::remove_if(open.begin(), open.end(), done), open.end());
    const auto out_of_reach = [](const ObliqueRestitution* each) { return is_out_of_reach(*each); };
    if (std::all_of(open.begin(), open.end(), out_of_reach)) break;
    const double highest = contact.cutoff(levels.highest);
    if (content == Content::motion_along && !open.empty()) {  // a table needs all of them
      const Contact& resolved = contact.at(contact.cutoff(level), stretch, options.poll);
      double least = 0.0;
      for (const ObliqueRestitution* each : open) {
        least = std::max(least, left_by_points(plan, *each, resolved, highest, levels.highest - levels.lowest));
      }
      if (least > doubt_of_points * options.tolerance) throw OutOfReach(least);
    }
    const auto hopeless = [&](const ObliqueRestitution* each) { return is_hopeless(plan, *each, highest); };
    const auto work = [&] {
      const Contact& resolved = contact.at(contact.cutoff(level), stretch, options.poll);
      return work_after(resolved, open.front()->finest, rough, open.size());
    };
    if (!open.empty() && work() > most_without_hope && std::all_of(open.begin(), open.end(), hopeless)) break;
  }
  for (ObliqueRestitution* each : open) mark_unconverged(plan, *each);
  return stretch;
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
