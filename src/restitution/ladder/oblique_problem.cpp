#include "restitution/ladder/oblique_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"

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

}  // namespace

ObliqueProblem::ObliqueProblem(const RefinableContact& contact, const ObliqueOptions& options,
                               std::vector<ObliqueRestitution*> open, Content content)
    : where{contact, open.front()->speed, options.poll, 1.0 / contact.part()},
      options_(options),
      open_(std::move(open)),
      content_(content) {
  if (where.probe().unbounded) {
    where.stretch = contact.stretch(where.speed);
  } else {
    (void)contact.highest_whole_level();  // which refuses bodies that are too unequal
  }
  const Contact& coarse = where.at(0);
  std::vector<Obliquity> before;
  for (const ObliqueRestitution* each : open_) before.push_back(each->before);
  plan_ = plan_of(coarse, where.speed, before, options.tolerance, options.poll);
  shares_ = touch(coarse).circle &&
            std::any_of(before.begin(), before.end(), [](const Obliquity& each) { return each.friction > 0.0; });
  const int of_stable = plan_.mixing && plan_.too_fine() ? last_level_of_too_fine : last_level;
  where.levels =
      levels_of(contact, where.speed, where.stretch, plan_.unstable ? last_level_of_unstable : of_stable, options.poll);
}

// Three runs make a value: of bodies so unequal that there are but three levels, at each of them.
int ObliqueProblem::between() const { return where.levels.highest - where.levels.lowest < 2 * rungs ? 1 : rungs; }

void ObliqueProblem::compute(const Contact& resolved, int level) {
  const Resolution resolution = plan_.resolution(resolved, where.speed, width_, level - where.levels.lowest);
  ImpactOptions of_one{.resolution = resolution, .poll = options_.poll};
  if (!options_.vibration.empty()) of_one.start = approach(resolved, where.speed, options_.vibration);
  impacts_.clear();
  if (shares_) {
    const SharedNormalImpact shared(resolved, where.speed, of_one);
    for (const ObliqueRestitution* each : open_) impacts_.push_back(shared.with(each->before, options_.poll));
  } else {
    for (const ObliqueRestitution* each : open_) {
      impacts_.push_back(oblique_impact(resolved, where.speed, each->before, of_one));
    }
  }
}

int ObliqueProblem::add(int level) {
  for (std::size_t k = 0; k < open_.size(); ++k) {
    width_ = std::max(width_, known_half_width(where.probe(), where.speed, impacts_[k].normal));
    add_run(plan_, std::move(impacts_[k]), *open_[k]);
  }
  const auto done = [](const ObliqueRestitution* each) { return each->converged; };
  open_.erase(std::remove_if(open_.begin(), open_.end(), done), open_.end());
  const auto out_of_reach = [](const ObliqueRestitution* each) { return is_out_of_reach(*each); };
  if (std::all_of(open_.begin(), open_.end(), out_of_reach)) return 0;
  const Contact& resolved = where.at(level);
  const double highest = where.highest_cutoff();
  if (content_ == Content::motion_along) {  // a table needs all of them
    double least = 0.0;
    for (const ObliqueRestitution* each : open_) {
      least =
          std::max(least, left_by_points(plan_, *each, resolved, highest, where.levels.highest - where.levels.lowest));
    }
    if (least > doubt_of_points * options_.tolerance) throw OutOfReach(least);
  }
  const auto hopeless = [&](const ObliqueRestitution* each) { return is_hopeless(plan_, *each, highest); };
  const bool costs_much = work_after(resolved, open_.front()->finest, shares_, open_.size()) > most_without_hope;
  return costs_much && std::all_of(open_.begin(), open_.end(), hopeless) ? 0 : between();
}

void ObliqueProblem::conclude() {
  for (ObliqueRestitution* each : open_) {
    each->reason = where.trouble;
    mark_unconverged(plan_, *each);
  }
}

}  // namespace stoss
