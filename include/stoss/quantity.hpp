#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "stoss/material.hpp"

/// What results hold, by name: each kind of result has one table of its quantities (such as
/// `stoss/impact/quantities.hpp`), from which the command and the Python package take names, units and order.
namespace stoss {

/// What a quantity is measured in; `none` for a pure number, a share of energy, a flag or a name.
enum class Dimension { none, length, inverse_length, time, speed, frequency, force, energy, acceleration, momentum };

/// Units of the first body, R and c of a disk or a sphere or L and c of a rod, and what they are in SI. Forces and
/// energies of a disk are per thickness.
enum class UnitSystem { disk, rod, disk_si, rod_si, sphere, sphere_si };

/// Name of a unit in plain ASCII, as in R/c, piRE, mc^2/R or N/m; "" for a pure number.
[[nodiscard]] std::string_view unit_name(Dimension dimension, UnitSystem system);

/// The word for a dimension, as in "inverse length"; "" for none.
[[nodiscard]] std::string_view dimension_name(Dimension dimension);

/// SI value of a unit of the first body; 1 for a pure number.
[[nodiscard]] double unit_in_si(Dimension dimension, const Scales& scales);

/// A value of a quantity.
using Value = std::variant<double, std::int64_t, bool, std::string>;

/// Whether something is a value with its error, as Estimate is.
template <typename T>
concept HasError = requires(const T& of) {
  { of.value } -> std::convertible_to<double>;
  { of.error } -> std::convertible_to<double>;
};

/// One quantity of a result: its name, its dimension, what it is, and how the result has it.
template <typename Result>
struct Quantity {
  /// @param said one sentence, up to 100 characters, without a full stop and without units
  /// @param get  a member of the result or a function of it. What it gives is a number, a flag or a name; or it has an
  ///             error, and then the quantity has one too.
  template <typename Get>
  requires std::invocable<Get, const Result&> Quantity(std::string called, Dimension measured_in, std::string said,
                                                       Get get)
      : name(std::move(called)), dimension(measured_in), help(std::move(said)) {
    if constexpr (HasError<std::invoke_result_t<Get, const Result&>>) {
      value = [get](const Result& result) -> Value { return std::invoke(get, result).value; };
      error = [get](const Result& result) -> double { return std::invoke(get, result).error; };
    } else {
      value = [get](const Result& result) -> Value { return std::invoke(get, result); };
    }
  }

  std::string name;
  Dimension dimension;
  std::string help;  ///< what it is, as faces show it beside its name
  std::function<Value(const Result&)> value;
  std::function<double(const Result&)> error;  ///< empty where there is none: the value is of one computation
};

/// The quantities of a kind of result, in the order in which they are shown.
template <typename Result>
using Quantities = std::vector<Quantity<Result>>;

}  // namespace stoss
