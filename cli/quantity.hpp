#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "record.hpp"
#include "stoss/restitution/restitution.hpp"
#include "units.hpp"

namespace stoss::cli {

/// A value of a result. That of an Estimate converges, and has its error beside it; all others are of one computation.
using Reading = std::variant<double, long, bool, std::string, Estimate>;

/// Where the table shows a quantity; it has room for the essentials only.
struct Column {
  int width = 0;            ///< 0: not shown
  int si_width = 0;         ///< with a material, of the SI value in place of the other
  bool with_error = false;  ///< as value ± error, in units of the first body
};

/// One quantity of a result: all that CSV, JSON and tables say of it follows.
template <typename Result>
struct Quantity {
  std::string name;
  Dimension dimension = Dimension::none;
  std::function<Reading(const Result&)> of;  ///< a member, or a function
  Column column{};
  bool in_si = true;                            ///< with a material, has its SI value beside it, as name_si
  std::function<bool(const Result&)> marked{};  ///< whether the table marks the value with !
};

template <typename Result>
using Quantities = std::vector<Quantity<Result>>;

/// Adds what a quantity of this name, dimension and column has to say.
void add_reading(Record& record, const std::string& name, const std::string& unit, const Reading& reading, int width,
                 const std::string& shown = {});

/// value ± error and the mark, as the table shows them.
[[nodiscard]] std::string shown_with_error(const Reading& reading, const std::string& mark);

/// The value in other units.
[[nodiscard]] Reading scaled(const Reading& reading, double scale);

/// Adds all quantities of a result: first in units of the first body, then in SI, if there is a material.
template <typename Result>
void add_quantities(Record& record, const Quantities<Result>& quantities, const Result& result, const Units& units) {
  for (const auto& [name, dimension, of, column, in_si, marked] : quantities) {
    const bool in_other = units.si && in_si && dimension != Dimension::none;
    const std::string mark = !marked ? "" : marked(result) ? " !" : "  ";
    const std::string shown = column.with_error ? shown_with_error(of(result), mark) : "";
    add_reading(record, name, units.own_name(dimension), of(result), in_other ? 0 : column.width, shown);
  }
  if (!units.si) return;
  for (const auto& [name, dimension, of, column, in_si, marked] : quantities) {
    if (!in_si || dimension == Dimension::none) continue;
    add_reading(record, name + "_si", Units::si_name(dimension), scaled(of(result), units.scale(dimension)),
                column.si_width);
  }
}

/// The quantities of each of several results as a JSON list of objects, without units.
template <typename Result>
nlohmann::ordered_json to_json(const Quantities<Result>& quantities, const std::vector<Result>& results) {
  auto list = nlohmann::ordered_json::array();
  for (const Result& result : results) list.push_back(to_json(quantities, result));
  return list;
}

/// The quantities of a result as a JSON object, without units.
template <typename Result>
nlohmann::ordered_json to_json(const Quantities<Result>& quantities, const Result& result) {
  Record record;
  add_quantities(record, quantities, result, {});
  auto object = nlohmann::ordered_json::object();
  for (const Entry& entry : record) {
    object[entry.key] = std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, entry.value);
  }
  return object;
}

}  // namespace stoss::cli
