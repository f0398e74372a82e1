#include <string>
#include <vector>

#include "common.hpp"
#include "stoss/vibration/rod_chain_run.hpp"

namespace bench {
namespace {

constexpr int rods_in_chain = 20;

/// Rods with lengths spread by ±10 %, eleven times as much room as they take.
stoss::RodChain chain(const stoss::RodChainOptions& options) {
  std::vector<stoss::Rod> rods;
  double length = 0.0;
  for (int k = 0; k < rods_in_chain; ++k) {
    rods.push_back({.length = 0.9 + 0.2 * k / (rods_in_chain - 1)});
    length += rods.back().length;
  }
  return {rods, 11.0 * length, stoss::thermal_velocities(rods, 1.0, 1), options};
}

/// One collision, when the chain has forgotten its start.
void add_chain(const std::string& name, const stoss::RodChainOptions& options) {
  add("collision in a chain of rods, " + name, [options](benchmark::State& state) {
    stoss::RodChain rods = chain(options);
    constexpr int forgotten = 400;
    for (int k = 0; k < forgotten; ++k) rods.collide();
    for (auto _ : state) benchmark::DoNotOptimize(rods.collide());
  });
}

}  // namespace

void add_rods() {
  using stoss::RodMethod;
  add_chain("50 modes", {});
  add_chain("50 modes, unexcited", {.decay_time = 0.0});
  add_chain("characteristics, 400 pieces", {.method = RodMethod::characteristics});
  add_chain("characteristics, unexcited", {.method = RodMethod::characteristics, .decay_time = 0.0});
}

}  // namespace bench
