#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "output/fields.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/vibration/ensemble.hpp"

namespace stoss::cli {

/// The options that give the first body, from the table of kinds: its kind, its numbers, its material in SI.
class BodyOptions {
 public:
  /// --poisson, which commands place before their own.
  void add_poisson_to(CLI::App& command);

  /// --body. @param kinds that it takes @param files whether it takes @FILE too
  void add_kind_to(CLI::App& command, const std::vector<std::string>& kinds, bool files = false);

  /// --rigid-body, how the material loses energy (--loss-time, --quality, --relaxation, --young-is) and how rough its
  /// face is (--roughness, --u0), its coat, and from which stress on it yields.
  void add_dynamics_to(CLI::App& command);

  /// Sizes and material in SI.
  void add_material_to(CLI::App& command);

  /// Poisson's ratio, for a command that has an option of its own for it.
  void set_poisson(double value) { numbers_["poisson"] = value; }

  /// The body, without a check of its numbers.
  /// @throws CLI::RequiredError for a body without its Poisson's ratio, InvalidInput for options that do not go
  /// together
  [[nodiscard]] Participant body() const;

 private:
  [[nodiscard]] bool in_si() const;
  void require_own(const Kind& its) const;
  void set_numbers(Participant& body) const;

  std::vector<std::string> kinds_;
  std::string kind_ = "sphere";
  std::map<std::string, std::optional<double>> numbers_;  // by parameter
  std::string material_, plane_, relaxation_, young_is_;
  std::optional<double> c_p_, c_s_;  ///< speeds of waves, m/s
  bool rigid_ = false;
};

/// Whether it is @FILE.
[[nodiscard]] inline bool names_file(const std::string& text) { return text.starts_with('@'); }

/// All of a file of at most 64 MiB. @param what it should be, for refusals
/// @throws InvalidInput for what is no file, and OutputError where it cannot be read
[[nodiscard]] std::string text_of_file(const std::string& option, const std::string& path, const std::string& what);

/// The body of a file, by its modes at a point. @param text @FILE
/// @throws InvalidInput for a file that cannot be read, and as modal_body_from_json
[[nodiscard]] Participant modal_from_file(const std::string& option, const std::string& text);

/// Gives a body in SI the material of its name or, in place of them, of its numbers. Sizes that are missing, and
/// numbers beside a named material, are for validate.
/// @param poisson of a material without its own
/// @param option  named by refusals
/// @throws InvalidInput for a name that is not known, and for a material that is not whole
void set_material(Participant& of, double poisson, const std::string& option);

/// Takes the modulus of a body as "instantaneous" or "relaxed". @throws InvalidInput without a relaxation
void take_young(Participant& of, const std::string& young_is);

/// The options that say who meets whom, but for --poisson.
struct EncounterOptions {
  BodyOptions first;
  std::string against = "wall";
  std::vector<std::string> modes{};

  /// @param note to the help of --against
  void add_to(CLI::App& to, const std::string& note = {});

  /// @throws CLI::RequiredError for a body without its Poisson's ratio, InvalidInput for options that do not go
  /// together, and as validate
  [[nodiscard]] Encounter encounter() const;
};

/// Whether bodies of its kind have a Poisson's ratio.
[[nodiscard]] inline bool has_poisson(const Participant& of) { return parameter(kind(of.kind), "poisson") != nullptr; }

/// That of the first body as the core computes with it; nothing where it has none.
[[nodiscard]] std::optional<double> poisson_of(const Encounter& encounter);

/// Which modes of the bodies a single impact keeps, and what the others do: --cutoff and --tail.
struct KeptOptions {
  std::string word = "radiating";
  double cutoff = 0.0;

  void add_to(CLI::App& command, Question question);

  [[nodiscard]] Tail tail() const;

  /// Chooses a cutoff where none is given. @param slowest impact, c @param most cutoff, c/R
  void choose(const CLI::App& command, const Encounter& encounter, double slowest, double most, const Poll& poll);

  /// With both as they were chosen.
  [[nodiscard]] Provenance provenance(const CLI::App& command, const Encounter& encounter) const;
};

/// --mode, as often as there are modes: how the bodies vibrate before the impact.
void add_modes_to(CLI::App& command, std::vector<std::string>& modes);

/// @throws InvalidInput for what is no mode
[[nodiscard]] Vibration vibration_of(const std::vector<std::string>& modes);

/// The same for the bodies of a row by their numbers.
void add_modes_of_row_to(CLI::App& command, std::vector<std::string>& modes);
[[nodiscard]] Vibration vibration_of_row(const std::vector<std::string>& modes);

/// How the bodies of an ensemble vibrate on average: --temperature and --highest, or --spectrum.
struct SpectrumArguments {
  std::optional<double> temperature;
  std::optional<double> highest;
  std::vector<std::string> modes;

  void add_to(CLI::App& command);

  /// @throws InvalidInput unless one of the two ways is chosen, and as the core
  /// Notes the highest frequency that it takes. @throws InvalidInput, and what the makers and poll throw
  [[nodiscard]] Spectrum spectrum(const RefinableContact& contact, const Poll& poll);

  /// Adds what was chosen to the inputs of a result.
  void describe(nlohmann::ordered_json& inputs) const;

 private:
  [[nodiscard]] Vibration means() const;
};

}  // namespace stoss::cli
