#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "record.hpp"
#include "stoss/quantity.hpp"
#include "units.hpp"

namespace stoss::cli {

/// How the command shows a quantity; the printed table has room for the essentials only.
template <typename Result>
struct Column {
  int width = 0;                                ///< in the printed table; 0: not shown there
  int si_width = 0;                             ///< with a material, of the SI value in place of the other
  bool with_error = false;                      ///< printed as value ± error, in units of the first body
  bool in_si = true;                            ///< with a material, has its SI value next to it, as name_si
  bool left_out = false;                        ///< also of CSV and JSON
  std::function<bool(const Result&)> marked{};  ///< whether the printed table marks the value with !
};

/// The quantities of a kind of result as the command shows them, all but those named in the columns in the same way.
template <typename Result>
class Table {
 public:
  /// @throws std::logic_error if a column is of no quantity
  explicit Table(const Quantities<Result>& quantities, const std::map<std::string, Column<Result>>& columns = {}) {
    for (const auto& [name, column] : columns) {
      const auto same = [&called = name](const auto& quantity) { return quantity.name == called; };
      if (std::none_of(quantities.begin(), quantities.end(), same)) throw std::logic_error("no quantity " + name);
    }
    for (const Quantity<Result>& quantity : quantities) {
      const auto column = columns.find(quantity.name);
      rows_.emplace_back(quantity, column == columns.end() ? Column<Result>{} : column->second);
      if (rows_.back().second.left_out) rows_.pop_back();
    }
  }

  [[nodiscard]] const auto& rows() const { return rows_; }

 private:
  std::vector<std::pair<Quantity<Result>, Column<Result>>> rows_;
};

/// Adds a value and, if there is one, its error.
void add_value(Record& record, const std::string& name, const std::string& unit, const Value& value,
               const double* error, int width, const std::string& shown = {});

/// The value in other units.
[[nodiscard]] Value scaled(const Value& value, double scale);

/// value ± error and the mark, as the table shows them.
[[nodiscard]] std::string shown_with_error(const Value& value, double error, const std::string& mark);

/// Adds all quantities of a result: first in units of the first body, then in SI, if there is a material.
template <typename Result>
void add_quantities(Record& record, const Table<Result>& table, const Result& result, const Units& units) {
  for (const auto& [quantity, column] : table.rows()) {
    const bool in_other = units.si && column.in_si && quantity.dimension != Dimension::none;
    const Value value = quantity.value(result);
    const double error = quantity.error ? quantity.error(result) : 0.0;
    const std::string mark = !column.marked ? "" : column.marked(result) ? " !" : "  ";
    const std::string shown = column.with_error ? shown_with_error(value, error, mark) : "";
    add_value(record, quantity.name, units.own_name(quantity.dimension), value, quantity.error ? &error : nullptr,
              in_other ? 0 : column.width, shown);
  }
  if (!units.si) return;
  for (const auto& [quantity, column] : table.rows()) {
    if (!column.in_si || quantity.dimension == Dimension::none) continue;
    const double scale = units.scale(quantity.dimension);
    const double error = quantity.error ? quantity.error(result) * scale : 0.0;
    add_value(record, quantity.name + "_si", units.si_name(quantity.dimension), scaled(quantity.value(result), scale),
              quantity.error ? &error : nullptr, column.si_width);
  }
}

/// The quantities of a result as a JSON object, without units.
template <typename Result>
nlohmann::ordered_json to_json(const Table<Result>& table, const Result& result) {
  Record record;
  add_quantities(record, table, result, {});
  auto object = nlohmann::ordered_json::object();
  for (const Entry& entry : record) {
    object[entry.key] = std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, entry.value);
  }
  return object;
}

/// The quantities of each of several results as a JSON list of objects, without units.
template <typename Result>
nlohmann::ordered_json to_json(const Table<Result>& table, const std::vector<Result>& results) {
  auto list = nlohmann::ordered_json::array();
  for (const Result& result : results) list.push_back(to_json(table, result));
  return list;
}

}  // namespace stoss::cli
