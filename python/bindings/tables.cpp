// Restitution as a function, as a table of pairs, and by the two limits of the paper.
#include <array>
#include <tuple>

#include "stoss/encounter/laws.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/table/pair_table.hpp"
#include "stoss/table/restitution_function.hpp"
#include "stoss/table/slow_law.hpp"
#include "stoss/table/two_column.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

RestitutionFunction made_function(const Doubles& speed, const Doubles& value, const Doubles& error,
                                  const Doubles& interpolation, const std::string& beyond, const SlowLaw& law) {
  std::vector<Knot> knots;
  for (py::ssize_t k = 0; k < speed.size(); ++k) knots.push_back({speed.data()[k], {value.data()[k], error.data()[k]}});
  const Beyond chosen = beyond == "law" ? Beyond::law : beyond == "clamp" ? Beyond::clamp : Beyond::error;
  return RestitutionFunction(std::move(knots), chosen, law, to_vector(interpolation));
}

Beyond to_beyond(const std::string& beyond) { return beyond == "clamp" ? Beyond::clamp : Beyond::error; }

PairTable made_table(const Doubles& speed, const Doubles& ratio, const Doubles& value, const Doubles& error,
                     const Doubles& interpolation, bool alike, const std::string& beyond) {
  PairValues values{to_vector(speed), to_vector(ratio), {}, to_vector(interpolation), alike};
  for (py::ssize_t i = 0; i < value.size(); ++i) values.restitution.push_back({value.data()[i], error.data()[i]});
  return PairTable(std::move(values), to_beyond(beyond));
}

void bind_function(py::module_& module) {
  py::class_<RestitutionFunction> function(module, "RestitutionFunction", "Restitution against speed in c.");
  seal(function);
  function.def("value", &RestitutionFunction::value, py::arg("speed"))
      .def(
          "error", [](const RestitutionFunction& self, double speed) { return self(speed).error; }, py::arg("speed"))
      .def(
          "values",
          [](const RestitutionFunction& self, const Doubles& speeds) {
            return over([&](double at) { return self.value(at); }, speeds);
          },
          py::arg("speeds"))
      .def(
          "errors",
          [](const RestitutionFunction& self, const Doubles& speeds) {
            return over([&](double at) { return self(at).error; }, speeds);
          },
          py::arg("speeds"))
      .def("greatest_error", &RestitutionFunction::greatest_error)
      .def("knots",
           [](const RestitutionFunction& self) {
             std::vector<double> speed, value, error;
             for (const auto& [at, restitution] : self.knots()) {
               speed.push_back(at);
               value.push_back(restitution.value);
               error.push_back(restitution.error);
             }
             return std::tuple(take(std::move(speed)), take(std::move(value)), take(std::move(error)));
           })
      .def("interpolation_errors",
           [](const RestitutionFunction& self) {
             std::vector<double> copy = self.interpolation_errors();
             return take(std::move(copy));
           })
      .def(
          "c_header",
          [](const RestitutionFunction& self, const std::string& name, const std::string& unit, double scale,
             const std::vector<std::string>& provenance) {
            return c_header(self, {.name = name, .unit = unit, .scale = scale, .provenance = provenance});
          },
          py::arg("name"), py::arg("unit"), py::arg("scale"), py::arg("provenance"))
      .def("two_column", py::overload_cast<const RestitutionFunction&, double, double>(&two_column), py::arg("error"),
           py::arg("scale"));
  module.def("make_function", &made_function, py::arg("speed"), py::arg("restitution"), py::arg("restitution_error"),
             py::arg("interpolation_error"), py::arg("beyond"), py::arg("law"));
  module.def(
      "adaptive_function",
      [](const RefinableContact& contact, double slowest, double fastest, double error, int threads) {
        return computed([&](const Poll& poll) {
          return restitution_function(contact, slowest, fastest, {.error = error, .threads = threads, .poll = poll});
        });
      },
      py::arg("contact"), py::arg("slowest"), py::arg("fastest"), py::arg("error"), py::arg("threads"));
}

void bind_pair_table(py::module_& module) {
  py::class_<PairTable> table(module, "PairTable", "Restitution against speed in c and ratio of radii.");
  seal(table);
  table
      .def(
          "values",
          [](const PairTable& self, const Doubles& speeds, const Doubles& ratios) {
            return over([&](double v, double r) { return self.value(v, r); }, speeds, ratios);
          },
          py::arg("speeds"), py::arg("ratios"))
      .def(
          "errors",
          [](const PairTable& self, const Doubles& speeds, const Doubles& ratios) {
            return over([&](double v, double r) { return self(v, r).error; }, speeds, ratios);
          },
          py::arg("speeds"), py::arg("ratios"))
      .def("greatest_error", &PairTable::greatest_error)
      .def("given", [](const PairTable& self) {
        PairValues values = self.values();
        std::vector<double> value, error;
        for (const Estimate& each : values.restitution) {
          value.push_back(each.value);
          error.push_back(each.error);
        }
        return std::tuple(take(std::move(values.speeds)), take(std::move(values.ratios)), take(std::move(value)),
                          take(std::move(error)), take(std::move(values.interpolation_error)), values.alike);
      });
  module.def("make_pair_table", &made_table, py::arg("speed"), py::arg("ratio"), py::arg("restitution"),
             py::arg("restitution_error"), py::arg("interpolation_error"), py::arg("alike"), py::arg("beyond"));
  module.def(
      "adaptive_pair_table",
      [](const Encounter& encounter, const std::array<double, 2>& speed, const std::array<double, 2>& ratio,
         double error, int threads) {
        return computed([&](const Poll& poll) {
          const PairTableOptions options{.error = error, .threads = threads, .poll = poll};
          return pair_table(mixture(encounter), speed[0], speed[1], ratio[0], ratio[1], options);
        });
      },
      py::arg("encounter"), py::arg("speed"), py::arg("ratio"), py::arg("error"), py::arg("threads"));
}

}  // namespace

void bind_tables(py::module_& module) {
  bind_function(module);
  bind_pair_table(module);
  PYBIND11_NUMPY_DTYPE(Estimate, value, error);
}

}  // namespace stoss::python
