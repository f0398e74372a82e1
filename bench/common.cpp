#include "common.hpp"

#include <cmath>
#include <map>
#include <sstream>

#include "stoss/bodies/disk.hpp"

namespace bench {

const stoss::Body& disk_body(double cutoff) {
  static std::map<double, stoss::Body> bodies;
  auto found = bodies.find(cutoff);
  if (found == bodies.end()) found = bodies.emplace(cutoff, stoss::disk(poisson, cutoff)).first;
  return found->second;
}

std::string label(const std::string& name, double tolerance, double at) {
  std::ostringstream text;
  text << name << " to " << tolerance;
  if (at != speed) text << ", v = " << at;
  return text.str();
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

void count_task(benchmark::State& state, double at, double tolerance) {
  state.counters[speed_counter] = at;
  state.counters[tolerance_counter] = tolerance;
}

void count_sphere_task(benchmark::State& state, bool on_half_space, double at, double tolerance) {
  state.counters[sphere_counter] = 1.0;
  state.counters[obstacle_counter] = on_half_space ? 1.0 : 0.0;
  count_task(state, at, tolerance);
}

void count_work(benchmark::State& state, const stoss::RefinableContact& contact, double at,
                const stoss::Restitution& result) {
  double work = 0.0;
  for (const stoss::Run& run : result.runs) {
    const stoss::Contact& resolved = contact.at(run.cutoff, contact.stretch(at), {});
    double modes = static_cast<double>(stoss::mode_count(*resolved.first));
    if (resolved.second != nullptr) modes += static_cast<double>(stoss::mode_count(*resolved.second));
    work += static_cast<double>(run.steps) * modes * run.resolution.nodes;
  }
  state.counters[work_counter] = work;
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
  count_work(state, stoss::RefinableContact(body), at, first);
  return first.lost_fraction.value;
}

}  // namespace bench
