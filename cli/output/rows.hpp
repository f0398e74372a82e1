#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stoss/quantity.hpp"

namespace stoss::cli {

/// One column of rows.
struct Column {
  std::string name;                                    ///< in JSON, CSV and the printed table
  std::string unit{};                                  ///< "" for a pure number
  int width = 0;                                       ///< in the printed table; 0: not shown there
  bool with_error = false;                             ///< printed as value ± error, which is in the next column
  std::optional<std::pair<std::string, bool>> mark{};  ///< a flag, and which value of it marks what is printed with !
};

/// What a row has in each column, as values: text is made of them when they are written, and read when a run goes on.
using Columns = std::vector<Column>;
using Row = std::vector<Value>;

/// In place of an error that is not known.
inline constexpr std::string_view unknown = "unknown";

/// In the printed table, in place of a value that there is not; why, a warning says.
inline constexpr std::string_view not_computed = "not computed";

/// A number or a flag as a number; infinite where it is unknown.
[[nodiscard]] double number(const Value& value);

/// What a row has in the column of that name; null if there is none.
[[nodiscard]] const Value* find(const Columns& columns, const Row& row, std::string_view name);

/// Whether a row has this flag, with this value.
[[nodiscard]] bool has(const Columns& columns, const Row& row, std::string_view flag, bool value);

template <typename T, typename... More>
void append(std::vector<T>& to, const More&... more) {
  (to.insert(to.end(), more.begin(), more.end()), ...);
}

/// What made the data: written at the head of CSV and JSON.
struct Provenance {
  std::string schema;   ///< name of the kind of rows, as in "restitution"
  std::string command;  ///< the command line
  nlohmann::ordered_json inputs;
};

/// With as many digits as tell it from every other value.
[[nodiscard]] std::string full_precision(const Value& value);

/// `value ± error` to the digits that the error leaves, two of the error's own; at most 12 decimals, and from 8 on in
/// the short form 0.94706123(12), of which small values that need more make 3.49794(14)e-19.
[[nodiscard]] std::string with_error(double value, double error);

/// The error of a value in its row: the word `unknown` where a finite value has none that is finite.
[[nodiscard]] Value error_of(double value, double error);

/// Last line of a CSV file that is not complete.
inline constexpr std::string_view csv_interrupted =
    "# interrupted: the rows above are complete, later ones are missing";

/// First line of a CSV file: which version made it, and what it holds.
[[nodiscard]] std::string csv_origin(const Provenance& provenance);

/// The inputs as the header has them, by name.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> csv_inputs(const Provenance& provenance);

/// All that comes before the names of the columns, with line ends.
[[nodiscard]] std::string csv_header(const Provenance& provenance);

/// The names of columns, and a row, without line ends.
[[nodiscard]] std::string csv_columns(const Columns& columns);
[[nodiscard]] std::string csv_row(const Row& row);

/// Name of the last column of a CSV file that a run may continue: of each row, the checksum of what is before it.
inline constexpr std::string_view csv_checksum = "checksum";

/// A row with its checksum: CRC-32 of its text in eight hexadecimal digits, as in the store of sweeps.
[[nodiscard]] std::string with_checksum(const std::string& row);

/// The cells of a line of CSV as values: flags, the word unknown, numbers. @return nothing for what is no row
[[nodiscard]] std::optional<Row> row_of_csv(const std::string& line, std::size_t width);

}  // namespace stoss::cli
