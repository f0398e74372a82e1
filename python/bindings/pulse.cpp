// The pulse of force of an impact, and what a receiver records of it.
#include <string>
#include <vector>

#include "rows.hpp"
#include "stoss/encounter/seismogram.hpp"
#include "stoss/restitution/quantities.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

py::dict series_of(const Pulse& pulse) {
  py::dict named;
  named["time"] = take(std::vector(pulse.time));
  named["force"] = take(std::vector(pulse.force));
  named["force_error"] = take(std::vector(pulse.force_error));
  named["hertz"] = take(std::vector(pulse.hertz));
  named["frequency"] = take(std::vector(pulse.frequency));
  named["amplitude"] = take(std::vector(pulse.amplitude));
  named["amplitude_error"] = take(std::vector(pulse.amplitude_error));
  return named;
}

}  // namespace

void bind_pulse(py::module_& module) {
  module.attr("recorded_instant") = Rows<RecordedInstant>(recorded_instant_quantities()).type();
  py::class_<Pulse> handle(module, "Pulse", "The force of an impact in time.");
  seal(handle);
  def(module, "pulse", {"contact", "speed", "tolerance", "threshold", "points", "state"},
      [](const RefinableContact& contact, double speed, double tolerance, double threshold, int points,
         const Oscillations& state) {
        PulseOptions options{.tolerance = tolerance, .threshold = threshold, .points = points};
        options.vibration = to_vibration(state);
        return computed([&](const Poll& poll) {
          options.poll = poll;
          return pulse(contact, speed, options);
        });
      });
  def(handle, "numbers", [](const Pulse& self) { return to_dict(pulse_quantities(), self); });
  def(handle, "series", &series_of);
  def(handle, "reason", [](const Pulse& self) { return self.reason; });
  def(module, "seismogram", {"encounter", "pulse", "distance", "depth", "until", "points"},
      [](const Encounter& encounter, const Pulse& of, double distance, double depth, double until, int points) {
        const Seismogram made = computed([&](const Poll& poll) {
          return seismogram(encounter, of, {distance, depth}, {.until = until, .points = points, .poll = poll});
        });
        Rows<RecordedInstant> rows(recorded_instant_quantities());
        for (const RecordedInstant& each : made.instants) rows.add(each);
        return py::make_tuple(to_dict(seismogram_quantities(), made), rows.take());
      });
}

}  // namespace stoss::python
