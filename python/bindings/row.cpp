// Rows of bodies: velocities after all contacts, and one motion in time.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rows.hpp"
#include "stoss/encounter/row.hpp"
#include "stoss/errors.hpp"
#include "stoss/row/curve.hpp"
#include "stoss/row/quantities.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

/// The speeds of each case, in c, that of what stands at the end of the row included.
std::vector<std::vector<double>> cases_of(const GivenRow& given, const Doubles& speeds) {
  const auto count = static_cast<std::size_t>(speeds.shape(0)), each = static_cast<std::size_t>(speeds.shape(1));
  std::vector<std::vector<double>> cases;
  for (std::size_t k = 0; k < count; ++k) {
    const double* const its = speeds.data() + k * each;
    cases.push_back(speeds_in_c(given, {its, its + each}));
  }
  return cases;
}

py::array contacts_of(const std::vector<RowContact>& contacts) {
  Rows<RowContact> rows(row_contact_quantities());
  for (const RowContact& each : contacts) rows.add(each);
  return rows.take();
}

/// The results of cases as they come, into arrays: `rows` for each case, `velocities` case after case for each body,
/// value and error, and a list of contacts for each.
void cases(const GivenRow& given, const Doubles& speeds, double tolerance, int threads, py::array& rows,
           Doubles& velocities, py::list contacts, py::list reasons, const std::optional<py::function>& tick) {
  const Row row = row_of(given);
  const std::vector<std::vector<double>> all = cases_of(given, speeds);
  const std::size_t bodies = given.bodies.size();
  if (velocities.size() != static_cast<py::ssize_t>(2 * bodies * all.size())) {
    throw std::invalid_argument("velocities: value and error for each body of each case");
  }
  const RowCurveOptions options{.each = {.tolerance = tolerance, .poll = signal_poll()}, .threads = threads};
  double* to = velocities.mutable_data();
  std::vector<std::vector<RowContact>> met;
  const auto hand_over = [&] {
    for (const std::vector<RowContact>& each : met) contacts.append(contacts_of(each));
  };
  try {
    fill(row_quantities(), rows, reasons, tick, [&](const auto& put) {
      row_curve(row, all, options, [&](std::size_t, const RowResult& result) {
        for (std::size_t b = 0; b < bodies; ++b) {
          *to++ = result.velocities_after[b].value;
          *to++ = result.velocities_after[b].error;
        }
        met.push_back(result.finest.contacts);
        put(result);
      });
    });
  } catch (const py::error_already_set&) {
    hand_over();
    throw;
  }
  hand_over();
}

/// What an observer has seen, instant after instant.
struct Watched {
  std::vector<double> time, displacement, velocity, force, energy;
};

constexpr double most_bytes = 2e9;

/// @param cutoff over the fastest time scale
py::dict watched(const GivenRow& given, const Doubles& speeds, double cutoff, double until, int every) {
  const std::vector<double> at = to_vector(speeds);
  const std::size_t bodies = given.bodies.size();
  Watched seen;
  const RowImpact result = computed([&](const Poll& poll) {
    const Row row = row_of(given);
    const std::vector<double> own = speeds_in_c(given, at);
    const double scale = fastest_time_scale(row, own, poll);
    RowWatch watch{.until = until, .every = every};
    watch.observer = [&](const RowSnapshot& now) {
      seen.time.push_back(now.time);
      const auto moving = static_cast<std::ptrdiff_t>(bodies);
      seen.displacement.insert(seen.displacement.end(), now.displacement.begin(), now.displacement.begin() + moving);
      seen.velocity.insert(seen.velocity.end(), now.velocity.begin(), now.velocity.begin() + moving);
      seen.force.insert(seen.force.end(), now.force.begin(), now.force.end());
      const RowEnergy& its = now.energy;
      seen.energy.insert(seen.energy.end(),
                         {its.translation, its.vibration, its.contact, its.unresolved, its.dissipated, its.yielded});
      const double each = 8.0 * static_cast<double>(7 + 2 * bodies + now.force.size());
      if (each * static_cast<double>(seen.time.size()) > most_bytes) {
        throw InvalidInput::out_of_range("every", std::to_string(every), "a larger one", "or an earlier `until`");
      }
    };
    return row_impact(row, own, cutoff / scale, poll, watch);
  });
  const auto times = static_cast<py::ssize_t>(seen.time.size());
  const auto across = [&](std::vector<double>& values, std::size_t count) {
    return take(std::move(values), {times, static_cast<py::ssize_t>(count)});
  };
  py::dict named;
  named["time"] = take(std::move(seen.time));
  named["displacement"] = across(seen.displacement, bodies);
  named["velocity"] = across(seen.velocity, bodies);
  named["force"] = across(seen.force, result.contacts.size());
  named["energy"] = across(seen.energy, 6);
  std::vector<double> after(result.velocities_after.begin(),
                            result.velocities_after.begin() + static_cast<std::ptrdiff_t>(bodies));
  named["velocities_after"] = take(std::move(after));
  named["contacts"] = contacts_of(result.contacts);
  named["cutoff"] = result.cutoff;
  named["step"] = result.step;
  named["steps"] = result.steps;
  named["energy_error"] = result.energy_error;
  named["momentum_error"] = result.momentum_error;
  named["strain"] = result.strain;
  return named;
}

}  // namespace

void bind_row(py::module_& module) {
  module.attr("row_row") = Rows<RowResult>(row_quantities()).type();
  module.attr("row_contact") = Rows<RowContact>(row_contact_quantities()).type();
  py::class_<GivenRow> handle(module, "GivenRow", "Bodies on a line, by their JSON document.");
  seal(handle);
  def(module, "given_row", {"document"}, [](const std::string& document) { return row_from_json(document); });
  def(handle, "to_json", [](const GivenRow& self) { return to_json(self); });
  def(handle, "speed_unit", [](const GivenRow& self) { return speed_unit(first_of(self)); });
  def(handle, "check", {"speeds", "tolerance"}, [](const GivenRow& self, const Doubles& speeds, double tolerance) {
    check(row_of(self), cases_of(self, speeds), {.each = {.tolerance = tolerance, .poll = signal_poll()}});
  });
  def(handle, "material_warnings", {"work"},
      [](const GivenRow& self, const Doubles& work) { return material_warnings(self, to_vector(work)); });
  def(handle, "curve", {"speeds", "tolerance", "threads", "rows", "velocities", "contacts", "reasons", "tick"}, &cases);
  def(handle, "motion", {"speeds", "cutoff", "until", "every"}, &watched);
}

}  // namespace stoss::python
