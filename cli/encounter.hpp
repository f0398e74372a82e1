#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "against.hpp"
#include "arguments.hpp"
#include "record.hpp"
#include "rod_arguments.hpp"
#include "sphere_arguments.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "units.hpp"

namespace stoss::cli {

/// The first body as it was given.
struct FirstBody {
  BodyKind kind = BodyKind::disk;
  DiskArguments disk;                 ///< the disk; of a sphere, the Poisson's ratio
  std::optional<SolidSphere> sphere;  ///< with a material
  std::optional<Rod> rod;             ///< with a material
  bool rigid = false;                 ///< has the mass and the units of the elastic one
  double loss_time = 0.0;             ///< R/c; s with a material
};

/// Who meets whom: a disk, a sphere or a rod, and a wall, a second body, a half-space or a half-plane.
class Encounter {
 public:
  /// @throws InvalidInput for numbers that no body or wall can have, and bodies that do not meet
  Encounter(FirstBody first, Against against);

  [[nodiscard]] bool rods() const { return first_.kind == BodyKind::rod; }
  [[nodiscard]] Units units() const { return {si_, first_.kind}; }
  [[nodiscard]] const Against& against() const { return against_; }

  /// The Poisson's ratio of the first body that the core computes with; 0 of a rod.
  [[nodiscard]] double poisson() const;

  /// At any cutoff, for `restitution`. @param poisson of the first body; rods have none
  /// @throws InvalidInput as the core
  [[nodiscard]] RefinableContact refinable(double poisson) const;

  /// Of any ratio of radii, for a table of pairs. The radius of the second does not count.
  /// @throws InvalidInput unless these are elastic disks or spheres
  [[nodiscard]] Mixture mixture(double poisson) const;

  /// At one cutoff and speed, for `impact`.
  [[nodiscard]] Contact contact(double poisson, double cutoff, double speed) const;

  /// Adds the two to the inputs of a result.
  void describe(nlohmann::ordered_json& inputs) const;

  /// Speed at which a sphere, or one of two, begins to yield, m/s, where a yield strength was given.
  [[nodiscard]] std::optional<double> yield_speed() const { return yield_speed_; }

  /// Adds that speed to a record, if there is one, and whether `speed`, in c, is beyond it.
  void add_yield(Record& record, double speed) const;

 private:
  [[nodiscard]] bool lossy() const { return first_.loss_time != 0.0; }
  [[nodiscard]] Disk first_disk(double poisson) const;
  [[nodiscard]] Sphere first_sphere(double poisson) const;
  [[nodiscard]] Rod first_rod() const;
  [[nodiscard]] double own_loss_time(double loss_time) const;  // in R/c of the first
  [[nodiscard]] BodyMaker make_first(double poisson) const;
  [[nodiscard]] BodyMaker make_second(double poisson) const;
  [[nodiscard]] Disk second_disk(double poisson) const;
  [[nodiscard]] Sphere second_sphere(double poisson) const;
  [[nodiscard]] Rod second_rod() const;
  [[nodiscard]] bool second_is_given() const;
  [[nodiscard]] Material second_material() const;
  [[nodiscard]] std::optional<double> find_yield_speed() const;
  void describe_second(nlohmann::ordered_json& inputs) const;

  FirstBody first_;
  std::optional<Scales> si_;
  Against against_;
  std::optional<double> yield_speed_;
};

/// The options that say who meets whom, but for --poisson.
struct EncounterArguments {
  DiskArguments disk;
  SphereArguments sphere;
  RodArguments rod;
  std::string body = "disk";
  bool rigid = false;
  std::string against = "wall";
  double loss_time = 0.0;
  CLI::App* command = nullptr;

  /// @param kind  that --against takes besides, with its help
  void add_to(CLI::App& to, const std::string& kind = {}, const std::string& help = {});

  /// @throws CLI::RequiredError for a body without its Poisson's ratio, InvalidInput for options that do not go
  /// together
  [[nodiscard]] Encounter encounter() const;
};

}  // namespace stoss::cli
