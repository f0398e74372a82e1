#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "motion.hpp"
#include "results.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

ObliqueCurveOptions oblique_options(const Question& asked) {
  return {.each = {.tolerance = asked.number("tolerance", ObliqueOptions{}.tolerance), .poll = say_alive},
          .threads = 1};
}

/// The collision rule.
val oblique(const Question& asked) {
  const auto meeting = asked.meeting();
  const auto result = oblique_curve(meeting->contact, {case_of(asked, *meeting)}, oblique_options(asked)).front();
  val quantities = val::object();
  if (!result.runs.empty()) {
    add(quantities, *meeting, impact_quantities(), result.finest.normal);
    add(quantities, *meeting, oblique_ledger_quantities(), result.finest.energy);
  }
  add(quantities, *meeting, oblique_quantities(), result);
  val made = answer(*meeting, asked.number("speed"), quantities, result, result.finest.normal);
  made.set("beyondSmallTurn", result.finest.beyond_small_turn);
  return made;
}

/// The rule at many angles, one by one.
val oblique_angles(const Question& asked) {
  const auto meeting = asked.meeting();
  const std::vector<double> angles = numbers(asked.given["angles"]);
  std::vector<ObliqueCase> cases;
  for (const double angle : angles) cases.push_back(at_angle(asked, *meeting, angle));
  oblique_curve(meeting->contact, cases, oblique_options(asked), [&](std::size_t i, const ObliqueRestitution& result) {
    asked.deliver(object({{"angle", angles[i]},
                          {"restitution", result.restitution.value},
                          {"error", result.restitution.error},
                          {"tangential", result.tangential_restitution.value},
                          {"tangentialError", result.tangential_restitution.error},
                          {"converged", result.converged}}),
                  i);
  });
  return val::undefined();
}

/// One impact in time.
val oblique_collision(const Question& asked) {
  const auto meeting = asked.meeting();
  const ObliqueCase its = case_of(asked, *meeting);
  const Contact contact = contact_of(meeting->encounter, asked.number("cutoff"), its.speed);
  std::map<std::string, std::vector<double>> series;
  std::array<std::array<std::vector<double>, 2>, 2> centers;  // x and y of each body
  const std::size_t bodies = meeting->second && !meeting->against_unbounded() ? 2 : 1;
  std::vector<double> places, grips;
  double begin = -1.0, end = 0.0;
  const auto observe = [&](const ObliqueSnapshot& now) {
    for (const auto& each : oblique_snapshot_quantities()) {
      const Value value = each.value(now);
      if (const auto* number = std::get_if<double>(&value)) series[each.name].push_back(*number);
    }
    for (std::size_t n = 0; n < bodies; ++n) {
      const PlanePoint place = center(contact, now, static_cast<int>(n));
      centers[n][0].push_back(place.x);
      centers[n][1].push_back(place.y);
    }
    places.clear();
    for (const ObliquePoint& point : now.points) {
      places.push_back(point.place);
      grips.push_back(static_cast<double>(point.grip));
    }
    if (now.touching == 0) return;
    if (begin < 0.0) begin = now.time;
    end = now.time;
  };
  (void)oblique_impact(contact, its.speed, its.before, {.poll = say_alive}, {.observer = observe});
  val units = val::object(), ways = val::array();
  for (std::size_t n = 0; n < bodies; ++n) {
    const auto& [x, y] = centers[n];
    ways.call<void>("push", object({{"x", float64_array(x)},
                                    {"y", float64_array(y)},
                                    {"angle", float64_array(series[n == 0 ? "angle" : "second_angle"])}}));
  }
  val made = object({{"units", units},
                     {"begin", val(std::max(begin, 0.0) * meeting->unit(Dimension::time))},
                     {"end", val(end * meeting->unit(Dimension::time))},
                     {"bodies", ways},
                     {"places", float64_array(places)},
                     {"grips", val::global("Int8Array").new_(float64_array(grips))}});
  for (const auto& each : oblique_snapshot_quantities()) {
    made.set(each.name, float64_array(series[each.name], meeting->unit(each.dimension)));
    units.set(each.name, meeting->unit_name(each.dimension));
  }
  return made;
}

}  // namespace

EMSCRIPTEN_BINDINGS(oblique) {
  emscripten::function("oblique", &answered<oblique>);
  emscripten::function("obliqueAngles", &answered<oblique_angles>);
  emscripten::function("obliqueCollision", &answered<oblique_collision>);
}

}  // namespace stoss::web
