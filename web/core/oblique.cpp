#include <cstdint>
#include <vector>

#include "results.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

double speed_of(const Question& asked, const Meeting& meeting) {
  return own_speed(meeting.encounter, asked.number("speed"));
}

/// At an angle; spins as the page gives them.
ObliqueCase at_angle(const Question& asked, const Meeting& meeting, double angle) {
  const double spin = meeting.unit(Dimension::frequency), speed = speed_of(asked, meeting);
  return {speed,
          {.tangential = tangential_at(angle, speed),
           .spin = asked.number("spin") / spin,
           .second_spin = asked.number("spin2") / spin,
           .friction = asked.number("friction")}};
}

ObliqueCase case_of(const Question& asked, const Meeting& meeting) {
  return at_angle(asked, meeting, asked.number("angle"));
}

ObliqueCurveOptions options(const Question& asked) {
  return {.each = {.tolerance = asked.number("tolerance"), .poll = say_alive}, .threads = 1};
}

/// Whether the motion is in range. @throws InvalidInput with the name of what is not
val motion(const Question& asked) {
  const auto meeting = asked.meeting();
  validate(meeting->contact, {case_of(asked, *meeting)}, {});
  return val::undefined();
}

/// The collision rule.
val oblique(const Question& asked) {
  const auto meeting = asked.meeting();
  const auto result = oblique_curve(meeting->contact, {case_of(asked, *meeting)}, options(asked)).front();
  val quantities = val::object();
  if (!result.runs.empty()) {
    add(quantities, *meeting, impact_quantities(), result.finest.normal);
    add(quantities, *meeting, oblique_ledger_quantities(), result.finest.energy);
  }
  add(quantities, *meeting, oblique_quantities(), result);
  return answer(*meeting, asked.number("speed"), quantities, result, result.finest.normal);
}

/// The rule at many angles, one by one.
val oblique_angles(const Question& asked) {
  const auto meeting = asked.meeting();
  const std::vector<double> angles = numbers(asked.given["angles"]);
  std::vector<ObliqueCase> cases;
  for (const double angle : angles) cases.push_back(at_angle(asked, *meeting, angle));
  oblique_curve(meeting->contact, cases, options(asked), [&](std::size_t i, const ObliqueRestitution& result) {
    asked.deliver(object({{"angle", val(angles[i])},
                          {"restitution", val(result.restitution.value)},
                          {"error", val(result.restitution.error)},
                          {"tangential", val(result.tangential_restitution.value)},
                          {"tangentialError", val(result.tangential_restitution.error)},
                          {"converged", val(result.converged)}}),
                  i);
  });
  return val::undefined();
}

/// A number of every instant.
struct Series {
  const char* name;
  double (*value)(const ObliqueSnapshot& now);
  Dimension dimension = Dimension::none;
};

constexpr Series all_series[] = {
    {"time", [](const ObliqueSnapshot& now) { return now.time; }, Dimension::time},
    {"velocity", [](const ObliqueSnapshot& now) { return now.velocity; }, Dimension::speed},
    {"tangential", [](const ObliqueSnapshot& now) { return now.tangential; }, Dimension::speed},
    {"force", [](const ObliqueSnapshot& now) { return now.force; }, Dimension::force},
    {"friction", [](const ObliqueSnapshot& now) { return now.friction; }, Dimension::force},
    {"center", [](const ObliqueSnapshot& now) { return now.center; }},
    {"shift", [](const ObliqueSnapshot& now) { return now.shift; }},
    {"angle", [](const ObliqueSnapshot& now) { return now.angle; }},
    {"angle2", [](const ObliqueSnapshot& now) { return now.second_angle; }},
    {"translation", [](const ObliqueSnapshot& now) { return now.energy.translation; }},
    {"across", [](const ObliqueSnapshot& now) { return now.energy.across; }},
    {"rotation", [](const ObliqueSnapshot& now) { return now.energy.rotation; }},
    {"rotation2", [](const ObliqueSnapshot& now) { return now.energy.second_rotation; }},
    {"elastic", [](const ObliqueSnapshot& now) { return now.energy.elastic; }},
    {"heat", [](const ObliqueSnapshot& now) { return now.energy.friction; }},
};

/// One impact in time.
val oblique_collision(const Question& asked) {
  const auto meeting = asked.meeting();
  const ObliqueCase its = case_of(asked, *meeting);
  std::vector<std::vector<double>> values(std::size(all_series));
  std::vector<double> places, grips;
  double begin = 0.0, end = 0.0;
  const auto observe = [&](const ObliqueSnapshot& now) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k].push_back(all_series[k].value(now));
    places.clear();
    for (const ObliquePoint& point : now.points) {
      places.push_back(point.place);
      grips.push_back(static_cast<double>(point.grip));
    }
    if (now.touching == 0) return;
    if (end == 0.0) begin = now.time;
    end = now.time;
  };
  const Contact contact = contact_of(meeting->encounter, asked.number("cutoff"), its.speed);
  (void)oblique_impact(contact, its.speed, its.before, {.poll = say_alive}, {.observer = observe});
  val units = val::object();
  val made = object({{"units", units},
                     {"begin", val(begin * meeting->unit(Dimension::time))},
                     {"end", val(end * meeting->unit(Dimension::time))},
                     {"places", float64_array(places)},
                     {"grips", val::global("Int8Array").new_(float64_array(grips))}});
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto& [name, value, dimension] = all_series[k];
    made.set(name, float64_array(values[k], meeting->unit(dimension)));
    units.set(name, meeting->unit_name(dimension));
  }
  return made;
}

}  // namespace

EMSCRIPTEN_BINDINGS(oblique) {
  emscripten::function("motion", &answered<motion>);
  emscripten::function("oblique", &answered<oblique>);
  emscripten::function("obliqueAngles", &answered<oblique_angles>);
  emscripten::function("obliqueCollision", &answered<oblique_collision>);
}

}  // namespace stoss::web
