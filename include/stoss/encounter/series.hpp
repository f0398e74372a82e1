#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stoss/cxx20.hpp"

namespace stoss {

/// Numbers as people type them: one, or a series. The same text gives the same bits in every face and on any machine.
///
/// A number is decimal: sign, digits with or without a point, exponent, as in -0.2 or 1e-4. Spaces around it do not
/// count. It becomes the nearest double.

/// Most numbers of a series a:b:n.
inline constexpr int longest_series = 1'000'000;

/// One number. @throws InvalidInput naming `name` for anything else, also for nan, inf and what no double can hold
[[nodiscard]] double parse_number(std::string_view name, std::string_view text);

/// A number without a fraction, as in 64 or 1e3. @throws InvalidInput
[[nodiscard]] int parse_integer(std::string_view name, std::string_view text);

/// The numbers of a list `a,b,c`, a geometric series `log:a:b:n` or an arithmetic one `lin:a:b:n`; n = 1: only a.
///
/// The values of an arithmetic series are the doubles nearest to a + (b − a) i/(n − 1) of the decimal numbers a and b.
/// Those of a geometric one, a (b/a)^(i/(n − 1)), are computed with 70 digits, then rounded.
/// @throws InvalidInput
[[nodiscard]] std::vector<double> parse_series(std::string_view name, std::string_view text);

}  // namespace stoss
