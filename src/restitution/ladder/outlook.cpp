#include "restitution/ladder/outlook.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "contact/touch.hpp"
#include "contact/zener.hpp"
#include "restitution/few_modes.hpp"

namespace stoss {
namespace {

constexpr int least_third = 2;      // rungs to the third run: closer ones agree by chance
constexpr int most_rungs = 4;       // a run far above all others would find the differences from them without weight
constexpr double aim = 0.9;         // of the tolerance: one run too fine costs less than another run
constexpr double affordable = 3e8;  // of `work`, some 0.2 s: what a run without hope may cost

bool is_vibrating(const Restitution& result) { return result.finest.start.has_value(); }

/// Order at which the errors fall with the cutoff: as observed since the first, or what it should be while the runs are
/// too close to tell. Errors that do not fall at all may be chance, and count as falling slowly.
double falling_order(const Reached& first, const Reached& last, double expected) {
  if (last.cutoff < 2.0 * first.cutoff) return expected;
  const double observed = std::log(first.error / last.error) / std::log(last.cutoff / first.cutoff);
  return std::clamp(observed, 0.2 * expected, expected);
}

/// What a run asks of the machine: its steps, times the modes and the entries of the matrices between the nodes. A
/// damped mode takes several times as long.
double work(const Impact& run) {
  constexpr double damped = 4.0;
  const double nodes = run.resolution.nodes, modes = static_cast<double>(run.energy.modes.size());
  const double each = run.energy.dissipated == 0.0 ? modes : damped * modes;
  return static_cast<double>(run.steps) * (each + nodes * nodes);
}

}  // namespace

double wanted_error(const Restitution& result) {
  return std::max(result.tolerance * std::abs(result.lost_fraction.value), result.absolute);
}

Reached reached(const Restitution& result) {
  const double scale = is_vibrating(result) ? 1.0 : std::abs(result.lost_fraction.value);
  return {result.runs.back().cutoff, result.lost_fraction.error / scale};
}

int levels_below(const Contact& contact, double speed, double stretch) {
  // Half as many octaves as the contact lasts longer, in levels of a quarter. As many octaves, or more levels, are too
  // many: three runs may agree by chance where the tail takes nothing. What lossy bodies lose needs all cutoffs, and
  // bodies that are known at a point have levels of their own (RefinableContact::levels).
  constexpr int most = 3;
  constexpr double no_digit = 1e-6;  // λ of a plate so thick that it is a half-space
  if (!contact.unbounded || loses(contact) || has_few_modes(contact)) return 0;
  if (contact.keeps_displacement) {
    const bool ball = contact.second->part.mobility > 0.0;
    if (!ball || zener_scales(contact, speed).inelasticity > no_digit) return 0;
  }
  const int longer = static_cast<int>(std::lround(4.0 * std::log2(stretch)));
  return std::clamp((longer - 1) / 2, 0, most);
}

int second_rung(const Contact& contact) {
  if (contact.unbounded) return 2;
  return touch(contact).circle ? 3 : most_rungs;
}

NextRun outlook(const Restitution& result, const Reached& first, double order, double highest) {
  const Reached last = reached(result);
  const double observed = falling_order(first, last, order);
  const double missing = result.lost_fraction.error / (aim * wanted_error(result));
  NextRun next{};
  next.rungs = static_cast<int>(std::clamp(std::ceil(4.0 * std::log2(missing) / order), 1.0, 1.0 * most_rungs));
  next.cutoff = last.cutoff * std::pow(missing, 1.0 / observed);
  next.reachable = last.error / aim * std::pow(last.cutoff / highest, observed);
  next.worthwhile = next.cutoff <= highest;
  // Without hope, runs that cost little still better the value.
  const auto grown = [&](int rungs) { return work(result.finest) * std::exp2(0.75 * rungs); };
  while (!next.worthwhile && next.rungs > 1 && grown(next.rungs) > affordable) --next.rungs;
  next.worthwhile = next.worthwhile || grown(next.rungs) < affordable;
  return next;
}

int third_rung(const Restitution& result, double order, double highest, int levels_above) {
  const int wanted = std::max(outlook(result, reached(result), order, highest).rungs, least_third);
  return std::min(wanted, std::max(levels_above, least_third));
}

std::string stays_open(const Restitution& result) {
  return "the body stays, its rebound is known no better (use a larger tolerance, from " +
         shown(std::ceil(1.1e8 * reached(result).error) / 1e8) + ")";
}

std::string beyond_reach(const Restitution& result, const NextRun& next, double highest, const Contact& contact) {
  constexpr double far_above = 1e5;
  const auto whole = [](double x) { return x < 10.0 ? rounded(x, 2) : std::to_string(std::lround(x)); };
  const std::string unit = has_single_point(contact) ? " c/L" : " c/R", limit = whole(highest);
  const std::string needed = next.cutoff < far_above
                                 ? "up to " + whole(std::max(next.cutoff, highest)) + unit + ", the limit is " + limit
                                 : "far above the limit of " + limit + unit;
  std::string way = ", as so little is lost; try an absolute error of " + rounded(1.05 * result.lost_fraction.error, 2);
  if (next.reachable < 0.5) {
    way = (is_vibrating(result) ? "; try an absolute error of " : "; try a tolerance of ") + rounded(next.reachable, 2);
  }
  return "did not reach the tolerance: that needs modes " + needed + way + " or larger";
}

}  // namespace stoss
