#include "output/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "process/text.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::optional<Value> value_of_csv(const std::string& cell) {
  if (cell == "true" || cell == "false") return cell == "true";
  if (cell == unknown) return std::string(unknown);
  double number = 0.0;
  const char* const last = cell.data() + cell.size();
  const auto [end, error] = std::from_chars(cell.data(), last, number);
  return error == std::errc{} && end == last ? std::optional<Value>(number) : std::nullopt;
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
  std::transform(row.begin(), row.end(), std::back_inserter(cells), full_precision);
  return fmt::format("{}", fmt::join(cells, ","));
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
