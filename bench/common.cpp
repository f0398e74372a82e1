#include "common.hpp"

#include <cmath>
#include <map>

#include "stoss/bodies/disk.hpp"

namespace bench {

const stoss::Body& disk_body(double cutoff) {
  static std::map<double, stoss::Body> bodies;
  auto found = bodies.find(cutoff);
  if (found == bodies.end()) found = bodies.emplace(cutoff, stoss::disk(poisson, cutoff)).first;
  return found->second;
}

void count(benchmark::State& state, double lost_fraction) {
  state.counters[lost_fraction_counter] = lost_fraction;
  state.counters[error_counter] = std::abs(lost_fraction - converged_lost_fraction);
}

void count_apart(benchmark::State& state, double lost_fraction, double converged) {
  state.counters[lost_fraction_counter] = lost_fraction;
  state.counters[error_counter] = std::abs(lost_fraction - converged);
  state.counters[apart_counter] = 1.0;
}

double time_values(benchmark::State& state, const stoss::BodyMaker& body, double at,
                   const stoss::RestitutionOptions& options) {
  const stoss::Restitution first = stoss::restitution(body, at, options);
  for (auto _ : state) {
    state.PauseTiming();
    const stoss::RefinableContact contact(body);
    for (const stoss::Run& run : first.runs) static_cast<void>(contact.at(run.cutoff, 1.0, {}));
    state.ResumeTiming();
    benchmark::DoNotOptimize(stoss::restitution(contact, at, options).lost_fraction.value);
  }
  return first.lost_fraction.value;
}

}  // namespace bench
