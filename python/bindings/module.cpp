#include <array>
#include <chrono>
#include <regex>
#include <string>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/encounter/seismogram.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/prediction/quantities.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/row/quantities.hpp"
#include "stoss/version.hpp"
#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/quantities.hpp"
#include "support.hpp"

namespace stoss::python {

Poll signal_poll() {
  const py::module_ threading = py::module_::import("threading");
  const py::object here = threading.attr("get_ident")(), main = threading.attr("main_thread")().attr("ident");
  if (!here.equal(main)) return {};
  return [last = std::chrono::steady_clock::now()]() mutable {
    constexpr auto patience = std::chrono::milliseconds(50);
    const auto now = std::chrono::steady_clock::now();
    if (now - last < patience) return;
    last = now;
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
}

namespace {

/// @param arguments of the exception of that name in stoss._errors
template <typename... Arguments>
void raise(const char* name, const Arguments&... arguments) {
  const py::object type = py::module_::import("stoss._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

/// The core's exceptions become those of stoss._errors.
void translate(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const InvalidInput& refusal) {
    constexpr std::array kinds{"out_of_range", "missing", "conflict"};
    const std::string hint =
        std::regex_replace(refusal.hint(), std::regex("--(?=[a-z])"), "");  // options of the command
    raise("InvalidInput", kinds[static_cast<std::size_t>(refusal.kind())], refusal.name(), refusal.got(),
          refusal.allowed(), hint);
  } catch (const NotConverged& failure) {
    raise("NotConverged", failure.what(), py::none(), failure.input(), failure.hint());
  }
}

/// Name, dimension, whether there is an error, the sentence and the type of the values of each.
template <typename Result>
py::tuple listed(const Quantities<Result>& quantities) {
  constexpr std::array<const char*, 4> types{"float", "int", "bool", "str"};  // in the order of Value
  py::list list;
  for (const auto& [name, dimension, help, value, error] : quantities) {
    list.append(py::make_tuple(name, dimension_name(dimension), static_cast<bool>(error), help,
                               types.at(value(Result{}).index())));
  }
  return py::tuple(list);
}

py::dict quantities() {
  py::dict all;
  all["impact"] = listed(impact_quantities());
  all["mode energy"] = listed(mode_energy_quantities());
  all["snapshot"] = listed(snapshot_quantities());
  all["restitution"] = listed(restitution_quantities());
  all["oblique impact"] = listed(oblique_impact_quantities());
  all["oblique snapshot"] = listed(oblique_snapshot_quantities());
  all["oblique ledger"] = listed(oblique_ledger_quantities());
  all["oblique"] = listed(oblique_quantities());
  all["prediction"] = listed(prediction_quantities());
  all["bounce"] = listed(bounce_quantities());
  all["pulse"] = listed(pulse_quantities());
  all["seismogram"] = listed(seismogram_quantities());
  all["recorded instant"] = listed(recorded_instant_quantities());
  all["row"] = listed(row_quantities());
  all["row body"] = listed(row_body_quantities());
  all["row contact"] = listed(row_contact_quantities());
  all["sample"] = listed(sample_quantities());
  all["mode"] = listed(bodies::disk::mode_quantities());
  all["sphere mode"] = listed(bodies::sphere::mode_quantities());
  all["slow impact"] = listed(quasistatic::slow_impact_quantities());
  all["rayleigh"] = listed(quasistatic::rayleigh_quantities());
  all["point slow impact"] = listed(quasistatic::point_slow_impact_quantities());
  all["point rayleigh"] = listed(quasistatic::point_rayleigh_quantities());
  all["driven mode"] = listed(quasistatic::driven_mode_quantities());
  return all;
}

}  // namespace
}  // namespace stoss::python

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ core of stoss. Use the package stoss, which checks, broadcasts and documents.";
  module.attr("version") = std::string(stoss::version());
  pybind11::register_exception_translator(&stoss::python::translate);
  module.attr("quantities") = stoss::python::quantities();
  stoss::python::bind_encounters(module);
  stoss::python::bind_lists(module);
  stoss::python::bind_impacts(module);
  stoss::python::bind_restitution(module);
  stoss::python::bind_oblique_impacts(module);
  stoss::python::bind_prediction(module);
  stoss::python::bind_tables(module);
  stoss::python::bind_pulse(module);
  stoss::python::bind_row(module);
  stoss::python::bind_rules(module);
  stoss::python::bind_quasistatic(module);
}
