#include "output/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "process/process.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::optional<Value> value_of_csv(const std::string& cell) {
  if (cell == "true" || cell == "false") return cell == "true";
  if (cell == unknown) return std::string(unknown);
  // As csv_row writes it: strtod alone would take spaces, a plus and hexadecimal digits, too.
  if (cell.empty() || cell.front() == '+' || cell.find_first_not_of("0123456789+-.einfa") != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  errno = 0;
  const double number = std::strtod(cell.c_str(), &end);
  const bool beyond = errno == ERANGE && (number == 0.0 || std::isinf(number));
  return !beyond && end == cell.c_str() + cell.size() ? std::optional<Value>(number) : std::nullopt;
}

/// A text that has commas stands in quotes.
std::string cell_of_csv(const Value& value) {
  std::string text = full_precision(value);
  if (text.find_first_of(",\"") == std::string::npos) return text;
  for (auto at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2)) text.insert(at, 1, '"');
  return '"' + text + '"';
}

/// As in 3.49794(14)e-19: the error has two digits and counts units of the last digit of the value.
std::string in_powers_of_ten(double value, double error) {
  const std::string doubt = fmt::format("{:.1e}", error);
  const int last = std::stoi(doubt.substr(4)) - 1;  // power of ten of that digit
  const std::string digits = fmt::format("{}", std::llround(std::abs(value) / std::pow(10.0L, last)));
  return fmt::format("{}{}.{}({}{})e{:+03}", value < 0.0 ? "-" : "", digits[0], digits.substr(1), doubt[0], doubt[2],
                     last + static_cast<int>(digits.size()) - 1);
}

}  // namespace

double number(const Value& value) {
  return std::visit(
      [](const auto& its) {
        if constexpr (requires { static_cast<double>(its); }) {
          return static_cast<double>(its);
        } else {
          return std::numeric_limits<double>::infinity();
        }
      },
      value);
}

const Value* find(const Columns& columns, const Row& row, std::string_view name) {
  const auto same = [name](const Column& column) { return column.name == name; };
  const auto found = std::find_if(columns.begin(), columns.end(), same);
  return found == columns.end() ? nullptr : &row[static_cast<std::size_t>(found - columns.begin())];
}

bool has(const Columns& columns, const Row& row, std::string_view flag, bool value) {
  const Value* its = find(columns, row, flag);
  return its != nullptr && *its == Value(value);
}

std::string full_precision(const Value& value) {
  return std::visit([](const auto& its) { return fmt::format("{}", its); }, value);
}

std::string with_error(double value, double error) {
  if (std::isnan(value)) return std::string(not_computed);
  if (std::isfinite(value) && !std::isfinite(error)) return fmt::format("{:.6g} ± {}", value, unknown);
  constexpr double longest = 1e9;  // with all its digits
  if (std::isfinite(value) && std::max(std::abs(value), error) >= longest) {
    return error < std::abs(value) && error > 1e-15 * std::abs(value) ? in_powers_of_ten(value, error)
                                                                      : fmt::format("{:.6g} ± {:.2g}", value, error);
  }
  constexpr int most = 12;
  int decimals = most;
  if (error > 0.0) decimals = std::max(1 - static_cast<int>(std::floor(std::log10(error))), 0);
  const double size = std::abs(value);
  if (decimals > most && size < 1e-6 && error < size && error > 1e-15 * size) return in_powers_of_ten(value, error);
  decimals = std::min(decimals, most);
  if (decimals < 8 || !std::isfinite(error)) return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
  return fmt::format("{:.{}f}({:.0f})", value, decimals, error * std::pow(10.0, decimals));
}

Value error_of(double value, double error) {
  if (std::isfinite(value) && !std::isfinite(error)) return std::string(unknown);
  return error;
}

std::string csv_origin(const Provenance& provenance) {
  return fmt::format("# stoss {}: {}", version(), provenance.schema);
}

std::vector<std::pair<std::string, std::string>> csv_inputs(const Provenance& provenance) {
  std::vector<std::pair<std::string, std::string>> inputs;
  for (const auto& [key, value] : provenance.inputs.items()) {
    inputs.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return inputs;
}

std::string csv_header(const Provenance& provenance) {
  std::string text = fmt::format("{}\n# command: {}\n", csv_origin(provenance), provenance.command);
  for (const auto& [key, value] : csv_inputs(provenance)) text += fmt::format("# {}: {}\n", key, value);
  return text;
}

std::string csv_columns(const Columns& columns) {
  std::vector<std::string> names;
  for (const auto& [name, unit, width, with_error, mark] : columns) {
    names.push_back(unit.empty() ? name : fmt::format("{}[{}]", name, unit));
  }
  return fmt::format("{}", fmt::join(names, ","));
}

std::string csv_row(const Row& row) {
  std::vector<std::string> cells;
  std::transform(row.begin(), row.end(), std::back_inserter(cells), cell_of_csv);
  return fmt::format("{}", fmt::join(cells, ","));
}

std::string with_checksum(const std::string& row) {
  constexpr std::uint32_t polynomial = 0xEDB88320;
  std::uint32_t sum = 0xFFFFFFFF;
  for (const char c : row) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? polynomial : 0U);
  }
  return fmt::format("{},{:08x}", row, ~sum);
}

std::optional<Row> row_of_csv(const std::string& line, std::size_t width) {
  Row row;
  for (const std::string& cell : split(line, ',')) {
    const auto value = value_of_csv(cell);
    if (!value) return std::nullopt;
    row.push_back(*value);
  }
  return row.size() == width ? std::optional(row) : std::nullopt;
}

}  // namespace stoss::cli
