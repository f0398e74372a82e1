// Oblique impacts.
#include <optional>

#include "rows.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

constexpr py::ssize_t numbers_of_case = 5;  // of a case

/// @param array a row for each case: speed, tangential, spin, second spin, friction
std::vector<ObliqueCase> to_cases(const Doubles& array) {
  if (array.ndim() != 2 || array.shape(1) != numbers_of_case) throw std::invalid_argument("cases: five numbers each");
  std::vector<ObliqueCase> cases;
  for (const double* at = array.data(); at != array.data() + array.size(); at += numbers_of_case) {
    cases.push_back({at[0], {at[1], at[2], at[3], at[4]}});
  }
  return cases;
}

ObliqueCurveOptions options_of(double tolerance, int threads, const Oscillations& state) {
  return {.each = {.tolerance = tolerance, .poll = signal_poll(), .vibration = to_vibration(state)},
          .threads = threads};
}

void check(const RefinableContact& contact, const Doubles& array, double tolerance, int threads,
           const Oscillations& state) {
  const auto cases = to_cases(array);
  const auto options = options_of(tolerance, threads, state);
  const Released released;
  validate(contact, cases, options);
}

void compute(const RefinableContact& contact, const Doubles& array, double tolerance, int threads,
             const Oscillations& state, py::array& rows, py::list reasons, const std::optional<py::function>& tick) {
  const auto cases = to_cases(array);
  if (rows.size() != array.shape(0)) throw std::invalid_argument("rows: one oblique_row for each case");
  const auto options = options_of(tolerance, threads, state);
  fill(oblique_quantities(), rows, reasons, tick, [&](const auto& put) {
    oblique_curve(contact, cases, options, [&](std::size_t, const ObliqueRestitution& result) { put(result); });
  });
}

}  // namespace

void bind_oblique_impacts(py::module_& module) {
  module.attr("oblique_row") = Rows<ObliqueRestitution>(oblique_quantities()).type();
  module.def("check_oblique", &check, py::arg("contact"), py::arg("cases"), py::arg("tolerance"), py::arg("threads"),
             py::arg("state"));
  module.def("oblique_curve", &compute, py::arg("contact"), py::arg("cases"), py::arg("tolerance"), py::arg("threads"),
             py::arg("state"), py::arg("rows").noconvert(), py::arg("reasons"), py::arg("tick"),
             "fills rows and reasons; calls tick, unless it is None, after each");
  module.def(
      "tangential_at",
      [](const Doubles& angle, const Doubles& speed) {
        return over([&](std::size_t i) { return tangential_at(angle.data()[i], speed.data()[i]); }, angle, speed);
      },
      py::arg("angle"), py::arg("speed"), "degrees from the normal");
}

}  // namespace stoss::python
