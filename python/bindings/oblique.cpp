// Oblique impacts.
#include <cstdint>
#include <limits>
#include <optional>

#include "rows.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

constexpr py::ssize_t numbers_of_case = 5;  // of a case

/// Those of a rule and, as energy.translation and so on, of the ledger of its finest impact.
const Quantities<ObliqueRestitution>& quantities_of_row() {
  static const auto all = [] {
    auto list = oblique_quantities();
    for (const auto& each : oblique_ledger_quantities()) {
      list.emplace_back(
          "energy." + each.name, each.dimension, each.help, [get = each.value](const ObliqueRestitution& rule) {
            return rule.runs.empty() ? Value(std::numeric_limits<double>::quiet_NaN()) : get(rule.finest.energy);
          });
    }
    return list;
  }();
  return all;
}

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
  fill(quantities_of_row(), rows, reasons, tick, [&](const auto& put) {
    oblique_curve(contact, cases, options, [&](std::size_t, const ObliqueRestitution& result) { put(result); });
  });
}

/// One oblique impact and what it was made with: its films are repetitions.
struct MadeObliqueImpact {
  ObliqueImpact impact;
  double speed;
};

MadeObliqueImpact made_oblique(const Contact& contact, double speed, const Doubles& motion, std::optional<double> step,
                               std::optional<int> nodes, std::optional<double> half_width, const Oscillations& state) {
  if (motion.size() != numbers_of_case - 1) throw std::invalid_argument("motion: four numbers");
  const double* const at = motion.data();
  const Obliquity before{at[0], at[1], at[2], at[3]};
  ImpactOptions options{.resolution = {step, nodes, half_width, Tail::radiating}, .poll = signal_poll()};
  if (state.size() > 0) options.start = approach(contact, speed, to_vibration(state));
  const Released released;
  return {oblique_impact(contact, speed, before, options), speed};
}

/// The instants of a repetition, every so many steps.
struct ObliqueInstants {
  Rows<ObliqueSnapshot> rows{oblique_snapshot_quantities()};
  std::vector<double> x, y, second_x, second_y;
  std::vector<double> place, measure;            // of the points
  std::vector<double> pressure, friction, slip;  // instants x points
  std::vector<std::int8_t> grip;

  void add(const Contact& contact, const ObliqueSnapshot& now) {
    rows.add(now);
    const PlanePoint first = center(contact, now, 0);
    x.push_back(first.x);
    y.push_back(first.y);
    if (contact.second && !contact.unbounded) {
      const PlanePoint second = center(contact, now, 1);
      second_x.push_back(second.x);
      second_y.push_back(second.y);
    }
    const bool begins = place.empty();
    for (const ObliquePoint& point : now.points) {
      if (begins) {
        place.push_back(point.place);
        measure.push_back(point.measure);
      }
      pressure.push_back(point.pressure);
      friction.push_back(point.friction);
      slip.push_back(point.slip);
      grip.push_back(static_cast<std::int8_t>(point.grip));
    }
  }
};

py::tuple film(const MadeObliqueImpact& made, const Contact& contact, int every) {
  ObliqueInstants all = computed([&](const Poll& poll) {
    ObliqueInstants instants;
    const Impact& normal = made.impact.normal;
    const ImpactOptions options{.resolution = Resolution(normal.resolution), .start = normal.start, .poll = poll};
    const ObliqueImpactObserver observer = [&](const ObliqueSnapshot& now) { instants.add(contact, now); };
    (void)oblique_impact(contact, made.speed, made.impact.before, options, {observer, every});
    return instants;
  });
  const auto points = static_cast<py::ssize_t>(all.place.size()), times = static_cast<py::ssize_t>(all.x.size());
  const std::vector<py::ssize_t> shape{times, points};
  py::dict others;
  others["x"] = take(std::move(all.x));
  others["y"] = take(std::move(all.y));
  if (contact.second && !contact.unbounded) {
    others["second_x"] = take(std::move(all.second_x));
    others["second_y"] = take(std::move(all.second_y));
  }
  others["place"] = take(std::move(all.place));
  others["measure"] = take(std::move(all.measure));
  others["point_pressure"] = take(std::move(all.pressure), shape);
  others["point_friction"] = take(std::move(all.friction), shape);
  others["slip"] = take(std::move(all.slip), shape);
  others["grip"] = take(std::move(all.grip), shape);
  return py::make_tuple(all.rows.take(), others);
}

void bind_one(py::module_& module) {
  py::class_<MadeObliqueImpact> handle(module, "ObliqueImpact", "One oblique impact, which can be seen again.");
  seal(handle);
  def(handle, "numbers",
      [](const MadeObliqueImpact& made) { return to_dict(oblique_impact_quantities(), made.impact); });
  def(handle, "ledger",
      [](const MadeObliqueImpact& made) { return to_dict(oblique_ledger_quantities(), made.impact.energy); });
  def(handle, "trajectory", {"contact", "every"}, &film);
  def(module, "oblique_impact", {"contact", "speed", "motion", "step", "nodes", "half_width", "state"}, &made_oblique);
}

}  // namespace

void bind_oblique_impacts(py::module_& module) {
  module.attr("oblique_row") = Rows<ObliqueRestitution>(quantities_of_row()).type();
  bind_one(module);
  def(module, "check_oblique", {"contact", "cases", "tolerance", "threads", "state"}, &check);
  def(module, "oblique_curve", {"contact", "cases", "tolerance", "threads", "state", "rows", "reasons", "tick"},
      &compute);
}

}  // namespace stoss::python
