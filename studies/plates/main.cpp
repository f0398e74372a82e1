// Balls on elastic plates: beside finite elements, of four pairs of materials in SI, where Zener's theory holds, how
// thick a plate must be to be a block, laminated glass and coated steel. Writes one CSV file each into a folder.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "study.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_plates FOLDER\n");
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    const std::string folder = std::string(argv[1]) + "/";
    study::write_fast(folder + "fast.csv");
    study::write_materials(folder + "materials.csv");
    study::write_map(folder + "map.csv");
    study::write_block(folder + "block.csv");
    study::write_layers(folder + "layers.csv");
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_plates: {}\n", error.what());
    return 1;
  }
  return 0;
}
