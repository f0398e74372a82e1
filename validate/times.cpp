#include "times.hpp"

#include <cmath>
#include <ctime>

#include "judgement.hpp"
#include "stoss/bodies/disk.hpp"

namespace validate {
namespace {

constexpr int poisson_numbers = 40;
constexpr int speeds_each = 6;

double processor_time() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Multiples of an irrational number, modulo 1: they fill the interval evenly.
double spread(int i, double irrational) { return std::fmod(0.5 + i * irrational, 1.0); }

double poisson_number(int i) {
  constexpr double golden = 0.6180339887498949, lowest = -0.95, highest = 0.995;
  return lowest + (highest - lowest) * spread(i, golden);
}

double speed(int i) {
  constexpr double plastic = 0.7548776662466927, decades = 8.0;
  return std::pow(10.0, decades * (spread(i, plastic) - 1.0));
}

/// A body whose modes are made on a clock of their own.
stoss::RefinableContact timed_disk(double poisson, double& seconds) {
  return stoss::RefinableContact([poisson, &seconds](double cutoff, const stoss::Poll&) {
    const double begin = processor_time();
    stoss::Body body = stoss::disk(poisson, cutoff);
    seconds += processor_time() - begin;
    return body;
  });
}

}  // namespace

std::vector<Times> measure_times(const std::vector<double>& tolerances) {
  std::vector<Times> all(tolerances.size());
  for (int i = 0; i < poisson_numbers; ++i) {
    const double poisson = poisson_number(i);
    double modes = 0.0;
    const stoss::RefinableContact body = timed_disk(poisson, modes);
    for (int j = i * speeds_each; j < (i + 1) * speeds_each; ++j) {
      for (std::size_t k = 0; k < tolerances.size(); ++k) {
        modes = 0.0;
        const double begin = processor_time();
        const stoss::Restitution result = best(body, speed(j), {.tolerance = tolerances[k], .absolute = 0.0});
        const double seconds = processor_time() - begin - modes;
        all[k].push_back({poisson, speed(j), seconds, result.converged, result.finest.cutoff});
      }
    }
  }
  return all;
}

}  // namespace validate
