#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "input/body_options.hpp"
#include "stoss/encounter/encounter.hpp"

namespace stoss::cli {

/// The options that say who meets whom, but for --poisson.
struct EncounterOptions {
  BodyOptions first;
  std::string against = "wall";

  /// @param exponential whether the soft wall can be met
  /// @param note        to the help of --against
  void add_to(CLI::App& to, bool exponential = false, const std::string& note = {});

  /// @throws CLI::RequiredError for a body without its Poisson's ratio, InvalidInput for options that do not go
  /// together, and as validate
  [[nodiscard]] Encounter encounter() const;
};

/// What --against says: KIND[,key=value…].
/// @param first of which the Poisson's ratio is that of a material without its own
/// @throws InvalidInput for an unknown kind or key, a key that comes twice, and what is no number
[[nodiscard]] Participant parse_against(const std::string& text, const Participant& first);

/// Adds the first body, or who meets whom, to the inputs of a result.
void describe_first(const Encounter& encounter, nlohmann::ordered_json& inputs);
void describe(const Encounter& encounter, nlohmann::ordered_json& inputs);

/// The Poisson's ratio that the core computes with; 0 of a rod.
[[nodiscard]] double poisson_of(const Solid& solid);

/// Whether it meets a body, no wall; and whether that extends to infinity.
[[nodiscard]] inline bool meets_body(const Encounter& encounter) {
  return encounter.against.kind == "same" || !kind(encounter.against.kind).wall;
}
[[nodiscard]] inline bool meets_unbounded(const Encounter& encounter) {
  const Kind& against = kind(encounter.against.kind);
  return !against.wall && !against.bounded;
}

/// @throws InvalidInput for --tail of an exponential wall
void refuse_tail(const CLI::App& command, const Encounter& encounter);

/// @throws InvalidInput for an exponential wall, of which only single impacts are computed. @param hint who takes it
void refuse_soft(const Encounter& encounter, const std::string& hint = {});

[[nodiscard]] inline bool is_soft(const Encounter& encounter) { return encounter.against.kind == "exponential"; }
[[nodiscard]] inline bool is_rod(const Encounter& encounter) { return encounter.first.kind == "rod"; }

}  // namespace stoss::cli
