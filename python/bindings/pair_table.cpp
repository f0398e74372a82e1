#include "stoss/table/pair_table.hpp"

#include <pybind11/stl.h>

#include <array>
#include <string>
#include <tuple>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "interpreter.hpp"
#include "stoss/table/adaptive_pairs.hpp"

namespace stoss::python {
namespace {

using Round = std::array<double, 5>;  // poisson, radius, young, density, loss_time

Beyond to_beyond(const std::string& beyond) { return beyond == "clamp" ? Beyond::clamp : Beyond::error; }

Mixture mixture_of(const std::string& kind, const Round& a, const Round& b) {
  if (kind == "sphere") return mixture(Sphere{a[0], a[1], a[2], a[3], a[4]}, Sphere{b[0], b[1], b[2], b[3], b[4]});
  return mixture(Disk{a[0], a[1], a[2], a[3], a[4]}, Disk{b[0], b[1], b[2], b[3], b[4]});
}

PairTable made_table(const Doubles& speed, const Doubles& ratio, const Doubles& value, const Doubles& error,
                     const Doubles& interpolation, bool alike, const std::string& beyond) {
  PairValues values{to_vector(speed), to_vector(ratio), {}, to_vector(interpolation), alike};
  for (py::ssize_t i = 0; i < value.size(); ++i) values.restitution.push_back({value.data()[i], error.data()[i]});
  return PairTable(std::move(values), to_beyond(beyond));
}

}  // namespace

void bind_pair_table(py::module_& module) {
  py::class_<PairTable> table(module, "PairTable", "Restitution against speed in c and ratio of radii.");
  seal(table);
  table
      .def(
          "values",
          [](const PairTable& self, const Doubles& speeds, const Doubles& ratios) {
            const double *v = speeds.data(), *r = ratios.data();
            return over([&](std::size_t i) { return self.value(v[i], r[i]); }, speeds, ratios);
          },
          py::arg("speeds"), py::arg("ratios"))
      .def(
          "errors",
          [](const PairTable& self, const Doubles& speeds, const Doubles& ratios) {
            const double *v = speeds.data(), *r = ratios.data();
            return over([&](std::size_t i) { return self(v[i], r[i]).error; }, speeds, ratios);
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
      [](const std::string& kind, const Round& first, const Round& second, const std::array<double, 2>& speed,
         const std::array<double, 2>& ratio, double error, int threads) {
        const PairTableOptions options{.error = error, .threads = threads, .poll = signal_poll()};
        const Released released;
        return pair_table(mixture_of(kind, first, second), speed[0], speed[1], ratio[0], ratio[1], options);
      },
      py::arg("kind"), py::arg("first"), py::arg("second"), py::arg("speed"), py::arg("ratio"), py::arg("error"),
      py::arg("threads"));
}

}  // namespace stoss::python
