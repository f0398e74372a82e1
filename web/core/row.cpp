// Rows of bodies, as in a cradle: one collision of all, the next one of pendulums, and what is heard.
#include "stoss/row/row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "results.hpp"
#include "stoss/encounter/row.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/sound.hpp"
#include "stoss/row/quantities.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// A body by itself, with the units in which a RowState has its vibration, over those of the first body.
struct Ringing {
  Contact contact;  ///< it stands at a wall, which it never touches
  double time, speed, mass;
};

Ringing ringing(const Row& row, std::size_t body, double cutoff) {
  constexpr double few = 1e-3;  // c/R: without modes, for the units
  const auto scale = [&](std::size_t number) { return row.kinds[row.bodies[number]](few, {}).scale; };
  const auto own = scale(body), first = scale(0);
  const double its_time = (own.length / own.speed) / (first.length / first.speed);
  return {contact(row.kinds[row.bodies[body]](cutoff * its_time, say_alive)), its_time, own.speed / first.speed,
          own.mass / first.mass};
}

State state_of(const RowState& all, std::size_t body) {
  State its;
  its.coordinate = all.coordinate[body], its.momentum = all.momentum[body];
  return its;
}

/// Value of a unit of the first body in what the page is given: 1, or in SI.
double unit_of(const GivenRow& given, Dimension dimension) {
  const std::optional<Scales> si = si_scales(first_of(given));
  return si ? unit_in_si(dimension, *si) : 1.0;
}

/// One motion of a row, for what follows it.
struct Swing {
  GivenRow given;
  Row row;
  std::vector<double> speeds;  ///< c of the first body
  RowImpact its;
};

Swing swing(const Question& asked, double cutoff) {
  Swing made{.given = row_from_json(asked.text("document")), .row = {}, .speeds = {}, .its = {}};
  made.row = row_of(made.given);
  made.speeds = speeds_in_c(made.given, numbers(asked.given["speeds"]));
  made.its = row_impact(made.row, made.speeds, cutoff, say_alive);
  return made;
}

/// Collision of a row in the protocol. @param speeds before, c of the first body
val collision_of_row(const GivenRow& given, const std::vector<double>& speeds, const RowResult& result) {
  const Encounter first = first_of(given);
  const std::optional<Scales> si = si_scales(first);
  val all = val::object(), bodies = val::array(), contacts = val::array();
  add(all, first, si, row_quantities(), result);
  for (std::size_t b = 0; b < given.bodies.size(); ++b) {
    val its = val::object();
    add(its, first, si, row_body_quantities(),
        RowBody{.number = static_cast<int>(b), .velocity = speeds[b], .velocity_after = result.velocities_after[b]});
    bodies.call<void>("push", its);
  }
  for (const RowContact& each : result.finest.contacts) {
    val its = val::object();
    add(its, first, si, row_contact_quantities(), each);
    contacts.call<void>("push", its);
  }
  std::vector<double> work;
  for (const RowContact& each : result.finest.contacts) work.push_back(each.max_force * each.max_compression);
  return object(
      {{"quantities", all},
       {"bodies", bodies},
       {"contacts", contacts},
       {"converged", result.converged},
       {"reason", result.reason},
       {"cutoff", result.finest.cutoff},
       {"beyondSmallStrain", result.finest.strain > small_strain_limit},
       {"materialWarnings", list(material_warnings(given, work), [](const std::string& line) { return val(line); })}});
}

RowOptions options_of(const Question& asked) {
  return {.tolerance = asked.number("tolerance", RowOptions{}.tolerance), .poll = say_alive};
}

/// The velocities after all contacts, as `stoss row` gives them.
val row(const Question& asked) {
  const GivenRow given = row_from_json(asked.text("document"));
  const std::vector<double> speeds = numbers(asked.given["speeds"]);
  return collision_of_row(given, speeds_in_c(given, speeds), stoss::row(given, speeds, options_of(asked)));
}

/// All bodies as they come back: with their velocities reversed, and what is left of their vibration.
struct Return {
  std::vector<double> speeds;
  RowState start;
  double left = 0.0;  ///< energy of that vibration over that of the centres at first
};

Return returned(const Swing& before, double pause) {
  Return made;
  made.start = before.its.after;
  double vibration = 0.0, translation = 0.0;
  for (std::size_t b = 0; b < before.row.bodies.size(); ++b) {
    made.speeds.push_back(-before.its.velocities_after[b]);
    const Ringing own = ringing(before.row, b, before.its.cutoff);
    State its = state_of(before.its.after, b);
    if (pause > 0.0) its = free_motion(own.contact, its, pause / own.time);
    for (const double each : mode_energies(own.contact, its))
      vibration += each / own.contact.first->mass * own.mass * std::pow(own.speed, 2);
    translation += 0.5 * own.mass * std::pow(before.speeds[b], 2);
    made.start.coordinate[b] = its.coordinate, made.start.momentum[b] = its.momentum;
  }
  made.left = translation > 0.0 ? vibration / translation : 0.0;
  return made;
}

