#pragma once

#include <string>

#include "stoss/table/restitution_function.hpp"
#include "stoss/table/rule_table.hpp"

namespace stoss {

/// A function as lines of two numbers, speed and ε, for programs that interpolate linearly in the speed between them.
///
/// Each row is as far from the one before as this leaves the error of the function and that of the interpolation
/// together within `error`, at all speeds of the range. There is no head: not every reader knows comments.
/// @param error maximum error of ε, 1.01 of function.greatest_error() or more
/// @param scale speed of the table over that of the function
/// @throws InvalidInput for a smaller error, and a scale that is not positive and finite
[[nodiscard]] std::string two_column(const RestitutionFunction& function, double error, double scale = 1.0);

/// A collision rule at one speed as lines of two numbers, s/(μ v_n) and s′/(μ v_n), for programs that interpolate
/// linearly, from 0 on. From the last line but one on, where all slides throughout, s′ follows the line to the last one
/// and beyond.
///
/// Between the lines s′ is off by no more than `error`, over |s| + μ v_n, that of the rule included.
/// @param speed in the unit of the rule. @param error 1.01 of rule.greatest_sliding_error() or more
/// @throws InvalidInput for a smaller error, a speed beyond the range, and a mixture
[[nodiscard]] std::string two_column(const RuleTable& rule, double speed, double error);

}  // namespace stoss
