#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "cases.hpp"
#include "stoss/body/body.hpp"
#include "stoss/restitution/restitution.hpp"

namespace bench {

/// The benchmark to whose time the others are compared.
inline constexpr const char* reference_name = "the paper's protocol";

/// Names of the counters.
inline constexpr const char* lost_fraction_counter = "lost_fraction";
inline constexpr const char* error_counter = "error";
inline constexpr const char* ratio_counter = "ratio";
inline constexpr const char* apart_counter = "apart";
inline constexpr const char* sphere_counter = "sphere";
inline constexpr const char* tangential_counter = "tangential_restitution";
inline constexpr const char* rival_counter = "rival";      ///< of the oblique impacts that follow
inline constexpr const char* answers_counter = "answers";  ///< how many times the rival would run
inline constexpr const char* obstacle_counter = "on a half-space";
inline constexpr const char* speed_counter = "v";
inline constexpr const char* tolerance_counter = "to";
inline constexpr const char* elements_counter = "finite elements";  ///< the rival to the same tolerance at this speed
inline constexpr const char* to_elements_counter = "ratio to finite elements";
inline constexpr const char* work_counter = "multiply-adds";
inline constexpr const char* peak_counter = "peak";  ///< of the machine

/// The disk with all modes up to a cutoff, made once.
const stoss::Body& disk_body(double cutoff);

/// Times `restitution` of a body at a wall, modes made before, and nothing else that impacts share, and counts its
/// work.
/// @return 1 − ε²
double time_values(benchmark::State& state, const stoss::BodyMaker& body, double at,
                   const stoss::RestitutionOptions& options);

/// “<name> to 0.01, v = 0.3”; the speed only where it is not that of all benchmarks.
[[nodiscard]] std::string label(const std::string& name, double tolerance, double at);

/// Registers a benchmark of one task, timed in milliseconds.
template <typename Function>
void add(const std::string& name, Function function) {
  benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMillisecond);
}

/// Counters of an impact: 1 − ε² and its distance from the converged value; for the case of all benchmarks, or for
/// another one, whose time is not compared to the reference's.
void count(benchmark::State& state, double lost_fraction);
void count_apart(benchmark::State& state, double lost_fraction, double converged);

/// Counters of a row that has a rival to the same relative tolerance at the same speed, and of a row about spheres.
void count_task(benchmark::State& state, double at, double tolerance);
void count_sphere_task(benchmark::State& state, bool on_half_space, double at, double tolerance);

/// Counter of the work of a result, Σ steps × modes × points over its runs: what its physics asks for at least as long
/// as every mode is moved by the force at every point in every step.
void count_work(benchmark::State& state, const stoss::RefinableContact& contact, double at,
                const stoss::Restitution& result);

// One for each file bench_*.cpp; rivals come first.
void add_paper();
void add_finite_elements();
void add_peak();
void add_modes();
void add_impacts();
void add_restitutions();
void add_rods();
void add_rows();
void add_seismograms();
void add_spheres();
void add_oblique();
void add_quasistatic();
void add_predictions();
void add_table();
void add_pairs();
void add_python();

}  // namespace bench
