#include <utility>

#include "common.hpp"
#include "stoss/encounter/seismogram.hpp"

namespace bench {
namespace {

stoss::Encounter ball_on(const char* kind, stoss::Values values) {
  stoss::Encounter met;
  met.first = stoss::of_kind("sphere");
  met.first.values = {{"poisson", poisson_of_sphere}};
  met.against = stoss::of_kind(kind);
  met.against.values = std::move(values);
  return met;
}

/// A receiver of 500 instants, without the pulse.
void add_receiver(const char* name, const stoss::Encounter& met, double speed, const stoss::Receiver& receiver) {
  add(name, [=](benchmark::State& state) {
    const stoss::Pulse pulse = stoss::pulse(stoss::refinable(met), speed);
    for (auto _ : state) {
      benchmark::DoNotOptimize(stoss::seismogram(met, pulse, receiver).max_normal.value);
    }
    state.counters[sphere_counter] = 1.0;
  });
}

}  // namespace

void add_seismograms() {
  const stoss::Encounter block = ball_on("half-space", {}), plate = ball_on("plate", {{"thickness", 20.0}});
  add_receiver("a receiver on a half-space, 20 R away", block, 1e-3, {20.0, 0.0});
  add_receiver("a receiver in a half-space, 20 R away and 1 R deep", block, 1e-3, {20.0, 1.0});
  add_receiver("a receiver on a half-space, 1000 R away", block, 1e-3, {1000.0, 0.0});
  add_receiver("a receiver below a plate of 20 R", plate, 1e-3, {0.0, 20.0});
  add_receiver("a receiver on a plate of 20 R, 100 R away", plate, 1e-3, {100.0, 0.0});
}

}  // namespace bench
