#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "common.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/extrapolation.hpp"
#include "stoss/restitution/restitution.hpp"

namespace bench {
namespace {

/// Modes made before.
void add_tolerance(double tolerance, const ConvergedCase& at) {
  add(label("restitution", tolerance, at.speed), [tolerance, at](benchmark::State& state) {
    const double lost_fraction = time_values(state, stoss::disk(poisson), at.speed, {.tolerance = tolerance});
    if (at.speed == speed) {
      count(state, lost_fraction);
    } else {
      count_apart(state, lost_fraction, at.lost_fraction);
    }
    count_task(state, at.speed, tolerance);
  });
}

/// Modes made before, and what impacts at neighbouring speeds share.
void add_shared() {
  add("restitution to 0.001, set-up shared", [](benchmark::State& state) {
    const stoss::RefinableContact contact(stoss::disk(poisson));
    stoss::Restitution result = stoss::restitution(contact, speed);
    for (auto _ : state) result = stoss::restitution(contact, speed);
    count(state, result.lost_fraction.value);
    count_work(state, contact, speed, result);
  });
}

/// Two disks of unequal size at the relative speed 0.2, modes made before; 1 − ε² by tolerance 1e-5.
void add_pair(double radius, double converged) {
  std::ostringstream name;
  name << "restitution of disks 1 : " << radius << " to 0.001";
  add(name.str(), [radius, converged](benchmark::State& state) {
    const stoss::RefinableContact pair(stoss::disk(poisson), stoss::disk(stoss::Disk{poisson, radius, 1.0, 1.0}));
    stoss::Restitution result = stoss::restitution(pair, 0.2);
    for (auto _ : state) result = stoss::restitution(pair, 0.2);
    count_apart(state, result.lost_fraction.value, converged);
    count_work(state, pair, 0.2, result);
  });
}

/// ε(v) of two disks, 60 speeds each, modes included.
void add_curves(int threads) {
  std::vector<double> speeds;
  for (int i = 0; i < 60; ++i) speeds.push_back(1e-4 * std::pow(3e3, i / 59.0));
  const std::string name = "two curves of 60 speeds to 0.001, " + std::to_string(threads) +
                           (threads == 1 ? " thread" : " threads") + ", modes included";
  benchmark::RegisterBenchmark(
      name.c_str(),
      [speeds, threads](benchmark::State& state) {
        for (auto _ : state) {
          for (const double nu : {poisson, 0.9}) {
            benchmark::DoNotOptimize(stoss::restitution_curve(nu, speeds, {.threads = threads}).data());
          }
        }
      })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace

void add_restitutions() {
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    for (const ConvergedCase& at : hard_wall_cases) add_tolerance(tolerance, at);
  }
  add_shared();
  add_pair(2.0, 0.368291);
  add_pair(4.0, 0.636360);
  add("restitution to 0.001, modes included", [](benchmark::State& state) {
    double lost_fraction = 0.0;
    for (auto _ : state) lost_fraction = stoss::restitution(stoss::disk(poisson), speed).lost_fraction.value;
    count(state, lost_fraction);
  });
  add("the paper's two limits (extrapolated_restitution), modes included", [](benchmark::State& state) {
    double lost_fraction = 0.0;
    for (auto _ : state) lost_fraction = stoss::extrapolated_restitution(poisson, speed).lost_fraction.value;
    count(state, lost_fraction);
  });
  add_curves(1);
  add_curves(2);
}

}  // namespace bench
