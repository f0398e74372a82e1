#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stoss/encounter/encounter.hpp"

namespace stoss::cli {

/// The options that give the first body, from the table of kinds: its kind, its numbers, its material in SI.
class BodyOptions {
 public:
  /// --poisson, which commands place before their own.
  void add_poisson_to(CLI::App& command);

  /// --body. @param kinds that it takes
  void add_kind_to(CLI::App& command, const std::vector<std::string>& kinds);

  /// --rigid-body and --loss-time.
  void add_dynamics_to(CLI::App& command);

  /// Sizes and material in SI. @param yield whether --yield is one of them
  void add_material_to(CLI::App& command, bool yield);

  /// Poisson's ratio, for a command that has an option of its own for it.
  void set_poisson(double value) { numbers_["poisson"] = value; }

  /// The body, without a check of its numbers.
  /// @throws CLI::RequiredError for a body without its Poisson's ratio, InvalidInput for options that do not go
  /// together
  [[nodiscard]] Participant body() const;

 private:
  [[nodiscard]] std::optional<double> given(const std::string& name) const;
  [[nodiscard]] bool in_si(const Kind& its) const;
  [[nodiscard]] Material material(const Kind& its) const;
  void require_whole_material(const Kind& its) const;
  void require_own(const Kind& its) const;

  std::vector<std::string> kinds_;
  std::string kind_ = "disk";
  std::map<std::string, std::optional<double>> numbers_;  // by parameter
  std::optional<double> yield_;
  std::string material_, plane_;
  bool rigid_ = false;
};

}  // namespace stoss::cli
