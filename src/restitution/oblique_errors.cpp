#include "restitution/oblique_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "impact/recommended.hpp"
#include "restitution/ladder/climb.hpp"

namespace stoss {
namespace {

constexpr double no_estimate = std::numeric_limits<double>::infinity();

/// What a number of points across the contact leaves open of s′/μv: the square of their spacing, and where directions
/// mix what it matters between which two of them the sign of friction changes.
double error_of_points(const ObliquePlan& plan, double points) {
  return std::max(plan.spacing / (points * points), plan.sign_change / (points * std::sqrt(points)));
}

const calibration::ObliquePoints& points_of(const ObliquePlan& plan) {
  return plan.mixing ? calibration::points_where_mixing : calibration::points_on_rings;
}

/// Points that leave less open than is allowed.
double wanted_points(const ObliquePlan& plan) {
  const double error = points_of(plan).share * plan.allowed;
  return std::max(std::sqrt(plan.spacing / error), std::pow(plan.sign_change / error, 2.0 / 3.0));
}

/// Of the points of the grid.
double share_in_contact(const Impact& impact) {
  const double width = impact.resolution.half_width;
  return width > 0.0 ? impact.max_half_width / width : 1.0;
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

/// Error of the last run by its differences from all before it. That s′ changes little between three of them may be
/// chance: where friction changes its sign it goes up and down.
double by_differences(const ObliquePlan& plan, const std::vector<ObliqueRun>& runs, double ObliqueRun::*quantity) {
  if (plan.unstable || runs.size() < 2) return no_estimate;
  // ε_n swings with the cutoff, whose waves it meets in another phase each time.
  const bool swings = plan.mixing && quantity == &ObliqueRun::restitution;
  return (runs.size() > fewest_runs && !swings ? plan.from.safety : plan.from.of_few) *
         spread(runs, plan.from.order, quantity);
}

/// With two digits.
std::string rounded_up(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
  return rounded(std::ceil(x / digit) * digit, 2);
}

}  // namespace

double scale_of(const ObliqueRestitution& result) {
  return std::max(std::abs(result.sliding), result.before.friction * result.speed);
}

std::string way_out(const char* hint, double least) {
  constexpr double largest = 0.5;
  if (least <= largest) return std::string(" (") + hint + ", from " + rounded_up(least) + ")";
  return " (no tolerance up to 0.5 is reached)";
}

bool ObliquePlan::too_fine() const { return wanted_points(*this) > points_of(*this).most; }

Resolution ObliquePlan::resolution(const Contact& contact, double speed, double half_width, int level) const {
  Resolution resolution = refined_resolution(contact, speed, half_width);
  if (mixing) resolution.step = 0.5 * *resolution.step;
  const double nyquist = 1.02 * nyquist_nodes(contact, *resolution.half_width);
  resolution.nodes = points(contact.cutoff * time_scale(contact), nyquist, level);
  return resolution;
}

// The first run shows how wide the contact is. Where directions mix, time grows with the cube of the points.
double ObliquePlan::needed(int level) const {
  const calibration::ObliquePoints& its = points_of(*this);
  const double all = (too_fine() ? its.where_too_fine : wanted_points(*this)) + level;
  return level == 0 ? its.of_first * all : all;
}

int ObliquePlan::points(double cutoff, double nyquist, int level) const {
  const calibration::ObliquePoints& its = points_of(*this);
  const double usual = its.usual * std::pow(cutoff / its.cutoff, its.power), least = 16.0 + level;
  return static_cast<int>(std::lround(std::max({usual, needed(level), least, nyquist})));
}

void require_tolerance(const ObliqueOptions& options) {
  require("tolerance", options.tolerance, ranges::sliding_tolerance, "error of s' over the greater of |s| and mu v_n");
}

void add_run(const ObliquePlan& plan, ObliqueImpact&& impact, ObliqueRestitution& result) {
  result.finest = std::move(impact);
  const ObliqueImpact& last = result.finest;
  result.sliding = last.sliding;
  result.unstable = plan.unstable;
  result.runs.push_back(summary(last));
  result.steps += last.normal.steps;
  result.reason.clear();

  const double points = last.normal.resolution.nodes * share_in_contact(last.normal);
  const double open =
      std::max(result.before.friction * result.speed * error_of_points(plan, points), last.unsettled_sliding);
  const double change = last.sliding_after - last.sliding;
  const auto estimate = [&](double ObliqueRun::*quantity, double before) {
    const double value = result.runs.back().*quantity;
    const double share = change == 0.0 ? 0.0 : std::abs((value - before) / change);
    return Estimate{value, std::max(by_differences(plan, result.runs, quantity), share * open)};
  };
  const Obliquity& before = result.before;
  result.restitution = {last.restitution,
                        std::max({by_differences(plan, result.runs, &ObliqueRun::restitution),
                                  plan.normal / (points * points), std::sqrt(last.normal.remaining)})};
  result.sliding_after = estimate(&ObliqueRun::sliding_after, last.sliding);
  result.tangential_after = estimate(&ObliqueRun::tangential_after, before.tangential);
  result.spin_after = estimate(&ObliqueRun::spin_after, before.spin);
  result.second_spin_after = estimate(&ObliqueRun::second_spin_after, before.second_spin);
  const auto share_of_energy = [&](double ObliqueRun::*quantity) {
    const ObliqueRun& run = result.runs.back();
    return Estimate{run.*quantity,
                    by_differences(plan, result.runs, quantity) + std::abs(run.energy_error) + last.unsettled_heat};
  };
  result.friction_loss = share_of_energy(&ObliqueRun::friction_loss);
  result.vibration = share_of_energy(&ObliqueRun::vibration);
  result.tangential_restitution = {0.0, no_estimate};
  if (result.sliding != 0.0) {
    result.tangential_restitution = {-result.sliding_after.value / result.sliding,
                                     result.sliding_after.error / std::abs(result.sliding)};
  }
  result.converged =
      result.runs.size() >= fewest_runs && result.sliding_after.error <= result.tolerance * scale_of(result);
}

ObliqueRun normal_run(const Impact& impact) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {.cutoff = impact.cutoff,
          .resolution = impact.resolution,
          .restitution = impact.restitution,
          .sliding_after = none,
          .tangential_after = none,
          .spin_after = none,
          .second_spin_after = none,
          .friction_loss = none,
          .vibration = none,
          .unresolved = none,
          .energy_error = impact.energy_error,
          .steps = impact.steps};
}

void add_normal_runs(const std::vector<ObliqueRun>& runs, ObliqueRestitution& result) {
  if (result.runs.size() < 2) return;  // no value
  const auto coarser = [](const ObliqueRun& a, const ObliqueRun& b) { return a.cutoff < b.cutoff; };
  for (const ObliqueRun& run : runs) {
    const auto place = std::lower_bound(result.runs.begin(), result.runs.end(), run, coarser);
    if (place != result.runs.end() && place->cutoff == run.cutoff) continue;
    result.runs.insert(place, run);
    result.steps += run.steps;
  }
}

bool is_out_of_reach(const ObliqueRestitution& result) {
  return result.runs.size() >= fewest_runs && result.finest.unsettled_sliding > result.tolerance * scale_of(result);
}

double left_by_points(const ObliquePlan& plan, const ObliqueRestitution& result, const Contact& contact, double highest,
                      int level) {
  if (result.runs.size() < fewest_runs) return 0.0;
  const Impact& normal = result.finest.normal;
  const double nyquist = 1.02 * nyquist_nodes(contact, normal.resolution.half_width) * highest / contact.cutoff;
  const double points = plan.points(highest * time_scale(contact), nyquist, level) * share_in_contact(normal);
  return result.before.friction * result.speed * error_of_points(plan, points) / scale_of(result);
}

bool is_hopeless(const ObliquePlan& plan, const ObliqueRestitution& result, double highest) {
  if (result.runs.size() < 2) return false;
  if (plan.unstable || plan.too_fine()) return true;
  if (result.runs.size() < fewest_runs) return false;
  const double missing = result.sliding_after.error / (result.tolerance * scale_of(result));
  return !(result.runs.back().cutoff * std::pow(missing, 1.0 / plan.from.order) <= highest);
}

void mark_unconverged(const ObliquePlan& plan, ObliqueRestitution& result) {
  if (result.runs.size() >= 2) {
    const std::string way = way_out("use a larger tolerance", result.sliding_after.error / scale_of(result));
    if (plan.unstable) {
      result.reason =
          "at such friction between unlike bodies waves of any length grow, and nothing has a limit (the "
          "values are those of the finest run)";
    } else if (is_out_of_reach(result)) {
      result.reason = "the body stays, and how it slides in the end is known no better" + way;
    } else if (result.reason.empty() && result.runs.size() < fewest_runs) {
      result.reason = "no more than two cutoffs could be computed, and two that agree may do so by chance";
    } else if (result.reason.empty()) {
      result.reason =
          "the tolerance asks for " +
          (plan.too_fine() ? "more points across the contact than are computed"
                           : "a higher cutoff than " + std::to_string(std::lround(result.runs.back().cutoff))) +
          way;
    }
    return;
  }
  if (result.reason.empty()) result.reason = "fewer than two cutoffs could be computed";
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto member :
       {&ObliqueRestitution::restitution, &ObliqueRestitution::tangential_restitution,
        &ObliqueRestitution::sliding_after, &ObliqueRestitution::tangential_after, &ObliqueRestitution::spin_after,
        &ObliqueRestitution::second_spin_after, &ObliqueRestitution::friction_loss, &ObliqueRestitution::vibration}) {
    result.*member = {none, none};
  }
}

}  // namespace stoss
