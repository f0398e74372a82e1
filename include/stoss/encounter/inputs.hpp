#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stoss/quantity.hpp"

/// The table of inputs: the numbers that a question takes in addition to who meets whom. Options, arguments, fields and
/// keys, their ranges, defaults and help follow from it in every face, as those of bodies follow from the table of
/// kinds.
namespace stoss {

/// What can be asked of an encounter.
enum class Question { impact, bounce, restitution, oblique, distribution, predict, table, fit, row, pulse, calibrate };

/// As what a question takes an input: one number, a whole one, a series of them, or the two ends of a range.
enum class Form { number, whole, series, range };

/// How a question takes an input.
struct Use {
  Question question;
  Form form = Form::number;
  std::optional<double> usual{};  ///< without which it holds; none: it must be given, or the core chooses it
  bool needed = false;            ///< must be given
};

/// A number that questions take.
struct Input {
  std::string_view name;  ///< as argument, field and key, as in second_spin; as an option --second-spin
  Dimension dimension;    ///< with a material it is given in SI; `none` for what is the same in all units
  std::string_view unit;  ///< of a dimension that results do not have, as in deg or J/m^2
  double low, high;       ///< of the range, in units of the first body
  bool low_included, high_included;
  std::string_view range;  ///< the same in words, as in "1e-8 to 1"
  std::string_view help;   ///< a sentence without a full stop
  std::vector<Use> uses;

  /// How a question takes it; null if it does not.
  [[nodiscard]] const Use* use(Question question) const;
};

/// All inputs, in the order in which faces show them. An input that means something else to another question has a row
/// for each meaning.
[[nodiscard]] const std::vector<Input>& inputs();

/// That of a question. @throws InvalidInput if the question takes none of that name
[[nodiscard]] const Input& input(Question question, std::string_view name);

/// All questions with their names, as those of the subcommands.
[[nodiscard]] const std::vector<std::pair<Question, std::string_view>>& questions();

/// Refuses a number that is out of the range of an input.
/// @param scales with which the number is in SI; none: it is in units of the first body
/// @param system units that the refusal names @throws InvalidInput
void require(const Input& input, double value, const std::optional<Scales>& scales, UnitSystem system);

/// The number in units of the first body, where rounding may not lead out of the range. @throws InvalidInput as require
[[nodiscard]] double in_own_units(const Input& input, double value, const std::optional<Scales>& scales,
                                  UnitSystem system);

/// The numbers of a series as typed, in units of the first body. A number between the ends of `log:a:b:n` or
/// `lin:a:b:n` is refused to six digits, beside the series: it was not typed. @throws InvalidInput as parse_series
[[nodiscard]] std::vector<double> series_in_own_units(const Input& input, std::string_view text,
                                                      const std::optional<Scales>& scales, UnitSystem system);

}  // namespace stoss
