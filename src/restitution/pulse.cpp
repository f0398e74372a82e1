// F(t) of an impact, from impacts at rising cutoffs.
#include "stoss/restitution/pulse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "check.hpp"
#include "impact/recommended.hpp"
#include "restitution/ladder/central_problem.hpp"
#include "restitution/ladder/climb.hpp"
#include "restitution/lasting.hpp"
#include "restitution/pulse_shape.hpp"

namespace stoss {
namespace {

constexpr double safety = 3.0, order_of_surfaces = 1.5, order_of_points = 1.0;
constexpr int rungs = 2;
constexpr int highest_level = 16;  // a cutoff of 90: above, peaks of a force that are shorter cost seconds

/// One impact, and what follows from its force.
struct PulseRun {
  double cutoff = 0.0;
  Impact impact;
  ForceHistory history;
  ForceHistory::Interval contact{}, lasting{};
  SpectrumMarks marks{};
  double peak = 0.0, rise = 0.0, impulse = 0.0, asymmetry = 0.0;
};

PulseRun run_at(const Contact& contact, double speed, const ImpactOptions& options, double threshold) {
  PulseRun run;
  double start = 0.0;
  bool first = true;
  Observation observation;
  observation.observer = [&](const Snapshot& now) {
    if (first) start = -(contact.extent + now.center) / now.velocity, first = false;
    run.history.time.push_back(now.time - start);
    run.history.force.push_back(now.force);
  };
  run.impact = impact(contact, speed, options, observation);
  run.cutoff = contact.cutoff;
  run.history.step = run.impact.resolution.step;
  if (has_single_point(contact)) run.history = run.history.smoothed(2.0 * std::numbers::pi / contact.cutoff);
  const ForceHistory& its = run.history;
  const double greatest = *std::max_element(its.force.begin(), its.force.end());
  const double faint = contact.asperities > 0.0 || has_single_point(contact) ? 1e-3 : 0.0;
  run.peak = run.impact.max_force;
  run.contact = its.above(faint * greatest);
  run.lasting = its.above(threshold * greatest);
  run.rise = its.peak_time() - run.contact.begin;
  run.impulse = its.impulse(its.time.back());
  run.asymmetry = 1.0 - 2.0 * its.impulse(its.peak_time()) / run.impulse;
  run.marks = marks(its, run.contact.length());
  return run;
}

template <typename Quantity>
Estimate estimate(const std::vector<PulseRun>& runs, double order, double least, const Quantity& quantity) {
  return {std::invoke(quantity, runs.back()), std::max(least, safety * spread(runs, order, quantity))};
}

/// Greatest difference of a run from the last one within a window around an instant.
double difference(const PulseRun& run, const PulseRun& last, double instant, double window) {
  constexpr int looks = 8;
  double greatest = 0.0;
  for (int k = -looks; k <= looks; ++k) {
    const double at = instant + 0.5 * window * k / looks;
    greatest = std::max(greatest, std::abs(run.history.at(at) - last.history.at(at)));
  }
  return greatest;
}

void fill_series(const std::vector<PulseRun>& runs, double order, int points, Pulse& pulse) {
  const PulseRun& last = runs.back();
  const double begin = std::min(0.0, last.contact.begin), end = last.contact.end + 0.02 * last.contact.length();
  const double window = 2.0 * std::numbers::pi / runs.front().cutoff;
  const double most = std::max(2.5 * last.marks.null, 8.0 * std::numbers::pi / last.contact.length());
  for (int i = 0; i < points; ++i) {
    const double share = static_cast<double>(i) / (points - 1);
    const double time = begin + share * (end - begin), omega = share * most;
    double force = 0.0, amplitude = 0.0;
    const double its = last.history.amplitude(omega);
    for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
      const double left = safety * std::pow(runs[k].cutoff / last.cutoff, order);
      force = std::max(force, left * difference(runs[k], last, time, window));
      amplitude = std::max(amplitude, left * std::abs(runs[k].history.amplitude(omega) - its));
    }
    const PulseRun& before = runs[runs.size() - 2];
    const double left = safety * std::pow(before.cutoff / last.cutoff, order);
    pulse.time.push_back(time), pulse.force.push_back(last.history.at(time)), pulse.force_error.push_back(force);
    pulse.force_change.push_back(left * (last.history.at(time) - before.history.at(time)));
    pulse.frequency.push_back(omega);
    pulse.amplitude.push_back(its / last.impulse), pulse.amplitude_error.push_back(amplitude / last.impulse);
  }
}

/// Error of the force at any instant, over its maximum.
double error_of_force(const std::vector<PulseRun>& runs, double order, bool points) {
  const PulseRun& last = runs.back();
  double greatest = safety * spread(runs, order, &PulseRun::peak);
  constexpr int looks = 256;
  for (int i = 0; i <= looks && !points; ++i) {
    const double time = last.contact.begin + last.contact.length() * i / looks;
    for (const PulseRun& run : runs) {
      const double left = safety * std::pow(run.cutoff / last.cutoff, order);
      greatest = std::max(greatest, left * std::abs(run.history.at(time) - last.history.at(time)));
    }
  }
  return greatest / last.peak;
}

Pulse concluded(const std::vector<PulseRun>& runs, double order, const PulseOptions& options, const Contact& probe,
                double speed) {
  const PulseRun& last = runs.back();
  const double half = 0.5 * last.history.step;
  Pulse pulse;
  pulse.peak_force = estimate(runs, order, 0.0, &PulseRun::peak);
  pulse.rise = estimate(runs, order, half, &PulseRun::rise);
  pulse.contact_time = estimate(runs, order, half, [](const PulseRun& run) { return run.contact.length(); });
  pulse.duration = estimate(runs, order, half, [](const PulseRun& run) { return run.lasting.length(); });
  pulse.impulse = estimate(runs, order, 0.0, &PulseRun::impulse);
  pulse.asymmetry = estimate(runs, order, 0.0, &PulseRun::asymmetry);
  pulse.corner_frequency = estimate(runs, order, 0.0, [](const PulseRun& run) { return run.marks.corner; });
  pulse.first_null = estimate(runs, order, 0.0, [](const PulseRun& run) { return run.marks.null; });
  pulse.restitution = estimate(runs, order, 0.0, [](const PulseRun& run) { return run.impact.restitution; });
  const ForceHistory hertz = hertz_pulse(probe, speed);
  pulse.from_hertz = difference(last.history, hertz);
  pulse.from_sine = difference_from_sine(last.history, last.contact);
  pulse.threshold = options.threshold;
  fill_series(runs, order, options.points, pulse);
  for (const double time : pulse.time) pulse.hertz.push_back(hertz.time.empty() ? pulse.from_hertz : hertz.at(time));
  pulse.finest = last.impact;
  for (const PulseRun& run : runs) pulse.cutoffs.push_back(run.cutoff), pulse.steps += run.impact.steps;
  return pulse;
}

void require_options(const PulseOptions& options) {
  require("tolerance", options.tolerance, ranges::force_tolerance, "error of the force over its maximum");
  require("threshold", options.threshold, ranges::threshold, "of the force over its maximum");
  require("points", static_cast<long>(options.points), 16, 100'000, "instants, and frequencies");
}

}  // namespace

Pulse pulse(const RefinableContact& contact, double speed, const PulseOptions& options) {
  require_options(options);
  require_speed(speed);
  Levels levels = contact.levels(speed, duration_margin, options.poll);
  levels.highest = std::min(levels.highest, std::max(highest_level, levels.lowest + 2 * rungs));
  levels.lowest = lowest_level(contact, options.vibration, levels, options.poll);
  double stretch = contact.stretch(speed);
  const Contact& probe = contact.at(contact.cutoff(levels.lowest), stretch, options.poll);
  const bool points = has_single_point(probe);
  const double order = points ? order_of_points : order_of_surfaces;
  std::vector<PulseRun> runs;
  std::string reason;
  bool converged = false;
  for (int level = levels.lowest; level <= levels.highest && !converged; level += rungs) {
    try {
      retry_until_contact_ends(contact, contact.cutoff(level), speed, stretch, options.poll, [&](const Contact& at) {
        const double known = runs.empty() ? 0.0 : known_half_width(at, speed, runs.back().impact);
        ImpactOptions how{.resolution = refined_resolution(at, speed, known), .poll = options.poll};
        if (!options.vibration.empty()) how.start = approach(at, speed, options.vibration);
        runs.push_back(run_at(at, speed, how, options.threshold));
      });
    } catch (const DoesNotEnd&) {
      throw;
    } catch (const NotConverged& error) {
      reason = error.what();
      continue;
    }
    if (runs.size() >= fewest_runs) converged = error_of_force(runs, order, points) <= options.tolerance;
  }
  if (runs.size() < 2) throw NotConverged(reason.empty() ? "pulse: fewer than two cutoffs could be computed" : reason);
  Pulse made = concluded(runs, order, options, probe, speed);
  made.converged = converged;
  if (!converged) made.reason = "no cutoff that is computed reaches the tolerance " + shown(options.tolerance);
  return made;
}

}  // namespace stoss
