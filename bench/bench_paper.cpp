#include "common.hpp"
#include "paper_protocol.hpp"
#include "stoss/impact/impact.hpp"

namespace bench {
namespace {

constexpr std::size_t paper_modes = 940;
constexpr double energy_tolerance = 1e-3;
constexpr double preliminary_cutoff = 100.0;  // 4510 modes compete

/// Modes and step of the paper's protocol, found once and not timed.
struct Preparation {
  stoss::Body body;
  PaperSettings settings;
  std::vector<stoss::ModeGroup> modes;  // of the body, without groups that have none
};
const Preparation& preparation() {
  static const Preparation prepared = [] {
    Preparation result;
    result.settings.speed = speed;
    result.body = most_energetic(disk_body(preliminary_cutoff), paper_modes, result.settings);
    for (const stoss::ModeGroup& group : result.body.groups) {
      if (!group.omega.empty()) result.modes.push_back(group);
    }
    result.settings.step = largest_step(result.modes, result.settings, energy_tolerance);
    return result;
  }();
  return prepared;
}

void run(benchmark::State& state, const std::vector<stoss::ModeGroup>& modes) {
  PaperResult result;
  for (auto _ : state) result = paper_impact(modes, preparation().settings);
  count(state, result.lost_fraction);
  state.counters["energy_error"] = result.energy_error;
  state.counters["steps"] = static_cast<double>(result.steps);
}

}  // namespace

void add_paper() {
  add(reference_name, [](benchmark::State& state) { run(state, preparation().modes); });
  add("the paper's protocol, every mode at every angle",
      [](benchmark::State& state) { run(state, mode_by_mode(preparation().modes)); });
  add("the paper's modes and wall in stoss", [](benchmark::State& state) {
    const stoss::ExponentialWall wall{preparation().settings.hardness, preparation().settings.strength};
    double lost_fraction = 0.0;
    for (auto _ : state) lost_fraction = stoss::impact(preparation().body, wall, speed).lost_fraction;
    count(state, lost_fraction);
  });
}

}  // namespace bench
