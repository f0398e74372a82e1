#pragma once

#include <string>

#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// A function as lines of two numbers, speed and ε, for programs that interpolate linearly in the speed between them.
///
/// Each row is as far from the one before as this leaves the error of the function and that of the interpolation
/// together within `error`, at all speeds of the range. There is no head: not every reader knows comments.
/// @param error maximum error of ε, 1.01 of function.greatest_error() or more
/// @param scale speed of the table over that of the function
/// @throws InvalidInput for a smaller error, and a scale that is not positive and finite
[[nodiscard]] std::string two_column(const RestitutionFunction& function, double error, double scale = 1.0);

}  // namespace stoss
