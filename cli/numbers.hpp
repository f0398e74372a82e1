#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stoss::cli {

/// The numbers of a list `a,b,c`, a geometric series `log:a:b:n` or an arithmetic one `lin:a:b:n`.
/// @throws InvalidInput naming `name` for anything else
[[nodiscard]] std::vector<double> parse_series(std::string_view name, const std::string& text);

/// The parts of `text` between separators, empty ones too.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// `value ± error` to the digits that the error leaves, two of the error's own; at most 12 decimals, and from 8 on in
/// the short form 0.94706123(12).
[[nodiscard]] std::string with_error(double value, double error);

}  // namespace stoss::cli
