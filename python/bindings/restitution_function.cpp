#include "stoss/table/restitution_function.hpp"

#include <pybind11/stl.h>

#include <array>
#include <string>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "interpreter.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/table/slow_law.hpp"
#include "stoss/table/two_column.hpp"

namespace stoss::python {
namespace {

/// Who is to meet: kind (disk, rod, sphere, half-space, half-plane, or wall), numbers of a round body or of a block,
/// and whether it is rigid.
struct Who {
  std::string kind;
  std::array<double, 5> numbers{};  // poisson, radius, young, density, loss_time
  bool rigid = false;

  [[nodiscard]] Disk disk() const { return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]}; }
  [[nodiscard]] Sphere sphere() const { return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]}; }
  [[nodiscard]] HalfSpace half_space() const { return {numbers[0], numbers[2], numbers[3], numbers[4]}; }
};

using Words = std::tuple<std::string, std::array<double, 5>, bool>;

Who to_who(const Words& words) { return {std::get<0>(words), std::get<1>(words), std::get<2>(words)}; }

SlowLaw law_of(const Who& first, const Who& second) {
  const bool elastic = !first.rigid && !second.rigid;
  if (first.kind == "sphere" && second.kind == "halfspace") {
    return slow_law(first.sphere(), second.half_space(), first.rigid);
  }
  if (first.kind == "sphere" && second.kind == "wall" && elastic) return slow_law(first.sphere());
  if (first.kind == "disk" && second.kind == "wall" && elastic) return slow_law(first.disk());
  if (first.kind == "sphere" && second.kind == "sphere" && elastic) return slow_law(first.sphere(), second.sphere());
  if (first.kind == "disk" && second.kind == "disk" && elastic) return slow_law(first.disk(), second.disk());
  throw InvalidInput("beyond: got 'law', allowed 'error' or 'clamp' (there is no law of slow impacts of these bodies)");
}

RestitutionFunction made_function(const Doubles& speed, const Doubles& value, const Doubles& error,
                                  const Doubles& interpolation, const std::string& beyond, const SlowLaw& law) {
  std::vector<Knot> knots;
  for (py::ssize_t k = 0; k < speed.size(); ++k) knots.push_back({speed.data()[k], {value.data()[k], error.data()[k]}});
  const Beyond chosen = beyond == "law" ? Beyond::law : beyond == "clamp" ? Beyond::clamp : Beyond::error;
  return RestitutionFunction(std::move(knots), chosen, law, to_vector(interpolation));
}

}  // namespace

void bind_restitution_function(py::module_& module) {
  py::class_<SlowLaw> law(module, "SlowLaw", "What the restitution is below the range of a function.");
  py::class_<RestitutionFunction> function(module, "RestitutionFunction", "Restitution against speed in c.");
  seal(law);
  seal(function);
  function.def("value", &RestitutionFunction::value, py::arg("speed"))
      .def(
          "error", [](const RestitutionFunction& self, double speed) { return self(speed).error; }, py::arg("speed"))
      .def(
          "values",
          [](const RestitutionFunction& self, const Doubles& speeds) {
            return over([&, at = speeds.data()](std::size_t i) { return self.value(at[i]); }, speeds);
          },
          py::arg("speeds"))
      .def(
          "errors",
          [](const RestitutionFunction& self, const Doubles& speeds) {
            return over([&, at = speeds.data()](std::size_t i) { return self(at[i]).error; }, speeds);
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
      .def("two_column", &two_column, py::arg("error"), py::arg("scale"));
  module.def(
      "slow_law", [](const Words& first, const Words& second) { return law_of(to_who(first), to_who(second)); },
      py::arg("first"), py::arg("second"));
  module.def("no_law", [] { return SlowLaw(); });
  module.def("make_function", &made_function, py::arg("speed"), py::arg("restitution"), py::arg("restitution_error"),
             py::arg("interpolation_error"), py::arg("beyond"), py::arg("law"));
  module.def(
      "adaptive_function",
      [](const RefinableContact& contact, double slowest, double fastest, double error, int threads) {
        const FunctionOptions options{.error = error, .threads = threads, .poll = signal_poll()};
        const Released released;
        return restitution_function(contact, slowest, fastest, options);
      },
      py::arg("contact"), py::arg("slowest"), py::arg("fastest"), py::arg("error"), py::arg("threads"));
}

}  // namespace stoss::python
