#include "stoss/restitution/restitution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "check.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/ending.hpp"
#include "impact/inputs.hpp"
#include "impact/recommended.hpp"
#include "restitution/curvature.hpp"
#include "restitution/error_bar.hpp"
#include "restitution/input_uncertainty.hpp"
#include "restitution/lasting.hpp"
#include "restitution/own_choice.hpp"

namespace stoss {
namespace {

constexpr int first_runs = 3;       // two that agree by chance say nothing
constexpr int least_third = 2;      // rungs to the third run: closer ones agree by chance
constexpr int most_rungs = 4;       // a run far above all others would find the differences from them without weight
constexpr double aim = 0.9;         // of the tolerance: one run too fine costs less than another run
constexpr double affordable = 3e8;  // of `work`, some 0.2 s: what a run without hope may cost

/// @param energy initial energy of an impact, over that of the translation
Run summary(const Impact& impact, double energy) {
  return {.cutoff = impact.cutoff,
          .resolution = impact.resolution,
          .lost_fraction = impact.lost_fraction,
          .dissipated = energy * impact.energy.dissipated,
          .unresolved = energy * impact.energy.unresolved,
          .remaining = impact.remaining,
          .contact_time = impact.contact_time,
          .impulse_time = impact.impulse_time,
          .max_force = impact.max_force,
          .max_compression = impact.max_compression,
          .energy_error = impact.energy_error,
          .steps = impact.steps};
}

/// The contact as it is at first, of a level that may be negative.
const Contact& at_level(const RefinableContact& contact, int level, const Poll& poll) {
  return contact.at(contact.cutoff(level), 1.0, poll);
}

/// The first level at which all modes of a vibration are kept.
int lowest_level(const RefinableContact& contact, const Vibration& vibration, const Levels& levels, const Poll& poll) {
  for (int level = levels.lowest; level <= levels.highest; ++level) {
    if (keeps(at_level(contact, level, poll), vibration)) return level;
  }
  const Contact& finest = at_level(contact, levels.highest, poll);
  for (const Oscillation& mode : vibration) {
    require_possible(finest, mode);
    if (keeps(finest, {mode})) continue;
    throw InvalidInput::out_of_range("vibration", named(mode),
                                     "modes that it has up to " + shown_most(contact.cutoff(levels.highest)) +
                                         " c/R, the most that is computed at this speed",
                                     "let fewer modes vibrate");
  }
  return levels.highest;
}

/// Initial energy over that of the translation.
double whole_energy(const Vibration& vibration) {
  double sum = 1.0;
  for (const Oscillation& mode : vibration) sum += mode.energy;
  return sum;
}

/// Error of 1 − ε² with which a result counts as converged.
double wanted_error(const Restitution& result) {
  return std::max(result.tolerance * std::abs(result.lost_fraction.value), result.absolute);
}

/// Error of 1 − ε² in what it is asked for: that value itself, or, of vibrating bodies, 1, as it may be 0.
double scaled_error(const Restitution& result) {
  const bool vibrating = result.finest.start.has_value();
  return result.lost_fraction.error / (vibrating ? 1.0 : std::abs(result.lost_fraction.value));
}

/// That error with the runs up to a cutoff.
struct Reached {
  double cutoff;
  double error;
};

/// Order at which the errors fall with the cutoff: as observed since the first, or what it should be while the runs are
/// too close to tell. Errors that do not fall at all may be chance, and count as falling slowly.
double falling_order(const Reached& first, const Reached& last, double expected) {
  if (last.cutoff < 2.0 * first.cutoff) return expected;
  const double observed = std::log(first.error / last.error) / std::log(last.cutoff / first.cutoff);
  return std::clamp(observed, 0.2 * expected, expected);
}

/// Rungs from the first run to the second: few waves are enough on a half-space, and at the circle where a ball
/// touches.
int second_rung(const Contact& contact) {
  if (contact.unbounded) return 2;
  return touch(contact).circle ? 3 : most_rungs;
}

/// What a run asks of the machine: its steps, times the modes and the entries of the matrices between the nodes. A
/// damped mode takes several times as long.
double work(const Impact& run) {
  constexpr double damped = 4.0;
  const double nodes = run.resolution.nodes, modes = static_cast<double>(run.energy.modes.size());
  const double each = run.energy.dissipated == 0.0 ? modes : damped * modes;
  return static_cast<double>(run.steps) * (each + nodes * nodes);
}

/// What is to be expected of finer runs.
struct NextRun {
  int rungs;         ///< to the next run
  double cutoff;     ///< at which the tolerance would be met, if the errors go on falling as they did
  double reachable;  ///< scaled error that the highest cutoff would meet
  bool worthwhile;   ///< the next run has a chance, or costs little
};

NextRun outlook(const Restitution& result, const Reached& first, double expected, double highest) {
  const Reached last{result.runs.back().cutoff, scaled_error(result)};
  const double order = falling_order(first, last, expected);
  const double missing = result.lost_fraction.error / (aim * wanted_error(result));
  NextRun next{};
  next.rungs = static_cast<int>(std::clamp(std::ceil(4.0 * std::log2(missing) / expected), 1.0, 1.0 * most_rungs));
  next.cutoff = last.cutoff * std::pow(missing, 1.0 / order);
  next.reachable = last.error / aim * std::pow(last.cutoff / highest, order);
  next.worthwhile = next.cutoff <= highest;
  // Without hope, runs that cost little still better the value.
  const auto grown = [&](int rungs) { return work(result.finest) * std::exp2(0.75 * rungs); };
  while (!next.worthwhile && next.rungs > 1 && grown(next.rungs) > affordable) --next.rungs;
  next.worthwhile = next.worthwhile || grown(next.rungs) < affordable;
  return next;
}

/// Of a body that stays no cutoff tells more.
std::string stays_open(const Restitution& result) {
  return "the body stays, its rebound is known no better (use a larger tolerance, from " +
         shown(std::ceil(1.1e8 * scaled_error(result)) / 1e8) + ")";
}

/// Unit of its frequencies.
std::string_view frequency_unit(const Contact& contact) { return has_single_point(contact) ? " c/L" : " c/R"; }

/// @param error of 1 − ε² that was reached
std::string beyond_reach(const NextRun& next, double highest, bool vibrating, double error, std::string_view unit) {
  const auto rounded = [](double x) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.2g", x);
    return std::string(text.data());
  };
  const auto whole = [&](double x) { return x < 10.0 ? rounded(x) : std::to_string(std::lround(x)); };
  const std::string needed =
      next.cutoff < 1e5 ? "up to " + whole(std::max(next.cutoff, highest)) + std::string(unit) + ", the limit is "
                        : "far above the limit of ";
  return "did not reach the tolerance: that needs modes " + needed + whole(highest) +
         (next.cutoff < 1e5 ? "" : std::string(unit)) +
         (next.reachable < 0.5
              ? (vibrating ? "; try an absolute error of " : "; try a tolerance of ") + rounded(next.reachable)
              : ", as so little is lost; try an absolute error of " + rounded(1.05 * error)) +
         " or larger";
}

}  // namespace

