#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "check.hpp"
#include "impact/inputs.hpp"
#include "impact/recommended.hpp"
#include "row/motion.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr long pause = 16;  // steps between two looks whether all is over

/// After so long bodies that still may meet are left to their errors: each contact in turn, and as long again for each
/// to come back from the end of the row; and until all gaps are closed, as long as what stands at an end is known.
double longest(const MadeRow& row) {
  constexpr double times = 20.0;
  double contacts = 0.0, gaps = 0.0;
  for (const MadeRow::Joint& joint : row.joints) {
    const double unit = row.units[static_cast<std::size_t>(joint.one)].time;
    contacts += joint.duration * unit;
    gaps += joint.gap * row.units[static_cast<std::size_t>(joint.one)].length / row.fastest;
  }
  return std::min(row.known, times * (contacts + contacts / static_cast<double>(row.joints.size()) + gaps));
}

bool is_settled(const RowMotion& motion, double enough) {
  const std::vector<double> open = motion.open();
  return *std::max_element(open.begin(), open.end()) <= enough;
}

/// One try; empty if a contact outgrew its grid, which is then wider.
std::optional<RowImpact> run_once(MadeRow& row, const std::vector<double>& speeds, const RowWatch& watch,
                                  const Poll& poll) {
  RowMotion motion(row, speeds, watch.start, poll);
  const double until = watch.until > 0.0 ? watch.until : longest(row);
  if (watch.until > most_steps * row.step) {
    throw InvalidInput::out_of_range("until", shown(watch.until), shown_most(most_steps * row.step),
                                     "5e7 steps of the motion, R/c of the first body");
  }
  if ((until - motion.time()) / row.step > most_steps) {
    throw NotConverged("row: would take more than " + std::to_string(static_cast<long>(most_steps)) + " steps");
  }
  motion.observe(watch);
  for (long step = 1; motion.time() < until; ++step) {
    if (poll) poll();
    motion.advance();
    if (const int k = motion.overflowing(); k >= 0) {
      MadeRow::Joint& joint = row.joints[static_cast<std::size_t>(k)];
      if (joint.resolution.half_width < greatest_half_width(*joint.contact)) {
        joint.resolution = widened(*joint.contact, joint.resolution);
        return std::nullopt;
      }
      throw NotConverged("row: a contact spreads over the whole body (speed too high for this model)");
    }
    if (step % watch.every == 0) motion.observe(watch);
    if (watch.until <= 0.0 && step % pause == 0 && is_settled(motion, watch.settled * row.fastest)) break;
  }
  RowImpact result = motion.result();
  if (watch.until > 0.0) std::fill(result.open.begin(), result.open.end(), 0.0);  // what comes after is not asked for
  return result;
}

/// Whether bodies may still meet when what stands at an end is no longer as it is computed.
bool is_cut_short(const MadeRow& row, const RowImpact& found, const RowWatch& watch) {
  if (!std::isfinite(row.known) || found.time < row.known - row.step) return false;
  return *std::max_element(found.open.begin(), found.open.end()) > watch.settled * row.fastest;
}

}  // namespace

RowImpact row_impact(const Row& row, const std::vector<double>& speeds, double cutoff, const Poll& poll,
                     const RowWatch& watch) {
  require_every(watch.every);
  // What the observer sees is a repetition on grids that are known to suffice, with what stands at an end made for a
  // time that does.
  RowWatch silent = watch;
  silent.observer = nullptr;
  constexpr double longest_made = 4.0;
  MadeRow made;
  std::optional<RowImpact> found;
  for (double longer = 1.0; !found || (is_cut_short(made, *found, watch) && longer <= longest_made); longer *= 2.0) {
    made = made_row(row, speeds, cutoff, poll, longer);
    found.reset();
    while (!found) found = run_once(made, speeds, silent, poll);
  }
  if (watch.observer) (void)run_once(made, speeds, watch, poll);
  RowImpact result = *std::move(found);
  result.cutoff = cutoff;
  for (const MadeRow::Joint& joint : made.joints) {
    result.strain = std::max(result.strain, expected_strain(*joint.contact, joint.speed));
  }
  require_resolved(result.energy_error);
  return result;
}

}  // namespace stoss