/// The collision of what begins with a vibration, with errors from a second motion at a lower cutoff.
RowResult again(const Swing& fine, const Return& back, const Question& asked, double pause) {
  constexpr double ratio = 1.4142135623730951;                   // half an octave, as between the motions of a row
  constexpr double safety = 4.0 / 2.0, of_greatest = 3.0 / 2.0;  // of a difference that falls with its square
  const Swing coarse = swing(asked, fine.its.cutoff / ratio);
  const Return lower = returned(coarse, pause);
  RowResult result;
  result.finest = row_impact(fine.row, back.speeds, fine.its.cutoff, say_alive, {.start = &back.start});
  const RowImpact other = row_impact(coarse.row, lower.speeds, coarse.its.cutoff, say_alive, {.start = &lower.start});
  result.cutoffs = {other.cutoff, result.finest.cutoff};
  result.steps = other.steps + result.finest.steps;
  std::vector<double> changes;
  for (std::size_t b = 0; b < back.speeds.size(); ++b) {
    changes.push_back(std::abs(result.finest.velocities_after[b] - other.velocities_after[b]));
  }
  const double least = of_greatest * *std::max_element(changes.begin(), changes.end());
  for (std::size_t b = 0; b < changes.size(); ++b) {
    result.velocities_after.push_back(
        {result.finest.velocities_after[b], std::max(least, safety * changes[b]) + result.finest.open[b]});
  }
  result.translation = {result.finest.energy.translation,
                        safety * std::abs(result.finest.energy.translation - other.energy.translation)};
  const double fastest = *std::max_element(fine.speeds.begin(), fine.speeds.end()) -
                         *std::min_element(fine.speeds.begin(), fine.speeds.end());
  const auto worst = std::max_element(result.velocities_after.begin(), result.velocities_after.end(),
                                      [](const Estimate& a, const Estimate& b) { return a.error < b.error; });
  result.converged = worst->error <= asked.number("tolerance", RowOptions{}.tolerance) * fastest;
  if (!result.converged) result.reason = "did not reach the tolerance";
  return result;
}

/// The next collision of pendulums of one length, which come back to the bottom at once after a pause, with what is
/// left of their vibration then. @throws InvalidInput for a row with a wall or a block
val row_again(const Question& asked) {
  constexpr double nothing = 1e-12;  // of the energy
  const Swing fine = swing(asked, asked.number("cutoff"));
  if (fine.given.wall_before || fine.given.after) {
    throw InvalidInput::conflict("after", "a wall or a block", "only bodies that hang come back at once");
  }
  const double pause = asked.number("pause") / unit_of(fine.given, Dimension::time);
  const Return back = returned(fine, pause);
  const RowResult result =
      back.left > nothing ? again(fine, back, asked, pause) : stoss::row(fine.row, back.speeds, options_of(asked));
  val made = collision_of_row(fine.given, back.speeds, result);
  made.set("left", back.left);
  return made;
}

/// The last motion that was heard.
Swing& heard(const Question& asked) {
  static std::tuple<std::string, std::vector<double>, double> last;
  static std::optional<Swing> its;
  const std::tuple which{asked.text("document"), numbers(asked.given["speeds"]), asked.number("cutoff")};
  if (!its || last != which) {
    its.reset();
    its = swing(asked, asked.number("cutoff"));
    last = which;
  }
  return *its;
}

/// The lowest frequency of the bodies of a row that vibrate after a collision, c/R of the first or rad/s.
val row_pitch(const Question& asked) {
  const Swing& now = heard(asked);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < now.row.bodies.size(); ++b) {
    const Ringing own = ringing(now.row, b, now.its.cutoff);
    for (const auto& group : own.contact.groups) {
      for (const double omega : group.omega) lowest = std::min(lowest, omega / own.time);
    }
  }
  return val(lowest * unit_of(now.given, Dimension::frequency));
}

/// What is heard of a body after the collision.
val row_sound(const Question& asked) {
  const Swing& now = heard(asked);
  const int body = asked.given["body"].as<int>();
  if (body < 0 || body >= static_cast<int>(now.given.bodies.size())) {
    throw InvalidInput::out_of_range("body", std::to_string(body),
                                     "0 to " + std::to_string(now.given.bodies.size() - 1));
  }
  const Ringing own = ringing(now.row, static_cast<std::size_t>(body), now.its.cutoff);
  SoundOptions options{.interval = asked.number("interval") / (own.time * unit_of(now.given, Dimension::time)),
                       .count = static_cast<std::size_t>(asked.number("count"))};
  const Body& its = *own.contact.first;
  if (its.loss_time == 0.0 && its.relaxation.terms.empty()) options.quality = asked.number("quality");
  Impact impact;
  impact.final_state = state_of(now.its.after, static_cast<std::size_t>(body));
  return float32_array(sound(own.contact, impact, options, say_alive), own.speed);
}

}  // namespace

EMSCRIPTEN_BINDINGS(row) {
  emscripten::function("row", &answered<row>);
  emscripten::function("rowAgain", &answered<row_again>);
  emscripten::function("rowPitch", &answered<row_pitch>);
  emscripten::function("rowSound", &answered<row_sound>);
}

}  // namespace stoss::web
