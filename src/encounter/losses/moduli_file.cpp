#include "stoss/encounter/moduli_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "check.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// What a column holds, and what its numbers are multiplied by.
struct Column {
  enum class Of { frequency, storage, loss, tangent } of;
  double unit = 1.0;
};

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  return first == std::string_view::npos
             ? ""
             : std::string(text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1));
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> all;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    all.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return all;
}

/// Names of columns, in lower case and without spaces and underscores, and the unit that is meant without one.
Column column_of(const std::string& where, const std::string& title) {
  constexpr double turn = 2.0 * std::numbers::pi;
  using enum Column::Of;
  static const std::vector<std::pair<std::string, Column>> names{
      {"f", {frequency, turn}}, {"frequency", {frequency, turn}}, {"omega", {frequency}},   {"e'", {storage}},
      {"storage", {storage}},   {"storagemodulus", {storage}},    {"e''", {loss}},          {"loss", {loss}},
      {"lossmodulus", {loss}},  {"tandelta", {tangent}},          {"tan(delta)", {tangent}}};
  static const std::vector<std::pair<std::string, double>> units{
      {"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"Hz", turn}, {"kHz", 1e3 * turn}, {"rad/s", 1.0}};
  const auto end = title.find('[');
  std::string name;
  for (const char c : title.substr(0, end)) {
    if (c != ' ' && c != '_') name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const auto its = std::find_if(names.begin(), names.end(), [&](const auto& each) { return each.first == name; });
  if (its == names.end()) {
    throw InvalidInput::out_of_range(where, in_quotes(title), "f or omega, E' and E'' or tan_delta",
                                     "in the header; a unit may follow in brackets");
  }
  Column made = its->second;
  if (end == std::string::npos) return made;
  const std::string unit = trimmed(title.substr(end + 1, title.find(']') - end - 1));
  const bool of_frequency = made.of == frequency;
  const auto known = std::find_if(units.begin(), units.end(), [&](const auto& each) { return each.first == unit; });
  const bool fits = known != units.end() && made.of != tangent && (known - units.begin() > 3) == of_frequency;
  if (!fits) {
    throw InvalidInput::out_of_range(where, in_quotes(title),
                                     of_frequency ? "Hz, kHz or rad/s" : "Pa, kPa, MPa or GPa");
  }
  made.unit = known->second;
  return made;
}

/// Of which there must be one.
bool has(const std::vector<Column>& columns, const std::string& where, Column::Of what) {
  const auto count = std::count_if(columns.begin(), columns.end(), [&](const Column& each) { return each.of == what; });
  if (count > 1) throw InvalidInput::out_of_range(where, "two columns of the same", "one of each");
  return count == 1;
}

std::vector<Column> header_of(const std::string& where, const std::vector<std::string>& titles) {
  std::vector<Column> columns;
  columns.reserve(titles.size());
  for (const std::string& title : titles) columns.push_back(column_of(where, title));
  using enum Column::Of;
  const bool tangents = has(columns, where, tangent), losses = has(columns, where, loss);
  if (!has(columns, where, frequency)) throw InvalidInput::missing(where + " f", "a column of frequencies, f or omega");
  if (!has(columns, where, storage)) {
    throw InvalidInput::missing(where + " E'", "a column of storage moduli",
                                tangents ? "tan_delta alone does not tell how E' rises" : "");
  }
  if (tangents == losses) {
    throw InvalidInput::missing(where + " E''",
                                tangents ? "E'' or tan_delta, one of both" : "a column of E'' or tan_delta");
  }
  return columns;
}

void read_row(const std::string& where, const std::vector<std::string>& cells, const std::vector<Column>& columns,
              Moduli& into) {
  if (cells.size() != columns.size()) {
    throw InvalidInput::out_of_range(where, std::to_string(cells.size()) + " values",
                                     std::to_string(columns.size()) + ", as in the header");
  }
  double tangent = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double value = parse_number(where, cells[i]);
    require(where, value, {0.0, 1e30, false, true, "numbers above 0"}, "frequencies and moduli");
    switch (columns[i].of) {
      case Column::Of::frequency:
        into.frequency.push_back(value * columns[i].unit);
        break;
      case Column::Of::storage:
        into.storage.push_back(value * columns[i].unit);
        break;
      case Column::Of::loss:
        into.loss.push_back(value * columns[i].unit);
        break;
      case Column::Of::tangent:
        tangent = value;
        break;
    }
  }
  if (tangent > 0.0) into.loss.push_back(tangent * into.storage.back());
  const std::size_t count = into.frequency.size();
  if (count > 1 && into.frequency[count - 1] <= into.frequency[count - 2]) {
    throw InvalidInput::out_of_range(where, "a frequency that does not rise", "rising frequencies",
                                     "sort the file, and leave out what is there twice");
  }
}

}  // namespace

Moduli moduli_from_csv(std::string_view text, const std::string& where) {
  Moduli made;
  std::vector<Column> columns;
  char separator = ',';
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1, ++number;
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const std::string place = where + " line " + std::to_string(number);
    if (columns.empty()) {
      for (const char each : {'\t', ';'}) {
        if (line.find(each) != std::string_view::npos) separator = each;
      }
      columns = header_of(place, cells_of(line, separator));
    } else {
      read_row(place, cells_of(line, separator), columns, made);
    }
  }
  if (columns.empty()) throw InvalidInput::missing(where, "a header, as in f, E', E''");
  return made;
}

}  // namespace stoss
