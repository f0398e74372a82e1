#include "stoss/restitution/curve.hpp"

#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "check.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/bodies/disk.hpp"

namespace stoss {
namespace {

/// The last attempt at each point, from the threads that make them to the one that waits.
class Attempts {
 public:
  explicit Attempts(std::size_t points) : attempts_(points) {}

  void put(std::size_t point, const Attempt& attempt) {
    const std::lock_guard lock(mutex_);
    attempts_[point] = attempt;
  }

  /// Nothing if it has been taken.
  std::optional<Attempt> take(std::size_t point) {
    const std::lock_guard lock(mutex_);
    return std::exchange(attempts_[point], std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::vector<std::optional<Attempt>> attempts_;
};

/// A point at which no two impacts ended.
Restitution failed(double speed, const RestitutionOptions& options, const std::string& reason) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr Estimate nothing{none, none};
  Restitution result{.restitution = nothing,
                     .lost_fraction = nothing,
                     .contact_time = nothing,
                     .impulse_time = nothing,
                     .max_force = nothing,
                     .max_compression = nothing,
                     .lost_to_first = none,
                     .lost_to_second = none,
                     .dissipated = none,
                     .yielded = none,
                     .tolerance = options.tolerance,
                     .absolute = options.absolute,
                     .converged = false,
                     .reason = reason,
                     .runs = {},
                     .finest = {},
                     .steps = 0};
  result.finest.speed = speed;
  result.finest.restitution = result.finest.lost_fraction = none;
  return result;
}

}  // namespace

Restitution best_restitution(const RefinableContact& contact, double speed, const RestitutionOptions& options) {
  try {
    return restitution(contact, speed, options);
  } catch (const RestitutionNotConverged& error) {
    return error.best;
  } catch (const NotConverged& error) {
    return failed(speed, options, error.what());
  }
}

void validate(const std::vector<double>& speeds, const CurveOptions& options) {
  require_tolerance(options.each.tolerance, options.each.absolute);
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  for (const double speed : speeds) require_speed(speed);
}

void restitution_curve(const RefinableContact& contact, const std::vector<double>& speeds, const CurveOptions& options,
                       const CurveObserver& observer) {
  validate(speeds, options);
  Attempts attempts(speeds.size());
  std::size_t awaited = 0;
  const auto poll = [&] {
    if (options.each.attempt_observer) {
      if (const auto attempt = attempts.take(awaited)) options.each.attempt_observer(*attempt);
    }
    if (options.each.poll) options.each.poll();
  };
  const auto job = [&](std::size_t i, const Poll& heed) {
    RestitutionOptions of_one = options.each;
    of_one.poll = heed;
    of_one.attempt_observer = [&attempts, i](const Attempt& attempt) { attempts.put(i, attempt); };
    return best_restitution(contact, speeds[i], of_one);
  };
  const auto deliver = [&](std::size_t i, Restitution&& result) {
    awaited = i + 1;
    observer(i, result);
  };
  run_in_order<Restitution>(speeds.size(), options.threads, job, deliver, poll);
}

std::vector<Restitution> restitution_curve(const RefinableContact& contact, const std::vector<double>& speeds,
                                           const CurveOptions& options) {
  std::vector<Restitution> results;
  results.reserve(speeds.size());
  restitution_curve(contact, speeds, options,
                    [&](std::size_t, const Restitution& result) { results.push_back(result); });
  return results;
}

std::vector<Restitution> restitution_curve(double poisson, const std::vector<double>& speeds,
                                           const CurveOptions& options) {
  return restitution_curve(RefinableContact(disk(poisson)), speeds, options);
}

}  // namespace stoss
