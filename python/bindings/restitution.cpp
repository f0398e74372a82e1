#include "stoss/restitution.hpp"

#include <limits>

#include "arrays.hpp"
#include "bindings.hpp"
#include "stoss/curve.hpp"

namespace stoss::python {
namespace {

/// What stoss.Restitution shows of one value.
struct RestitutionRow {
  double restitution, restitution_error, lost_fraction, lost_fraction_error, contact_time, contact_time_error,
      max_compression, max_compression_error, max_force, max_force_error, cutoff, energy_error;
  long modes, runs, steps;
  bool converged, beyond_small_strain;
};

RestitutionRow to_row(const Restitution& r) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const bool ran = !r.runs.empty();
  return {r.restitution.value,
          r.restitution.error,
          r.lost_fraction.value,
          r.lost_fraction.error,
          r.contact_time.value,
          r.contact_time.error,
          r.max_compression.value,
          r.max_compression.error,
          r.max_force.value,
          r.max_force.error,
          ran ? r.finest.cutoff : none,
          ran ? r.finest.energy_error : none,
          static_cast<long>(r.finest.energy.modes.size()),
          static_cast<long>(r.runs.size()),
          r.steps,
          r.converged,
          r.finest.beyond_small_strain};
}

/// Fills rows as the values come, so that what is done stays there if Ctrl-C or `observe` ends the curve.
void curve(const RefinableBody& body, const py::array_t<double, py::array::c_style>& speeds, double tolerance,
           int threads, py::array_t<RestitutionRow, py::array::c_style>& rows, const py::function& observe) {
  const std::vector<double> at = to_vector(speeds);
  if (rows.size() != speeds.size()) throw std::invalid_argument("rows: one for each speed");
  RestitutionRow* row = rows.mutable_data();
  const py::gil_scoped_release released;
  restitution_curve(body, at, {tolerance, threads, heed_signals}, [&](std::size_t i, const Restitution& result) {
    row[i] = to_row(result);
    const py::gil_scoped_acquire gil;
    observe(result.reason);
  });
}

}  // namespace

void bind_restitution(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RestitutionRow, restitution, restitution_error, lost_fraction, lost_fraction_error, contact_time,
                       contact_time_error, max_compression, max_compression_error, max_force, max_force_error, cutoff,
                       energy_error, modes, runs, steps, converged, beyond_small_strain);
  module.attr("restitution_row") = py::dtype::of<RestitutionRow>();
  module.def(
      "check_curve",
      [](const py::array_t<double, py::array::c_style>& speeds, double tolerance, int threads) {
        validate(to_vector(speeds), {tolerance, threads});
      },
      py::arg("speeds"), py::arg("tolerance"), py::arg("threads"));
  module.def("restitution_curve", &curve, py::arg("body"), py::arg("speeds"), py::arg("tolerance"), py::arg("threads"),
             py::arg("rows").noconvert(), py::arg("observe"), "fills rows; observe(reason) after each");
}

}  // namespace stoss::python
