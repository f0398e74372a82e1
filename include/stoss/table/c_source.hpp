#pragma once

#include <string>
#include <vector>

#include "stoss/table/pair_table.hpp"
#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// What a table in another program's language says of itself.
struct TableLabel {
  std::string name = "stoss";             ///< prefix of its names: letters, digits and _, at most 40
  std::string unit = "c";                 ///< of its speeds, as in m/s
  double scale = 1.0;                     ///< speed of the table over that of the function
  std::vector<std::string> provenance{};  ///< lines: who made it, from what
};

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

}  // namespace stoss
