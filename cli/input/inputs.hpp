#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app.hpp"
#include "output/fields.hpp"
#include "stoss/encounter/inputs.hpp"

namespace stoss::cli {

/// The name of the option of an input, without dashes: second-spin of second_spin.
[[nodiscard]] std::string option_of(std::string_view input);

/// Help of an input: what it is, its range, its units, and what holds without it.
[[nodiscard]] std::string help_of(const Input& input, Question question);

/// What help shows in place of the value.
[[nodiscard]] std::string placeholder_of(const Input& input, Question question);

/// The option of an input, declared by the table of inputs.
template <typename Value>
CLI::Option* add_input(CLI::App& command, Question question, std::string_view name, Value& value,
                       const std::string& group) {
  const Input& its = input(question, name);
  CLI::Option* option =
      add(command, "--" + option_of(name), value, help_of(its, question), placeholder_of(its, question), group);
  return its.use(question)->needed ? option->required() : option;
}

/// A number of an input in units of the first body. @throws InvalidInput
[[nodiscard]] double own_value(const Input& input, double value, const Units& units);

/// The numbers of an input as typed, in units of the first body. @throws InvalidInput
[[nodiscard]] std::vector<double> series_of(const Input& input, const std::string& text, const Units& units);

/// The ends of a range LOW:HIGH: as typed, and in units of the first body. @throws InvalidInput unless they ascend
struct Ends {
  std::pair<double, double> typed, own;
};
[[nodiscard]] Ends ends_of(const Input& input, const std::string& text, const Units& units);

/// What a result says of its origin: who meets whom as the core's document has it (of a body from a file its name and
/// a digest in place of its modes), and the inputs of the subcommand's question as typed or by default.
[[nodiscard]] Provenance provenance(const CLI::App& command, const Encounter& encounter);

/// How fast bodies meet, as a question takes it: --speed or, of a body with a material, --height of the fall.
struct ApproachOptions {
  Question question{};
  std::string speed, height;

  void add_to(CLI::App& command, Question of, const std::string& group);

  /// Speeds in units of the first body. @throws CLI::RequiredError if there are none, InvalidInput
  [[nodiscard]] std::vector<double> series(const Units& units) const;

  /// One of them. @param note why only one
  [[nodiscard]] double one(const Units& units, const std::string& note = {}) const;

  /// The ends of a range.
  [[nodiscard]] Ends ends(const Units& units) const;

 private:
  void require_given(const Units& units) const;
};

/// Refuses a word of an option, with those that it may be and the nearest of them.
/// @param where text behind the allowed ones
[[noreturn]] void refuse_word(const std::string& option, const std::string& got,
                              const std::vector<std::string>& allowed, const std::string& where = {});

/// The parts KEY=VALUE of an option from `first` on, in order, as keys and values.
/// @param where text behind the allowed keys
/// @throws InvalidInput for an unknown key, one that comes twice, and one without a value
[[nodiscard]] std::vector<std::pair<std::string, std::string>> parse_keys(const std::string& option,
                                                                          const std::vector<std::string>& parts,
                                                                          std::size_t first,
                                                                          const std::vector<std::string>& keys,
                                                                          const std::string& where = {});

}  // namespace stoss::cli
