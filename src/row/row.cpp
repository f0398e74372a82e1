// Velocities after all contacts of a row, by motions at rising cutoffs.
#include "stoss/row/row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "check.hpp"
#include "row/motion.hpp"
#include "stoss/errors.hpp"
#include "stoss/row/curve.hpp"

namespace stoss {
namespace {

constexpr int levels_of_surfaces = 13, levels_of_points = 19;  // half octaves, to 362 and 2900
constexpr double lowest = 5.656854;                            // cutoff, over the fastest time scale of two neighbours
constexpr std::size_t fewest = 3;  // motions; of many bodies two, as not all of them agree by chance
constexpr std::size_t many = 8;
constexpr int most_failed = 3, most_failed_of_points = 8;  // a force that jumps falls between coarse steps
constexpr double long_contact = 40.0;                      // R/c
constexpr double share_settled = 0.6;                      // of the tolerance that bodies may have which may meet again

/// How errors of velocities follow from motions at cutoffs: of 200 rows of two to five disks and spheres (numerics).
struct Bars {
  double order, safety;
  double of_greatest;  ///< the same for the greatest difference of any body, as one by itself may agree by chance
  double unresolved;
};
constexpr Bars of_surfaces{2.0, 6.0, 4.0, 0.5}, of_points{1.0, 6.0, 4.0, 0.5};

/// Greatest difference of a velocity at the last cutoff from those before, scaled to what is left of it.
double spread(const std::vector<RowImpact>& runs, std::size_t body, double order) {
  const RowImpact& last = runs.back();
  double greatest = 0.0;
  for (const RowImpact& run : runs) {
    const double left = std::pow(run.cutoff / last.cutoff, order);
    greatest = std::max(greatest, left * std::abs(run.velocities_after[body] - last.velocities_after[body]));
  }
  return greatest;
}

void conclude(const std::vector<RowImpact>& runs, const Bars& bars, double fastest, RowResult& result) {
  const RowImpact& last = runs.back();
  result.velocities_after.clear();
  double greatest = 0.0;
  for (std::size_t b = 0; b < last.velocities_after.size(); ++b)
    greatest = std::max(greatest, spread(runs, b, bars.order));
  const double missing = bars.unresolved * std::max(0.0, last.energy.unresolved) * fastest;
  const double least = std::max(missing, bars.of_greatest * greatest);
  for (std::size_t b = 0; b < last.velocities_after.size(); ++b) {
    const double error = std::max(least, bars.safety * spread(runs, b, bars.order)) + last.open[b];
    result.velocities_after.push_back({last.velocities_after[b], error});
  }
  double left = 0.0;
  for (const RowImpact& run : runs) {
    left = std::max(left, std::pow(run.cutoff / last.cutoff, bars.order) *
                              std::abs(run.energy.translation - last.energy.translation));
  }
  result.translation = {last.energy.translation, std::max(bars.safety * left, std::abs(last.energy.unresolved))};
}

/// Why no higher cutoff is worth its time; empty if one is.
/// @param wanted error of a velocity @param highest cutoff that is computed
std::string hopeless(const RowResult& result, const RowImpact& last, const Bars& bars, double wanted, double highest) {
  const double open = *std::max_element(last.open.begin(), last.open.end());
  if (open > wanted) {
    return "bodies may meet again whose velocities differ by " + rounded(open) + " c at the end of the time computed";
  }
  double error = 0.0;
  for (std::size_t b = 0; b < last.open.size(); ++b) {
    error = std::max(error, (result.velocities_after[b].error - last.open[b]) / (wanted - last.open[b]));
  }
  constexpr double most = 1.5e9, growth = 2.8;  // some seconds; of the work from one cutoff to the next
  if (growth * last.work > most) return "more than the cutoff " + rounded(last.cutoff) + " c/R would take too long";
  const double needed = last.cutoff * std::pow(error, 1.0 / bars.order);
  return needed <= 2.0 * highest ? std::string() : "the tolerance needs a cutoff of some " + rounded(needed) + " c/R";
}

/// Why no higher cutoff helps: the errors do not fall, as they would by far in two octaves of the cutoff, or four.
std::string stays(const std::vector<double>& errors, double order) {
  const auto few = static_cast<std::size_t>(std::lround(8.0 / order));  // half octaves
  if (errors.size() <= few || errors.back() <= 0.5 * errors[errors.size() - 1 - few]) return {};
  return "the errors do not fall with the cutoff: bodies that vibrate meet so late that their phase is not known";
}

double greatest_error(const RowResult& result) {
  double greatest = 0.0;
  for (const Estimate& each : result.velocities_after) greatest = std::max(greatest, each.error);
  return greatest;
}

}  // namespace

void require_tolerance(const RowOptions& options) {
  require("tolerance", options.tolerance, ranges::row_tolerance,
          "error of each velocity over the greatest difference of speeds");
}

RowResult row(const Row& row, const std::vector<double>& speeds, const RowOptions& options) {
  require_tolerance(options);
  const double scale = fastest_time_scale(row, speeds, options.poll);
  const MadeRow probe = made_row(row, speeds, lowest / scale, options.poll);
  const bool points = has_single_point(*probe.joints.front().contact);
  const Bars& bars = points ? of_points : of_surfaces;
  const int levels = points ? levels_of_points : levels_of_surfaces;
  const std::size_t enough = row.bodies.size() < many ? fewest : fewest - 1;
  RowResult result;
  std::vector<RowImpact> runs;
  std::vector<double> errors;  // greatest, from the first that is known
  int failed = 0;
  // Waves of a block or a plate are as many as the square of cutoff and time, and slow impacts make long ones alone.
  const int begin = std::isfinite(probe.known) && probe.known > long_contact * scale ? -2 : 0;
  for (int level = begin; level < levels; ++level) {
    const double cutoff = lowest / scale * std::exp2(0.5 * level);
    try {
      runs.push_back(row_impact(row, speeds, cutoff, options.poll,
                                {.until = options.until, .settled = share_settled * options.tolerance}));
    } catch (const NotConverged& error) {
      result.reason = error.what();
      if (++failed == (points ? most_failed_of_points : most_failed)) break;
      continue;
    } catch (const InvalidInput& error) {  // a mode that vibrates is kept from some cutoff on
      if (row.vibration.empty() || error.name() != "vibration" || level + 1 == levels) throw;
      continue;
    }
    result.cutoffs.push_back(cutoff);
    result.steps += runs.back().steps;
    if (runs.size() < enough) continue;
    conclude(runs, bars, probe.fastest, result);
    const double wanted = options.tolerance * probe.fastest;
    errors.push_back(greatest_error(result));
    result.converged = errors.back() <= wanted;
    if (result.converged) break;
    result.reason = stays(errors, bars.order);
    if (result.reason.empty())
      result.reason = hopeless(result, runs.back(), bars, wanted, lowest / scale * std::exp2(0.5 * (levels - 1)));
    if (!result.reason.empty()) break;
  }
  if (runs.size() < enough) throw NotConverged(result.reason.empty() ? "row: too few cutoffs" : result.reason);
  result.finest = runs.back();
  if (result.converged) {
    result.reason.clear();
  } else if (result.reason.empty()) {
    result.reason = "did not reach the tolerance " + shown(options.tolerance);
  }
  return result;
}

}  // namespace stoss
