#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments.hpp"
#include "stoss/bodies/rod.hpp"

namespace stoss::cli {

/// The size of a rod in SI; its modulus and density are given as those of a disk.
struct RodArguments {
  std::optional<double> length;
  std::optional<double> area;

  void add_to(CLI::App& command);

  /// The rod in SI if a material was given. @throws InvalidInput if only part of one was
  [[nodiscard]] std::optional<Rod> si(const DiskArguments& material) const;
};

/// Adds a rod in SI and its scales to the inputs of a result.
void describe(const Rod& rod, nlohmann::ordered_json& inputs);

}  // namespace stoss::cli
