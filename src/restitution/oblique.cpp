// Runs at rising cutoffs for several obliquities at once, until the error of each s′ is small enough.
#include "stoss/restitution/oblique.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "check.hpp"
#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "impact/recommended.hpp"
#include "restitution/lasting.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

constexpr double no_estimate = std::numeric_limits<double>::infinity();

/// How runs refine, and what their differences mean.
struct Plan {
  int first_level, rungs, most_runs;
  double order;  ///< at which errors fall with the cutoff
  double nodes;  ///< across the contact at the cutoff 16
  double step;   ///< times the cutoff
};
constexpr Plan uncoupled{0, 2, 9, 1.4, 32.0, 0.5};
constexpr Plan coupled{1, 2, 8, 1.0, 28.0, 0.25};
constexpr int fewest_runs = 3;  // two that agree by chance say nothing
constexpr double safety = 3.0;

/// The number of nodes differs in every run, so that errors of nodes show in the differences too.
Resolution resolution_of(const Plan& plan, const Contact& contact, double speed, double half_width) {
  Resolution resolution = refined_resolution(contact, speed, half_width);
  resolution.step = std::min(plan.step / contact.cutoff, contact.stable_step);
  const double scaled = contact.cutoff * time_scale(contact) / 16.0;
  const double nodes = plan.nodes * std::pow(scaled, 2.0 / 3.0);
  const int fewest = std::max(12, nyquist_nodes(contact, *resolution.half_width));
  resolution.nodes = std::clamp(static_cast<int>(std::ceil(nodes)), fewest, most_nodes);
  return resolution;
}

ObliqueRun summary(const ObliqueImpact& impact) {
  return {.cutoff = impact.normal.cutoff,
          .resolution = impact.normal.resolution,
          .restitution = impact.restitution,
          .sliding_after = impact.sliding_after,
          .tangential_after = impact.tangential_after,
          .spin_after = impact.spin_after,
          .second_spin_after = impact.second_spin_after,
          .friction_loss = impact.energy.friction,
          .vibration = impact.energy.vibration + impact.energy.second_vibration,
          .unresolved = impact.energy.unresolved,
          .energy_error = impact.energy_error,
          .steps = impact.normal.steps};
}

/// Maximum difference from the coarser runs, each scaled to what is left of it.
double spread(const std::vector<ObliqueRun>& runs, double order, double ObliqueRun::*quantity) {
  double greatest = 0.0;
  const ObliqueRun& last = runs.back();
  for (const ObliqueRun& run : runs) {
    const double left = std::pow(run.cutoff / last.cutoff, order) * std::abs(run.*quantity - last.*quantity);
    greatest = std::max(greatest, left);
  }
  return safety * greatest;
}

/// 1/κ: softness along the surface over that along the normal.
double softness_along(const Contact& contact, const Poll& poll) {
  return touch(contacts_along(contact, poll).front()).softness / touch(contact).softness;
}

/// Of the error of s′.
double scale_of(const ObliqueRestitution& result) {
  return std::max(std::abs(result.sliding), result.before.friction * result.speed);
}

/// What the errors of a result follow from.
struct Doubt {
  Plan plan;
  double softness;  ///< 1/κ, along the surface over that along the normal
};

void conclude(const Doubt& doubt, ObliqueRestitution& result) {
  const std::vector<ObliqueRun>& runs = result.runs;
  const ObliqueImpact& last = result.finest;
  const double friction = result.before.friction * result.speed, change = last.sliding_after - last.sliding;
  const double width = last.normal.resolution.half_width;
  const double nodes = last.normal.resolution.nodes * (width > 0.0 ? last.normal.max_half_width / width : 1.0);
  const double of_nodes = friction * doubt.softness / (nodes * nodes);
  const auto estimate = [&](double ObliqueRun::*quantity, double before) {
    const double value = runs.back().*quantity;
    if (runs.size() < 2) return Estimate{value, no_estimate};
    const double share = change == 0.0 ? 0.0 : std::abs((value - before) / change);
    return Estimate{value, std::max(spread(runs, doubt.plan.order, quantity), share * of_nodes)};
  };
  const Obliquity& before = result.before;
  result.restitution = {last.restitution,
                        runs.size() < 2 ? no_estimate : spread(runs, doubt.plan.order, &ObliqueRun::restitution)};
  result.sliding_after = estimate(&ObliqueRun::sliding_after, last.sliding);
  result.tangential_after = estimate(&ObliqueRun::tangential_after, before.tangential);
  result.spin_after = estimate(&ObliqueRun::spin_after, before.spin);
  result.second_spin_after = estimate(&ObliqueRun::second_spin_after, before.second_spin);
  const auto share_of_energy = [&](double ObliqueRun::*quantity) {
    const double value = runs.back().*quantity;
    if (runs.size() < 2) return Estimate{value, no_estimate};
    return Estimate{value, spread(runs, doubt.plan.order, quantity) + std::abs(runs.back().energy_error)};
  };
  result.friction_loss = share_of_energy(&ObliqueRun::friction_loss);
  result.vibration = share_of_energy(&ObliqueRun::vibration);
  if (result.sliding != 0.0) {
    result.tangential_restitution = {-result.sliding_after.value / result.sliding,
                                     result.sliding_after.error / std::abs(result.sliding)};
  } else {
    result.tangential_restitution = {0.0, no_estimate};
  }
  result.converged = runs.size() >= fewest_runs && result.sliding_after.error <= result.tolerance * scale_of(result);
}

