#include "stoss/restitution/restitution.hpp"

#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss::python {
namespace {

/// What stoss.Restitution shows of one value.
struct RestitutionRow {
  double restitution, restitution_error, lost_fraction, lost_fraction_error, contact_time, contact_time_error,
      max_compression, max_compression_error, max_force, max_force_error, lost_to_first, lost_to_second, cutoff,
      energy_error;
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
          ran ? r.finest.energy.lost_to_first : none,
          ran ? r.finest.energy.lost_to_second : none,
          ran ? r.finest.cutoff : none,
          ran ? r.finest.energy_error : none,
          static_cast<long>(r.finest.energy.modes.size()),
          static_cast<long>(r.runs.size()),
          r.steps,
          r.converged,
          r.finest.beyond_small_strain};
}

/// Fills rows as the values come, and `reasons` at the end, so that what is done is there if Ctrl-C ends the curve.
/// Only where there is a `tick` is the interpreter asked for after each value.
void curve(const RefinableContact& contact, const py::array_t<double, py::array::c_style>& speeds, double tolerance,
           int threads, py::array_t<RestitutionRow, py::array::c_style>& rows, py::list reasons,
           const std::optional<py::function>& tick) {
  const std::vector<double> at = to_vector(speeds);
  if (rows.size() != speeds.size()) throw std::invalid_argument("rows: one for each speed");
  RestitutionRow* row = rows.mutable_data();
  std::vector<std::string> why;
  const auto hand_over = [&] {
    for (const std::string& reason : why) reasons.append(reason);
  };
  const auto poll = signal_poll();
  try {
    const Released released;
    restitution_curve(contact, at, {tolerance, 0.0, threads, poll}, [&](std::size_t i, const Restitution& result) {
      row[i] = to_row(result);
      why.push_back(result.reason);
      if (!tick) return;
      const py::gil_scoped_acquire interpreter;
      (*tick)();
    });
  } catch (const py::error_already_set&) {
    hand_over();
    throw;
  }
  hand_over();
}

}  // namespace

void bind_restitution(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RestitutionRow, restitution, restitution_error, lost_fraction, lost_fraction_error, contact_time,
                       contact_time_error, max_compression, max_compression_error, max_force, max_force_error,
                       lost_to_first, lost_to_second, cutoff, energy_error, modes, runs, steps, converged,
                       beyond_small_strain);
  module.attr("restitution_row") = py::dtype::of<RestitutionRow>();
  module.def(
      "check_curve",
      [](const py::array_t<double, py::array::c_style>& speeds, double tolerance, int threads) {
        validate(to_vector(speeds), {tolerance, 0.0, threads});
      },
      py::arg("speeds"), py::arg("tolerance"), py::arg("threads"));
  module.def("restitution_curve", &curve, py::arg("contact"), py::arg("speeds"), py::arg("tolerance"),
             py::arg("threads"), py::arg("rows").noconvert(), py::arg("reasons"), py::arg("tick"),
             "fills rows and reasons; calls tick, unless it is None, after each");
}

}  // namespace stoss::python
