#include "stoss/vibration/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "check.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

/// The least relative tolerance there is: the error of 1 − ε², which may be 0, is asked for as such.
constexpr double no_tolerance = 1e-15;

Sample sample_of(std::int64_t number, const Vibration& vibration, const Restitution& result) {
  double energy = 0.0;
  for (const Oscillation& mode : vibration) energy += mode.energy;
  return {.number = number,
          .vibration = energy,
          .restitution = result.restitution,
          .lost_fraction = result.lost_fraction,
          .contact_time = result.contact_time,
          .contacts = result.finest.contacts,
          .steps = result.steps,
          .converged = result.converged,
          .strain = result.finest.strain,
          .beyond_small_strain = result.finest.beyond_small_strain,
          .reason = result.reason};
}

Mean mean(const std::vector<Estimate>& values, double& standard_deviation) {
  const auto count = static_cast<double>(values.size());
  Mean result;
  for (const Estimate& each : values) {
    result.value += each.value / count;
    result.numerical_error += each.error / count;
  }
  double squares = 0.0;
  for (const Estimate& each : values) squares += (each.value - result.value) * (each.value - result.value);
  standard_deviation = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : std::numeric_limits<double>::infinity();
  result.statistical_error = standard_deviation / std::sqrt(count);
  return result;
}

}  // namespace

void validate(const RefinableContact& contact, double speed, const Spectrum& spectrum,
              const DistributionOptions& options) {
  require_speed(speed);
  require("first", options.first, 0, 1'000'000'000'000'000, "number of the first sample");
  require("samples", static_cast<double>(options.samples), ranges::samples, "of an ensemble; another seed gives more");
  require("error", options.error, ranges::sample_error, "absolute error of 1 - eps^2");
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  const Vibration any = draw(spectrum, options.seed, 0);
  validate(contact, speed, any, options.poll);
}

void restitution_distribution(const RefinableContact& contact, double speed, const Spectrum& spectrum,
                              const DistributionOptions& options, const SampleObserver& observer) {
  validate(contact, speed, spectrum, options);
  const auto count = static_cast<std::size_t>(options.samples);
  const auto job = [&](std::size_t i, const Poll& heed) {
    const auto number = options.first + static_cast<std::int64_t>(i);
    const Vibration vibration = draw(spectrum, options.seed, static_cast<std::uint64_t>(number));
    const Restitution result = best_restitution(contact, speed,
                                                {.tolerance = no_tolerance,
                                                 .absolute = options.error,
                                                 .poll = heed,
                                                 .attempt_observer = {},
                                                 .vibration = vibration});
    return sample_of(number, vibration, result);
  };
  const auto deliver = [&](std::size_t, Sample&& sample) { observer(sample); };
  run_in_order<Sample>(count, options.threads, job, deliver, options.poll);
}

std::vector<Sample> restitution_distribution(const RefinableContact& contact, double speed, const Spectrum& spectrum,
                                             const DistributionOptions& options) {
  std::vector<Sample> samples;
  restitution_distribution(contact, speed, spectrum, options,
                           [&samples](const Sample& sample) { samples.push_back(sample); });
  return samples;
}

DistributionSummary summary(std::span<const Sample> samples) {
  DistributionSummary result;
  std::vector<Estimate> restitution, lost;
  long above = 0;
  result.least = std::numeric_limits<double>::infinity();
  result.greatest = -result.least;
  for (const Sample& sample : samples) {
    const double value = sample.restitution.value;
    if (!std::isfinite(value)) {
      ++result.missing;
      continue;
    }
    restitution.push_back(sample.restitution);
    lost.push_back(sample.lost_fraction);
    if (!sample.converged) ++result.not_converged;
    if (value > 1.0) ++above;
    result.least = std::min(result.least, value);
    result.greatest = std::max(result.greatest, value);
  }
  if (restitution.empty()) throw InvalidInput::conflict("samples", "none has a value, at least one is needed");
  result.samples = static_cast<long>(restitution.size());
  result.restitution = mean(restitution, result.standard_deviation);
  double of_lost = 0.0;
  result.lost_fraction = mean(lost, of_lost);
  result.share_above_one = static_cast<double>(above) / static_cast<double>(result.samples);
  return result;
}

}  // namespace stoss
