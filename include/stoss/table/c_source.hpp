#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stoss/table/pair_table.hpp"
#include "stoss/table/restitution_function.hpp"
#include "stoss/table/rule_table.hpp"

namespace stoss {

/// What a table in another program's language says of itself.
struct TableLabel {
  std::string name = "stoss";             ///< prefix of its names: letters, digits and _, at most 40
  std::string unit = "c";                 ///< of its speeds, as in m/s
  double scale = 1.0;                     ///< speed of the table over that of the function
  std::optional<double> by_models{};      ///< of predictions: the largest spread of the models, which no error holds
  std::vector<std::string> provenance{};  ///< lines: who made it, from what
};

/// Refuses a label with which no header can be written, before a table is computed for it.
/// @throws InvalidInput for a name that C cannot have and a scale that is not positive and finite
void validate(const TableLabel& label);

/// Source text of a header in C89, C++ included, that has a function as plain functions and needs <math.h> only.
///
/// With the name stoss it defines
///
///   static double stoss_restitution(double speed)        ε, as RestitutionFunction has it
///   static double stoss_restitution_error(double speed)  its error, interpolation included
///   STOSS_SLOWEST, STOSS_FASTEST                         the range
///
/// A speed counts without its sign. Beyond the range the error is HUGE_VAL, and ε that at the nearer end
/// (Beyond::clamp) or not a number (Beyond::error). NaN gives NaN. The range is that of the
/// function, rounded outwards to 15 digits where that is the same number but for rounding. Values agree with
/// RestitutionFunction to 1e-14. A call takes some 15 ns.
/// @throws InvalidInput for a name that C cannot have, a scale that is not positive and finite, and Beyond::law, which
///         no table has
[[nodiscard]] std::string c_header(const RestitutionFunction& function, const TableLabel& label = {});

/// The same of a table of pairs. With the name stoss it defines
///
///   static double stoss_pair_restitution(double speed, double ratio)        ε, as PairTable has it
///   static double stoss_pair_restitution_error(double speed, double ratio)  its error, interpolation included
///   STOSS_PAIR_SLOWEST, STOSS_PAIR_FASTEST, STOSS_PAIR_SMALLEST, STOSS_PAIR_GREATEST
///
/// The ratio is the radius of the second body over that of the first; of one material its inverse counts as well. One
/// that is not positive is beyond the range. A call takes some 20 ns.
/// @throws InvalidInput as above
[[nodiscard]] std::string c_header(const PairTable& table, const TableLabel& label = {});

/// Source text of a module in Rust, of edition 2018 or later, that has the functions of the header in C: `pub fn
/// stoss_restitution(speed: f64) -> f64` and so on, the range as `pub const STOSS_SLOWEST: f64`. It uses nothing but
/// the language; where the header has HUGE_VAL it has f64::INFINITY.
/// @throws InvalidInput as above
[[nodiscard]] std::string rust_module(const RestitutionFunction& function, const TableLabel& label = {});
[[nodiscard]] std::string rust_module(const PairTable& table, const TableLabel& label = {});

/// Source text of a module in JavaScript (ECMAScript 2015) that exports the functions of the header in C, and its
/// range as constants. Where the header has HUGE_VAL it has Infinity.
/// @throws InvalidInput as above
[[nodiscard]] std::string js_module(const RestitutionFunction& function, const TableLabel& label = {});
[[nodiscard]] std::string js_module(const PairTable& table, const TableLabel& label = {});

/// The same header of a collision rule. With the name stoss it defines, as RuleTable and stoss::collide have them,
///
///   static double stoss_rule_restitution(double speed, double sliding, double friction, double ratio)
///   static double stoss_rule_sliding(…), stoss_rule_restitution_error(…), stoss_rule_sliding_error(…)
///   static int stoss_rule_collide_2d(stoss_rule_body_2d *a, stoss_rule_body_2d *b, const double *normal,
///                                    double friction), and stoss_rule_collide_3d: 1, 0 if they do not approach,
///                                    −1 for what stoss::collide refuses; in both cases nothing changes
///   STOSS_RULE_SLOWEST, STOSS_RULE_FASTEST, of a mixture STOSS_RULE_SMALLEST and STOSS_RULE_GREATEST, and of a table
///   for one friction STOSS_RULE_FRICTION
///
/// Where RuleTable refuses, values are not numbers. A collision takes some 40 ns.
/// @throws InvalidInput as above
[[nodiscard]] std::string c_header(const RuleTable& rule, const TableLabel& label = {});

/// The same as a module of Rust or JavaScript. Bodies are structures and objects with the fields of those in C.
/// @throws InvalidInput as above
[[nodiscard]] std::string rust_module(const RuleTable& rule, const TableLabel& label = {});
[[nodiscard]] std::string js_module(const RuleTable& rule, const TableLabel& label = {});

}  // namespace stoss
