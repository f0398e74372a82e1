#include "stoss/restitution/curve.hpp"

#include <mutex>
#include <optional>
#include <utility>

#include "check.hpp"
#include "restitution/best_restitution.hpp"
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

}  // namespace

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
