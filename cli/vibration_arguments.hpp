#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "stoss/impact/vibration.hpp"

namespace stoss::cli {

/// How the bodies vibrate before the impact: --mode, as often as there are modes.
struct VibrationArguments {
  std::vector<std::string> modes;

  void add_to(CLI::App& command);

  /// @throws InvalidInput for what is no mode
  [[nodiscard]] Vibration vibration() const;

  /// Adds the modes to the inputs of a result, if there are any.
  void describe(nlohmann::ordered_json& inputs) const;
};

}  // namespace stoss::cli
