#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/output_options.hpp"
#include "output/rows.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/quantity.hpp"

namespace stoss::cli {

/// The units of results: those of the first body and, with a material, SI.
struct Units {
  UnitSystem own = UnitSystem::disk;
  UnitSystem in_si = UnitSystem::disk_si;
  std::optional<Scales> si{};

  /// Name of a unit of the first body, as in R/c; "" for a pure number.
  [[nodiscard]] std::string own_name(Dimension dimension) const { return std::string(unit_name(dimension, own)); }
};

/// The units of results of an encounter.
[[nodiscard]] Units units_of(const Encounter& encounter);

/// The columns of an input, with a material in SI too, and what a row has there of one in units of the first body.
/// @param width in the printed table
[[nodiscard]] Columns input_columns(const std::string& name, Dimension dimension, const Units& units, int width);
[[nodiscard]] Row input_row(double value, Dimension dimension, const Units& units);

/// Those of the speed of approach.
[[nodiscard]] Columns speed_columns(const Units& units);
[[nodiscard]] Row speed_row(const Units& units, double speed);

/// How the command shows a quantity; the printed table has room for the essentials only.
struct Shown {
  int width = 0;                                       ///< in the printed table; 0: not shown there
  int si_width = 0;                                    ///< with a material, of the SI value in place of the other
  bool with_error = false;                             ///< printed as value ± error, in units of the first body
  bool in_si = true;                                   ///< with a material, has its SI value next to it, as name_si
  std::optional<std::pair<std::string, bool>> mark{};  ///< as of a column
};

/// The columns that a kind of result has in rows, by its table of quantities: first all in units of the first body,
/// then, if there is a material, in SI.
template <typename Result>
class Fields {
 public:
  /// @param shown of those quantities that are not shown in the same way as all
  explicit Fields(const Quantities<Result>& quantities, const Units& units = {},
                  const std::map<std::string, Shown>& shown = {}) {
    const auto how = [&shown](const auto& quantity) {
      const auto found = shown.find(quantity.name);
      return found == shown.end() ? Shown{} : found->second;
    };
    const auto in_si = [&](const auto& quantity) {
      return units.si && how(quantity).in_si && quantity.dimension != Dimension::none;
    };
    for (const auto& each : quantities) {
      const Shown its = how(each);
      const int width = in_si(each) ? 0 : its.width;
      add(each, 1.0, {each.name, units.own_name(each.dimension), width, its.with_error, its.mark});
    }
    for (const auto& each : quantities) {
      if (!in_si(each)) continue;
      const std::string unit(unit_name(each.dimension, units.in_si));
      add(each, unit_in_si(each.dimension, *units.si), {each.name + "_si", unit, how(each).si_width});
    }
  }

  [[nodiscard]] const Columns& columns() const { return columns_; }

  [[nodiscard]] Row row(const Result& result) const {
    Row row;
    for (const auto& value : values_) row.push_back(value(result));
    return row;
  }

 private:
  void add(const Quantity<Result>& quantity, double scale, const Column& column) {
    columns_.push_back(column);
    values_.push_back([value = quantity.value, scale](const Result& result) -> Value {
      const Value its = value(result);
      const auto* number = std::get_if<double>(&its);
      return number != nullptr ? Value(*number * scale) : its;
    });
    if (!quantity.error) return;
    columns_.push_back({column.name + "_error", column.unit});
    values_.push_back([quantity, scale](const Result& result) {
      return error_of(std::get<double>(quantity.value(result)), quantity.error(result) * scale);
    });
  }

  Columns columns_;
  std::vector<std::function<Value(const Result&)>> values_;
};

/// A row as a JSON object, without units.
[[nodiscard]] nlohmann::ordered_json to_json(const Columns& columns, const Row& row);

/// The quantities of results as a JSON list of objects, without units.
template <typename Result>
nlohmann::ordered_json to_json(const Quantities<Result>& quantities, const std::vector<Result>& results) {
  const Fields<Result> fields(quantities);
  auto list = nlohmann::ordered_json::array();
  for (const Result& result : results) list.push_back(to_json(fields.columns(), fields.row(result)));
  return list;
}

/// What rows say of yielding: the speed at which it begins, and whether an impact is faster. Nothing where no yield
/// strength is given.
struct Yielding {
  Units units;                  ///< in SI
  std::optional<double> speed;  ///< m/s

  [[nodiscard]] Columns columns() const;

  /// @param impact speed of it, c of the first body
  [[nodiscard]] Row row(double impact) const;

  [[nodiscard]] bool is_below(double impact) const { return speed && impact * units.si->speed > *speed; }
};

[[nodiscard]] inline Yielding yielding(const Encounter& encounter) {
  return {units_of(encounter), yield_speed(encounter)};
}

/// Warns of what materials do that was not computed. @param fastest impact of all, c of the first body
void warn_of_materials(const OutputOptions& output, const Encounter& encounter, double fastest);

}  // namespace stoss::cli
