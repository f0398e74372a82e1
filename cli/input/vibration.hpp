#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "stoss/impact/vibration.hpp"
#include "stoss/vibration/ensemble.hpp"

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

/// How the bodies of an ensemble vibrate on average: --temperature and --highest, or --spectrum.
struct SpectrumArguments {
  std::optional<double> temperature;
  std::optional<double> highest;
  std::vector<std::string> modes;

  void add_to(CLI::App& command);

  /// @throws InvalidInput unless one of the two ways is chosen, and as the core
  [[nodiscard]] Spectrum spectrum(const RefinableContact& contact, const Poll& poll) const;

  /// Adds what was chosen to the inputs of a result.
  void describe(nlohmann::ordered_json& inputs) const;

 private:
  [[nodiscard]] double chosen_highest() const;
};

}  // namespace stoss::cli
