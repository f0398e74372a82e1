// Restitution as a function, as a table of pairs, and by the two limits of the paper.
#include <array>
#include <tuple>

#include "stoss/encounter/laws.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "stoss/table/pair_table.hpp"
#include "stoss/table/slow_law.hpp"
#include "stoss/table/two_column.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

RestitutionFunction made_function(const Doubles& speed, const Doubles& value, const Doubles& error,
                                  const Doubles& interpolation, const std::string& beyond, const SlowLaw& law) {
  return RestitutionFunction({.speeds = to_vector(speed),
                              .values = to_estimates(value, error),
                              .interpolation_error = to_vector(interpolation)},
                             to_beyond(beyond), law);
}

PairTable made_table(const Doubles& speed, const Doubles& ratio, const Doubles& value, const Doubles& error,
                     const Doubles& interpolation, bool alike, const std::string& beyond) {
  return PairTable(
      {to_vector(speed), {0.0}, to_vector(ratio), to_estimates(value, error), to_vector(interpolation), alike},
      to_beyond(beyond));
}

auto knots(const RestitutionFunction& function) {
  const auto& [speeds, slips, ratios, values, interpolation, alike] = function.values();
  return std::tuple_cat(std::tuple(take(std::vector(speeds))),
                        to_arrays(values, {static_cast<py::ssize_t>(speeds.size())}));
}

void bind_function(py::module_& module) {
  py::class_<RestitutionFunction> function(module, "RestitutionFunction", "Restitution against speed in c.");
  seal(function);
  bind_values(function, "speeds");
  bind_code(function);
  def(function, "knots", &knots);
  def(function, "interpolation_errors",
      [](const RestitutionFunction& self) { return take(std::vector(self.values().interpolation_error)); });
  def(function, "two_column", {"error", "scale"},
      py::overload_cast<const RestitutionFunction&, double, double>(&two_column));
  def(module, "make_function", {"speed", "restitution", "restitution_error", "interpolation_error", "beyond", "law"},
      &made_function);
  const auto adaptive = [](const RefinableContact& contact, double slowest, double fastest, double error, int threads) {
    return computed([&](const Poll& poll) {
      return restitution_function(contact, slowest, fastest, {.error = error, .threads = threads, .poll = poll});
    });
  };
  def(module, "adaptive_function", {"contact", "slowest", "fastest", "error", "threads"}, adaptive);
}

auto given(const PairTable& table) {
  TableValues values = table.values();
  const auto [value, error] = to_arrays(values.values, {static_cast<py::ssize_t>(values.values.size())});
  return std::tuple(take(std::move(values.speeds)), take(std::move(values.ratios)), value, error,
                    take(std::move(values.interpolation_error)), values.alike);
}

void bind_pair_table(py::module_& module) {
  py::class_<PairTable> table(module, "PairTable", "Restitution against speed in c and ratio of radii.");
  seal(table);
  bind_values(table, "speeds", "ratios");
  def(table, "given", &given);
  def(module, "make_pair_table",
      {"speed", "ratio", "restitution", "restitution_error", "interpolation_error", "alike", "beyond"}, &made_table);
  const auto adaptive = [](const Encounter& encounter, const std::array<double, 2>& speed,
                           const std::array<double, 2>& ratio, double error, int threads) {
    return computed([&](const Poll& poll) {
      const PairTableOptions options{.error = error, .threads = threads, .poll = poll};
      return pair_table(mixture(encounter), speed[0], speed[1], ratio[0], ratio[1], options);
    });
  };
  def(module, "adaptive_pair_table", {"encounter", "speed", "ratio", "error", "threads"}, adaptive);
}

}  // namespace

void bind_tables(py::module_& module) {
  bind_function(module);
  bind_pair_table(module);
  PYBIND11_NUMPY_DTYPE(Estimate, value, error);
}

}  // namespace stoss::python
