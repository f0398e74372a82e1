#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "common.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/restitution/curve.hpp"
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

/// y(0) of the line through points of equal weight.
double at_zero(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i];
    sy += y[i];
    xx += x[i] * x[i];
    xy += x[i] * y[i];
  }
  const auto count = static_cast<double>(x.size());
  return (xx * sy - sx * xy) / (count * xx - sx * sx);
}

/// 1 − ε² by the paper's two limits: linear in 1/α with 300 to 940 modes each, then linear in 1/√N.
double two_limits() {
  std::vector<double> omega;
  for (const auto& mode : stoss::bodies::disk::modes(poisson, 48.0)) omega.push_back(mode.omega);
  std::sort(omega.begin(), omega.end());
  std::vector<double> roots, limits;
  for (const std::size_t n : {300, 400, 600, 940}) {
    const stoss::Body body = stoss::disk(poisson, 0.5 * (omega[n - 1] + omega[n]));
    std::vector<double> inverse, lost;
    for (const double scaled : {25.0, 100.0 / 3.0, 50.0, 100.0}) {
      inverse.push_back(speed / scaled);
      lost.push_back(stoss::impact(body, stoss::ExponentialWall{scaled / speed}, speed).lost_fraction);
    }
    roots.push_back(1.0 / std::sqrt(static_cast<double>(n)));
    limits.push_back(at_zero(inverse, lost));
  }
  return at_zero(roots, limits);
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
  add("the paper's two limits, modes included", [](benchmark::State& state) {
    double lost_fraction = 0.0;
    for (auto _ : state) lost_fraction = two_limits();
    count(state, lost_fraction);
  });
  add_curves(1);
  add_curves(2);
}

}  // namespace bench
