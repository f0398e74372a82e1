#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "against.hpp"
#include "arguments.hpp"
#include "rod_arguments.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/ladder.hpp"
#include "units.hpp"

namespace stoss::cli {

/// Who meets whom: a disk or a rod, and a wall or a second body.
class Encounter {
 public:
  /// @param disk the first body, if it is one
  /// @throws InvalidInput for numbers that no body or wall can have
  /// @param rod  the first body in SI, if it is a rod with a material
  Encounter(bool rods, const DiskArguments& disk, const std::optional<Rod>& rod, Against against);

  [[nodiscard]] bool rods() const { return rods_; }
  [[nodiscard]] Units units() const { return {si_, rods_}; }
  [[nodiscard]] const Against& against() const { return against_; }

  /// At any cutoff, for `restitution`. @param poisson of the first disk; rods have none
  /// @throws InvalidInput as the core
  [[nodiscard]] RefinableContact refinable(double poisson) const;

  /// At one cutoff, for `impact`.
  [[nodiscard]] Contact contact(double poisson, double cutoff) const;

  /// Adds the two to the inputs of a result.
  void describe(nlohmann::ordered_json& inputs) const;

 private:
  [[nodiscard]] BodyMaker first(double poisson) const;
  [[nodiscard]] BodyMaker second(double poisson) const;
  [[nodiscard]] Disk second_disk(double poisson) const;
  [[nodiscard]] Rod second_rod() const;
  [[nodiscard]] Material second_material() const;

  bool rods_;
  DiskArguments disk_;
  std::optional<Rod> rod_;
  std::optional<Scales> si_;
  Against against_;
};

/// The options that say who meets whom, but for --poisson.
struct EncounterArguments {
  DiskArguments disk;
  RodArguments rod;
  std::string body = "disk";
  std::string against = "wall";
  CLI::App* command = nullptr;

  /// @param kind  that --against takes besides, with its help
  void add_to(CLI::App& to, const std::string& kind = {}, const std::string& help = {});

  /// @throws CLI::RequiredError for a disk without a Poisson number, InvalidInput for options that do not go together
  [[nodiscard]] Encounter encounter() const;
};

}  // namespace stoss::cli
