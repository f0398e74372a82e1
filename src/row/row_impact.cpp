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

constexpr long pause = 16, share = 32;  // steps between two looks whether all is over, and over all so far

/// After so long bodies that still may meet are left to their errors: each contact in turn, and as long again for each
/// to come back from the end of the row; and until all gaps are closed. What is flown at once does not count.
double longest(const MadeRow& row) {
  constexpr double times = 20.0;
  double contacts = 0.0, gaps = 0.0;
  for (const MadeRow::Joint& joint : row.joints) {
    const double unit = row.units_of(joint).time;
    contacts += joint.duration * unit;
    gaps += joint.gap * row.units_of(joint).length / row.fastest;
  }
  return times * (contacts + contacts / static_cast<double>(row.joints.size()) + gaps);
}

bool is_settled(const RowMotion& motion, double enough) {
  const std::vector<double> open = motion.open();
  return *std::max_element(open.begin(), open.end()) <= enough;
}

/// One try; empty if a contact outgrew its grid, which is then wider.
std::optional<RowImpact> run_once(MadeRow& row, const std::vector<double>& speeds, const RowWatch& watch,
                                  const Poll& poll) {
  RowMotion motion(row, speeds, watch.start, poll);
  if (watch.until > most_steps * row.step) {
    throw InvalidInput::out_of_range("until", shown(watch.until), shown_most(most_steps * row.step),
                                     "5e7 steps of the motion, R/c of the first body");
  }
  const bool ends = watch.until <= 0.0;
  const double most = ends ? std::min(most_steps, longest(row) / row.step) : most_steps;
  const double until = ends ? std::numeric_limits<double>::infinity() : watch.until;
  long next_look = pause;
  motion.observe(watch);
  while (motion.time() < std::min(until, motion.known()) && static_cast<double>(motion.steps()) < most) {
    if (poll) poll();
    const bool flies = motion.sleeps();
    if (flies && motion.steps() % watch.every != 0) motion.observe(watch);
    motion.advance(until);
    if (const int k = motion.overflowing(); k >= 0) {
      MadeRow::Joint& joint = row.joints[static_cast<std::size_t>(k)];
      if (joint.resolution.half_width < greatest_half_width(*joint.contact)) {
        joint.resolution = widened(*joint.contact, joint.resolution);
        return std::nullopt;
      }
      throw NotConverged("row: a contact spreads over the whole body (speed too high for this model)");
    }
    if (flies || motion.steps() % watch.every == 0) motion.observe(watch);
    if (ends && motion.is_over()) break;
    if (!ends || motion.steps() < next_look) continue;
    if (is_settled(motion, watch.settled * row.fastest)) break;
    next_look = motion.steps() + std::max(pause, motion.steps() / share);
  }
  motion.catch_up();
  RowImpact result = motion.result();
  if (watch.until > 0.0) std::fill(result.open.begin(), result.open.end(), 0.0);  // what comes after is not asked for
  return result;
}

/// Whether bodies may still meet when what stands at an end is no longer as it is computed.
bool is_cut_short(const MadeRow& row, const RowImpact& found, const RowWatch& watch) {
  const double known = found.contacts.back().first_touch + row.known;  // NaN where nothing has touched
  if (!std::isfinite(known) || found.time < known - row.step) return false;
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
  constexpr double most = 1e-2;
  if (std::abs(result.energy_error) > most) {
    throw NotConverged("row: " + rounded(result.energy_error) + " of the energy is unaccounted for at the cutoff " +
                           rounded(cutoff) + " c/R",
                       "cutoff", "use a higher cutoff");
  }
  return result;
}

}  // namespace stoss
