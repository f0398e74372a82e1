#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stoss::cli {

/// Of a series, and rows of a job.
inline constexpr int most_numbers = 1'000'000;

/// A decimal number: sign, digits with or without a point, exponent, as in -0.2 or 1e-4. Spaces around it do not count.
/// @throws InvalidInput naming `name` for anything else, also for nan, inf and what no double can hold
[[nodiscard]] double parse_number(std::string_view name, const std::string& text);

/// A decimal number without a fraction, as in 64 or 1e3. @throws InvalidInput
[[nodiscard]] int parse_integer(std::string_view name, const std::string& text);

/// The numbers of a list `a,b,c`, a geometric series `log:a:b:n` or an arithmetic one `lin:a:b:n`. @throws InvalidInput
[[nodiscard]] std::vector<double> parse_series(std::string_view name, const std::string& text);

/// The ends of a range to six digits, rounded towards its inside, so that what is shown is allowed.
[[nodiscard]] std::string lower_end(double value);
[[nodiscard]] std::string upper_end(double value);

}  // namespace stoss::cli
