// What the core knows by name: kinds, inputs, laws and programs, units.
#include <map>
#include <string>

#include "stoss/encounter/inputs.hpp"
#include "stoss/encounter/kinds.hpp"
#include "stoss/encounter/programs.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

py::list all_kinds() {
  py::list all;
  for (const Kind& each : kinds()) {
    py::list numbers;
    for (const auto& [name, unit, otherwise, low, high, low_included, of_material, help] : each.parameters) {
      numbers.append(py::make_tuple(name, unit, otherwise, low, high, low_included, of_material));
    }
    all.append(
        py::make_tuple(each.name, each.wall, each.bounded, each.can_be_rigid, each.has_plane, each.from_file, numbers));
  }
  return all;
}

/// Names of the laws that are fitted.
py::list names_of_laws() {
  py::list all;
  for (const FittedLaw& law : fitted_laws()) all.append(law.name);
  return all;
}

/// Title, laws and trial of each program.
py::dict programs_of_laws() {
  py::dict all;
  for (const auto& [name, title, laws, writes, tried] : fitted_programs()) {
    all[py::str(name)] = py::make_tuple(title, py::tuple(py::cast(laws)), tried);
  }
  return all;
}

/// Each input of each question.
py::list all_inputs() {
  py::list all;
  for (const Input& each : inputs()) {
    for (const auto& [question, name] : questions()) {
      if (each.use(question) == nullptr) continue;
      all.append(py::make_tuple(name, each.name, each.low, each.high, each.low_included, each.high_included));
    }
  }
  return all;
}

/// Names of the units by dimension, of results of which such a body is the first.
std::map<std::string, std::string> units(const std::string& of, bool si) {
  std::map<std::string, std::string> names;
  using enum Dimension;
  const UnitSystem system = si ? kind(of).si : kind(of).own;
  for (const Dimension each : {none, length, inverse_length, time, speed, frequency, force, energy, momentum}) {
    names.emplace(dimension_name(each), unit_name(each, system));
  }
  return names;
}

}  // namespace

void bind_lists(py::module_& module) {
  def(module, "kinds", &all_kinds);
  def(module, "inputs", &all_inputs);
  def(module, "fitted_laws", &names_of_laws);
  def(module, "fitted_programs", &programs_of_laws);
  def(module, "units", {"kind", "si"}, &units);
}

}  // namespace stoss::python