void add(const Doubt& doubt, ObliqueImpact&& impact, ObliqueRestitution& result) {
  result.finest = std::move(impact);
  result.sliding = result.finest.sliding;
  result.runs.push_back(summary(result.finest));
  result.steps += result.finest.normal.steps;
  result.reason.clear();
  conclude(doubt, result);
}

/// With two digits.
std::string rounded_up(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.2g", std::ceil(x / digit) * digit);
  return text.data();
}

/// Says why a result has not converged; without two impacts there are no values.
void give_up(ObliqueRestitution& result) {
  if (result.runs.size() >= 2) {
    if (result.reason.empty()) {
      result.reason = "the tolerance asks for a higher cutoff than " +
                      std::to_string(std::lround(result.runs.back().cutoff)) + " (use a larger tolerance, from " +
                      rounded_up(result.sliding_after.error / scale_of(result)) + ")";
    }
    return;
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto member :
       {&ObliqueRestitution::restitution, &ObliqueRestitution::tangential_restitution,
        &ObliqueRestitution::sliding_after, &ObliqueRestitution::tangential_after, &ObliqueRestitution::spin_after,
        &ObliqueRestitution::second_spin_after, &ObliqueRestitution::friction_loss, &ObliqueRestitution::vibration}) {
    result.*member = {none, none};
  }
}

/// One ladder of impacts for results that share it: those with one normal impact at each cutoff, or one by itself.
void refine(const RefinableContact& contact, const Doubt& doubt, bool separate, const ObliqueOptions& options,
            std::vector<ObliqueRestitution*> open) {
  const double speed = open.front()->speed;
  double stretch = contact.stretch(speed), width = 0.0;
  const auto& [first_level, rungs, most_runs, order, nodes, step] = doubt.plan;
  const int highest = std::min(contact.highest_level(room_to_last * stretch), first_level + rungs * (most_runs - 1));
  for (int level = first_level; level <= highest && !open.empty(); level += rungs) {
    const auto compute = [&](const Contact& resolved) {
      ImpactOptions of_one{.resolution = resolution_of(doubt.plan, resolved, speed, width), .poll = options.poll};
      if (!options.vibration.empty()) of_one.start = approach(resolved, speed, options.vibration);
      std::vector<ObliqueImpact> impacts;
      if (separate) {
        const Slides slides(resolved, speed, of_one);
        for (const ObliqueRestitution* each : open) impacts.push_back(slides.after(each->before, options.poll));
      } else {
        for (const ObliqueRestitution* each : open) {
          impacts.push_back(oblique_impact(resolved, speed, each->before, of_one));
        }
      }
      return impacts;
    };
    std::vector<ObliqueImpact> impacts;
    try {
      impacts = to_its_end(contact, contact.cutoff(level), stretch, options.poll, compute);
    } catch (const NotConverged& error) {  // too coarse, perhaps
      for (ObliqueRestitution* each : open) each->reason = error.what();
      continue;
    }
    for (std::size_t k = 0; k < open.size(); ++k) {
      width = std::max(width, impacts[k].normal.max_half_width);
      add(doubt, std::move(impacts[k]), *open[k]);
    }
    const auto done = [](const ObliqueRestitution* each) { return each->converged; };
    open.erase(std::remove_if(open.begin(), open.end(), done), open.end());
  }
  for (ObliqueRestitution* each : open) give_up(*each);
}

}  // namespace

std::vector<ObliqueRestitution> oblique_restitution(const RefinableContact& contact, double speed,
                                                    const std::vector<Obliquity>& obliquities,
                                                    const ObliqueOptions& options) {
  constexpr Range tolerances{1e-6, 0.5, true, true, "1e-6 to 0.5"};
  require("tolerance", options.tolerance, tolerances, "error of s' over the greater of |s| and mu v_n");
  require_speed(speed);
  std::vector<ObliqueRestitution> results;
  for (const Obliquity& obliquity : obliquities) {
    results.emplace_back();
    results.back().speed = speed, results.back().before = obliquity, results.back().tolerance = options.tolerance;
  }
  if (results.empty()) return results;
  const Contact& probe = contact.at(0, options.poll);
  const bool separate = touch(probe).circle;
  const auto rough = [](const Obliquity& each) { return each.friction > 0.0; };
  const bool any_friction = std::any_of(obliquities.begin(), obliquities.end(), rough);
  const Doubt doubt{separate ? uncoupled : coupled, any_friction ? softness_along(probe, options.poll) : 1.0};
  std::vector<ObliqueRestitution*> all;
  for (ObliqueRestitution& each : results) {
    all.push_back(&each);
    if (!separate) refine(contact, doubt, separate, options, {&each});
  }
  if (separate) refine(contact, doubt, separate, options, all);
  const auto like_central = [&](const ObliqueRestitution& each) { return separate || !rough(each.before); };
  if (std::none_of(results.begin(), results.end(), like_central)) return results;
  const Restitution central = best_restitution(contact, speed, {.poll = options.poll, .vibration = options.vibration});
  for (ObliqueRestitution& each : results) {
    if (like_central(each)) each.restitution = central.restitution;
  }
  return results;
}

ObliqueRestitution oblique_restitution(const RefinableContact& contact, double speed, const Obliquity& obliquity,
                                       const ObliqueOptions& options) {
  ObliqueRestitution result = std::move(oblique_restitution(contact, speed, std::vector{obliquity}, options).front());
  if (result.runs.size() < 2) throw NotConverged(result.reason);
  return result;
}

}  // namespace stoss