RestitutionNotConverged::RestitutionNotConverged(Restitution result)
    : NotConverged("restitution: " + result.reason), best(std::move(result)) {}

void validate(const RefinableContact& contact, double speed, const Vibration& vibration, const Poll& poll) {
  require_speed(speed);
  of_own_choice([&] {
    const Levels levels = contact.levels(speed, duration_margin, poll);
    (void)approach(at_level(contact, lowest_level(contact, vibration, levels, poll), poll), speed, vibration);
  });
}

namespace {

Restitution refined(const RefinableContact& contact, double speed, const RestitutionOptions& options) {
  double stretch = contact.stretch(speed);
  const Levels levels = contact.levels(speed, duration_margin, options.poll);
  const int highest = levels.highest;
  const double order = convergence_order(contact.at(0, options.poll));
  Restitution result;
  result.tolerance = options.tolerance;
  result.absolute = options.absolute;
  std::optional<Reached> first;
  NextRun next{second_rung(contact.at(0, options.poll)), 0.0, 0.0, true};
  const CurvatureCorrection correction = curvature_correction(contact, speed, options.poll);
  std::string trouble;
  const double energy = whole_energy(options.vibration);
  const int lowest = lowest_level(contact, options.vibration, levels, options.poll);
  for (int level = lowest; level <= highest && next.worthwhile; level += next.rungs) {
    if (options.attempt_observer) {
      const bool told = result.runs.size() >= first_runs;
      options.attempt_observer({contact.cutoff(level), told ? result.lost_fraction : Estimate{}});
    }
    try {
      const auto compute = [&](const Contact& resolved) {
        const Resolution resolution =
            refined_resolution(resolved, speed, known_half_width(resolved, speed, result.finest));
        ImpactOptions of_one{.resolution = resolution, .poll = options.poll};
        if (!options.vibration.empty()) of_one.start = approach(resolved, speed, options.vibration);
        return impact(resolved, speed, of_one);
      };
      result.finest = of_own_choice([&] {
        return retry_until_contact_ends(contact, contact.cutoff(level), speed, stretch, options.poll, compute);
      });
      correct(correction, at_level(contact, level, options.poll), result.finest);
    } catch (const DoesNotEnd&) {
      throw;
    } catch (const NotConverged& error) {  // too coarse, perhaps
      trouble = error.what();
      continue;
    }
    trouble.clear();
    result.runs.push_back(summary(result.finest, energy));
    result.steps += result.finest.steps;
    if (result.runs.size() < 2) continue;
    conclude(at_level(contact, level, options.poll), speed, correction, result);
    if (result.runs.size() < first_runs) {
      const Reached reached{result.runs.back().cutoff, scaled_error(result)};
      next.rungs = std::max(outlook(result, reached, order, contact.cutoff(highest)).rungs, least_third);
      next.rungs = std::min(next.rungs, std::max(highest - level, least_third));
      continue;
    }
    if (result.converged) {
      add_input_uncertainty(contact, speed, stretch, options, result);
      return result;
    }
    trouble = result.finest.remaining > wanted_error(result) ? stays_open(result) : out_of_reach(correction, result);
    if (!trouble.empty()) break;
    if (!first) first = Reached{result.runs.back().cutoff, scaled_error(result)};
    next = outlook(result, *first, order, contact.cutoff(highest));
    if (level < highest) next.rungs = std::min(next.rungs, highest - level);
  }
  if (result.runs.size() < 2) {
    const std::string none = contact.at(0).unbounded
                                 ? "'" + short_name(*contact.at(0).second) + "' has more waves than are computed"
                                 : "fewer than two cutoffs could be computed";
    throw NotConverged(trouble.empty() ? "restitution: " + none : trouble);
  }
  conclude(contact.at(0), speed, correction, result);
  add_input_uncertainty(contact, speed, stretch, options, result);
  if (result.lost_fraction.error > 1.0)
    result.lost_fraction.error = result.restitution.error = std::numeric_limits<double>::infinity();
  result.converged = false;  // two or three runs that agree are not enough
  if (trouble.empty() && next.reachable < result.tolerance) {
    trouble = "no more than " + std::to_string(result.runs.size()) +
              " cutoffs could be computed, and so few that agree may do so by chance";
  }
  result.reason = trouble.empty() ? beyond_reach(next, contact.cutoff(highest), !options.vibration.empty(),
                                                 result.lost_fraction.error, frequency_unit(contact.at(0)))
                                  : trouble;
  throw RestitutionNotConverged(std::move(result));
}

}  // namespace

Restitution restitution(const RefinableContact& contact, double speed, const RestitutionOptions& options) {
  require_tolerance(options.tolerance, options.absolute);
  require_speed(speed);
  return of_own_choice([&] { return refined(contact, speed, options); });
}

Restitution restitution(const BodyMaker& maker, double speed, const RestitutionOptions& options) {
  return restitution(RefinableContact(maker), speed, options);
}

}  // namespace stoss
