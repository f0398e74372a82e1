#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/quantities.hpp"

#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "bindings.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "vibration.hpp"

namespace stoss::python {
namespace {

/// Adds the rows of a sequence to `done` at its end, also if Ctrl-C ends it. Returns why it ended too early.
std::string sequence(const Contact& contact, bool radiating, double speed, long count,
                     std::optional<double> flight_time, std::optional<double> gravity, std::optional<double> decay_time,
                     const Oscillations& state, py::list done) {
  const Tail tail = radiating ? Tail::radiating : Tail::quasistatic;
  const BounceOptions options{.count = count,
                              .flight_time = flight_time,
                              .gravity = gravity,
                              .decay_time = decay_time,
                              .resolution = {.tail = tail},
                              .vibration = to_vibration(state),
                              .poll = signal_poll()};
  Rows<Bounce> rows(bounce_quantities());
  try {
    const Released released;
    bounce(contact, speed, options, [&](const Bounce& bounce, const Impact&) { rows.add(bounce); });
  } catch (const NotConverged& error) {
    done.append(rows.take());
    return error.what();
  } catch (const py::error_already_set&) {
    done.append(rows.take());
    throw;
  }
  done.append(rows.take());
  return {};
}

}  // namespace

void bind_bounce(py::module_& module) {
  module.def("slowest_bounce", &slowest_bounce, py::arg("speed"));
  module.def("bounce", &sequence, py::arg("contact"), py::arg("radiating"), py::arg("speed"), py::arg("count"),
             py::arg("flight_time"), py::arg("gravity"), py::arg("decay_time"), py::arg("state"), py::arg("done"),
             "appends the rows to done; returns why the sequence ended too early");
}

}  // namespace stoss::python
