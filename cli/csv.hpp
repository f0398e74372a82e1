#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "record.hpp"

namespace stoss::cli {

/// With as many digits as tell it from every other value.
[[nodiscard]] std::string full_precision(const Value& value);

/// Last line of a file that is not complete.
inline constexpr std::string_view csv_interrupted =
    "# interrupted: the rows above are complete, later ones are missing";

/// First line of a file: which version made it, and what it holds.
[[nodiscard]] std::string csv_origin(const Provenance& provenance);

/// The inputs as the header has them, by name.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> csv_inputs(const Provenance& provenance);

/// All that comes before the names of the columns, with line ends.
[[nodiscard]] std::string csv_header(const Provenance& provenance);

/// The names of the columns, and a row, without line ends.
[[nodiscard]] std::string csv_columns(const Record& record);
[[nodiscard]] std::string csv_row(const Record& record);

}  // namespace stoss::cli
