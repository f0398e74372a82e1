// Bodies that vibrate before they meet a wall or each other: one table for each picture of
// docs/understand/findings/vibration.md.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "study.hpp"

namespace study {

const Case& sphere() {
  static const Case it{"sphere", stoss::RefinableContact(stoss::sphere(0.3))};
  return it;
}

const Case& disk() {
  static const Case it{"disk", stoss::RefinableContact(stoss::disk(0.33))};
  return it;
}

}  // namespace study

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_vibration FOLDER\n");
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    study::write_phases(folder + "phases.csv");
    study::write_modes(folder + "modes.csv");
    study::write_temperatures(folder + "temperatures.csv", folder + "samples.csv");
    study::write_heat(folder + "heat.csv");
    study::write_bounces(folder + "bounces.csv", folder + "shares.csv", folder + "equipartition.csv");
    study::write_chain(folder + "chain.csv", folder + "chain_restitution.csv");
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_vibration: {}\n", error.what());
    return 1;
  }
  return 0;
}
