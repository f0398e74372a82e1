#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "common.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/restitution/oblique.hpp"

namespace bench {
namespace {

using stoss::Obliquity;

/// One oblique impact, and its ε_t.
struct Case {
  std::string name;
  stoss::RefinableContact contact;
  double speed, friction, ratio;  // v, μ, s/μv
  double converged;               // ε_t of finite elements, or of runs at several times the cutoff

  [[nodiscard]] Obliquity at(double share) const { return {share * ratio * friction * speed, 0.0, 0.0, friction}; }
};

void count_oblique(benchmark::State& state, const Case& its, double tangential_restitution) {
  state.counters[tangential_counter] = tangential_restitution;
  state.counters[error_counter] = std::abs(tangential_restitution - its.converged);
}

std::string with(const std::string& what, const Case& its, double tolerance) {
  std::ostringstream text;
  text << what << its.name << ", to " << tolerance;
  return text.str();
}

/// As one does without an error: cutoff, points and steps are doubled until two impacts agree.
double by_doubling(const Case& its, double tolerance) {
  constexpr double lowest = 8.0, points_each = 2.0;
  const double unit = 1.0 / stoss::time_scale(its.contact.at(0)), stretch = its.contact.stretch(its.speed);
  double before = 0.0;
  for (double cutoff = lowest;; cutoff *= 2.0) {
    stoss::ImpactOptions options;
    options.resolution.nodes = static_cast<int>(points_each * cutoff);
    const double now =
        stoss::oblique_impact(its.contact.at(unit * cutoff, stretch, {}), its.speed, its.at(1.0), options)
            .tangential_restitution;
    if (cutoff > lowest && std::abs(now - before) <= tolerance) return now;
    before = now;
  }
}

void add_rival(const Case& its, double tolerance) {
  benchmark::RegisterBenchmark(with("oblique: ", its, tolerance).append(" by doubling all").c_str(),
                               [=](benchmark::State& state) {
                                 double value = by_doubling(its, tolerance);
                                 for (auto _ : state) value = by_doubling(its, tolerance);
                                 count_oblique(state, its, value);
                                 state.counters[rival_counter] = 1.0;
                               })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

/// With the modes made before.
void add_value(const Case& its, double tolerance) {
  add(with("oblique: ", its, tolerance), [=](benchmark::State& state) {
    const auto value = [&] {
      return stoss::oblique_restitution(its.contact, its.speed, its.at(1.0), {.tolerance = tolerance})
          .tangential_restitution.value;
    };
    double result = value();
    for (auto _ : state) result = value();
    count_oblique(state, its, result);
  });
}

/// The same and 32 others.
void add_angles(const Case& its, double tolerance) {
  constexpr int others = 32;
  add(with("oblique: 33 angles, ", its, tolerance), [=](benchmark::State& state) {
    std::vector<Obliquity> all{its.at(1.0)};
    for (int k = 1; k <= others; ++k) all.push_back(its.at(0.15 * k));
    const auto value = [&] {
      return stoss::oblique_restitution(its.contact, its.speed, all, {.tolerance = tolerance})
          .front()
          .tangential_restitution.value;
    };
    double result = value();
    for (auto _ : state) result = value();
    count_oblique(state, its, result);
    state.counters[answers_counter] = 1.0 + others;
  });
}

/// Maw's curve, which knows no size of the contact.
void add_maw(const Case& its) {
  add("oblique: " + its.name + " on Maw's curve", [=](benchmark::State& state) {
    const double kappa = stoss::quasistatic::mindlin_ratio(poisson_of_sphere), before = kappa * its.ratio;
    constexpr double turning = 3.5;  // 1 + mR²/I
    double after = 0.0;
    for (auto _ : state) after = stoss::quasistatic::maw(before, 0.5 * kappa * turning).psi2;
    count_oblique(state, its, -after / before);
  });
}

}  // namespace

void add_oblique() {
  const stoss::RefinableContact disk{stoss::disk(poisson)}, ball{stoss::sphere(poisson_of_sphere)};
  const Case fast{"a disk, v = 0.1, μ = 0.3, x = 3.33", disk, 0.1, 0.3, 1.0 / 0.3, 0.4926};
  const Case stuck{"a disk, v = 0.003, μ = 0.1, x = 0.2", disk, 0.003, 0.1, 0.2, 0.5108};
  for (const Case& its : {fast, stuck}) {
    for (const double tolerance : {1e-2, 1e-3}) {
      add_rival(its, tolerance);
      add_value(its, tolerance);
    }
  }
  const stoss::RefinableContact plane{stoss::sphere(poisson_of_sphere),
                                      stoss::half_space(stoss::HalfSpace{poisson_of_sphere})};
  constexpr double friction = 0.3;
  for (const Case& its : {Case{"a sphere, v = 0.001, x = 1", ball, 1e-3, friction, 1.0, 0.19449},
                          Case{"a sphere on a half-space, v = 0.001, x = 1", plane, 1e-3, friction, 1.0, 0.11588},
                          Case{"a sphere on a half-space, v = 1e-05, x = 1", plane, 1e-5, friction, 1.0, 0.02724}}) {
    add_rival(its, 1e-2);
    add_value(its, 1e-2);
    add_angles(its, 1e-2);
    add_maw(its);
  }
}

}  // namespace bench
