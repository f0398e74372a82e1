#pragma once

#include <string>

#include "output/rows.hpp"

namespace stoss::cli {

/// `value ± error` to the digits that the error leaves, two of the error's own; at most 12 decimals, and from 8 on in
/// the short form 0.94706123(12), of which small values that need more make 3.49794(14)e-19.
[[nodiscard]] std::string with_error(double value, double error);

/// The error of a value in its row: the word `unknown` where a finite value has none that is finite.
[[nodiscard]] Value error_of(double value, double error);

}  // namespace stoss::cli
