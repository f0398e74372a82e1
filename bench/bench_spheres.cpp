#include <sstream>
#include <string>

#include "common.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/vibration/distribution.hpp"

namespace bench {
namespace {

/// Converged 1 − ε² on a plate of the same material (tests/data/plate_restitution.csv), by its thickness; 0 where
/// finite elements were not run.
struct PlateCase {
  double thickness, speed, lost_fraction;
};
constexpr PlateCase plate_cases[] = {{4.0, 0.1, 0.311413},  {2.0, 0.1, 0.557245},  {1.0, 0.1, 0.941820},
                                     {2.0, 0.01, 0.329982}, {1.0, 1e-3, 0.553174}, {2.0, 1e-6, 0.0},
                                     {0.1, 0.01, 1.0}};

template <typename Value>
std::string label(const std::string& name, Value value) {
  std::ostringstream text;
  text << name << value;
  return text.str();
}

void add_modes_to(double cutoff) {
  add(label("modes of a sphere, cutoff ", cutoff), [cutoff](benchmark::State& state) {
    std::size_t modes = 0;
    for (auto _ : state) {
      const auto list = stoss::bodies::sphere::modes(poisson_of_sphere, cutoff);
      modes = list.size();
      benchmark::DoNotOptimize(list.data());
    }
    state.counters["modes"] = static_cast<double>(modes);
    state.counters[sphere_counter] = 1.0;
  });
}

/// To a tolerance of 1 − ε² or to an absolute error, modes made before.
void add_restitution(const ConvergedCase& at, const stoss::RestitutionOptions& options) {
  const std::string name = label(label("restitution of a sphere to ", options.tolerance) + ", v = ", at.speed);
  add(name + (options.absolute == 0.0 ? ", absolute 0" : ""), [at, options](benchmark::State& state) {
    count_apart(state, time_values(state, stoss::sphere(poisson_of_sphere), at.speed, options), at.lost_fraction);
    count_sphere_task(state, false, at.speed, options.tolerance);
  });
}

/// With all that must be made for it.
void add_half_space(const ConvergedCase& at, double tolerance) {
  const std::string name = label("restitution of a sphere on a half-space to ", tolerance);
  add(label(name + ", set-up included, v = ", at.speed), [at, tolerance](benchmark::State& state) {
    const auto made = [] {
      return stoss::RefinableContact(stoss::sphere(poisson_of_sphere),
                                     stoss::half_space(stoss::HalfSpace{poisson_of_sphere}));
    };
    stoss::Restitution result;
    for (auto _ : state) result = stoss::restitution(made(), at.speed, {.tolerance = tolerance});
    count_apart(state, result.lost_fraction.value, at.lost_fraction);
    count_work(state, made(), at.speed, result);
    count_sphere_task(state, true, at.speed, tolerance);
  });
}

/// The same on a plate.
void add_plate(const PlateCase& at) {
  add(label(label("restitution of a sphere on a plate, set-up included, h = ", at.thickness) + ", v = ", at.speed),
      [at](benchmark::State& state) {
        const auto made = [at] {
          return stoss::RefinableContact(
              stoss::sphere(poisson_of_sphere),
              stoss::plate(stoss::Plate{.thickness = at.thickness, .poisson = poisson_of_sphere}));
        };
        stoss::Restitution result;
        for (auto _ : state) result = stoss::restitution(made(), at.speed);
        state.counters[sphere_counter] = 1.0;
        if (at.lost_fraction > 0.0) {
          count_apart(state, result.lost_fraction.value, at.lost_fraction);
        } else {
          state.counters[lost_fraction_counter] = result.lost_fraction.value;
        }
        count_work(state, made(), at.speed, result);
      });
}

/// Samples of a sphere that vibrates, one after the other, each to 1e-3 (absolute); modes made before.
void add_distribution(double at) {
  const std::string name = label("100 samples of a sphere at temperature 0.01 up to 10 c/R, to 0.001, v = ", at);
  benchmark::RegisterBenchmark(name.c_str(),
                               [at](benchmark::State& state) {
                                 const stoss::RefinableContact ball{stoss::sphere(poisson_of_sphere)};
                                 const stoss::Spectrum warm = stoss::thermal(ball, 0.01, 10.0);
                                 const stoss::DistributionOptions options{.samples = 100, .threads = 1};
                                 stoss::DistributionSummary all =
                                     stoss::summary(stoss::restitution_distribution(ball, at, warm, options));
                                 for (auto _ : state)
                                   all = stoss::summary(stoss::restitution_distribution(ball, at, warm, options));
                                 state.counters[lost_fraction_counter] = all.lost_fraction.value;
                                 state.counters[sphere_counter] = 1.0;
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace

void add_spheres() {
  for (const double cutoff : {100.0, 400.0}) add_modes_to(cutoff);
  for (const double tolerance : {1e-2, 1e-3}) {
    for (const ConvergedCase& at : sphere_cases) add_restitution(at, {.tolerance = tolerance});
  }
  for (const ConvergedCase& at : sphere_cases) {
    if (at.lost_fraction < 1e-3) add_restitution(at, {.absolute = 0.0});  // there the tolerance asks for more
  }
  for (const double tolerance : {1e-2, 1e-3}) {
    for (const ConvergedCase& at : half_space_cases) add_half_space(at, tolerance);
  }
  for (const PlateCase& at : plate_cases) add_plate(at);
  for (const double at : {0.1, 0.01}) add_distribution(at);
}

}  // namespace bench
