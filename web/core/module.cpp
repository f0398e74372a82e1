// What the worker calls. Answers are those of web/src/core/protocol.ts; each may be { error } instead.
#include <emscripten/bind.h>

#include <memory>
#include <string>

#include "collision.hpp"
#include "encounter.hpp"
#include "restitution.hpp"
#include "shape.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/version.hpp"
#include "values.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

constexpr double fewest_modes = 4.0;  // cutoff, c/R
constexpr double quick = 0.5;         // c

/// { encounter }, to be deleted after use.
val make_encounter(const std::string& document) {
  return answered([&] {
    val made = val::object();
    made.set("encounter", std::make_shared<Meeting>(document));
    return made;
  });
}

/// { units } of an encounter that is checked; nothing is kept.
val get_units(const std::string& document) {
  return answered([&] {
    const Meeting meeting(document);
    // The ratios of two bodies are checked where they meet; of the fewest modes that is soon done.
    if (meeting.second) (void)contact_of(meeting.encounter, fewest_modes, quick);
    val made = val::object();
    made.set("units", units(meeting));
    return made;
  });
}

/// { speed } in c of the first body.
val get_own_speed(const std::string& document, double speed) {
  return answered([&] {
    val made = val::object();
    made.set("speed", own_speed(encounter_from_json(document), speed));
    return made;
  });
}

/// { value } of one number, as the command reads it.
val get_number(const std::string& name, const std::string& text) {
  return answered([&] {
    val made = val::object();
    made.set("value", parse_number(name, text));
    return made;
  });
}

/// { values } of a number or a series, as the command reads it.
val get_series(const std::string& name, const std::string& text) {
  return answered([&] {
    val made = val::object();
    made.set("values", float64_array(parse_series(name, text)));
    return made;
  });
}

val get_restitution(const Meeting& meeting, double speed, double tolerance) {
  return answered([&] { return restitution(meeting, speed, tolerance); });
}

val get_curve(const Meeting& meeting, const val& speeds, double tolerance, const val& deliver) {
  return answered([&] {
    curve(meeting, numbers(speeds), tolerance, deliver);
    return val::object();
  });
}

val get_header(const Meeting& meeting, double slowest, double fastest, double error) {
  return answered([&] {
    val made = val::object();
    made.set("text", header(meeting, slowest, fastest, error));
    return made;
  });
}

/// { collision, series }, the first to be deleted after use.
val get_collision(const std::shared_ptr<Meeting>& meeting, double speed, double cutoff) {
  return answered([&] {
    auto collision = std::make_shared<Collision>(meeting, speed, cutoff);
    val made = val::object();
    made.set("series", collision->series());
    made.set("collision", std::move(collision));
    return made;
  });
}

Points points(const val& grid) { return {numbers(grid["radius"]), numbers(grid["angle"])}; }

bodies::half_space::PlaneGrid below(const val& grid) {
  const val given = grid["below"];
  if (given.isUndefined()) return {};
  return {numbers(given["distance"]), numbers(given["depth"])};
}

val get_frames(Collision& collision, const val& times, const val& grid, const val& deliver) {
  return answered([&] {
    collision.frames(numbers(times), points(grid), below(grid), deliver);
    return val::object();
  });
}

val get_shape(const Meeting& meeting, int body, int order, int index, const val& grid) {
  return answered([&] { return shape(meeting, body, order, index, points(grid)); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(stoss) {
  emscripten::class_<Meeting>("Encounter")
      .smart_ptr<std::shared_ptr<Meeting>>("EncounterPointer")
      .function("restitution", &get_restitution)
      .function("curve", &get_curve)
      .function("header", &get_header)
      .function("collision", &get_collision)
      .function("shape", &get_shape);
  emscripten::class_<Collision>("Collision")
      .smart_ptr<std::shared_ptr<Collision>>("CollisionPointer")
      .function("frames", &get_frames);
  emscripten::function("makeEncounter", &make_encounter);
  emscripten::function("units", &get_units);
  emscripten::function("ownSpeed", &get_own_speed);
  emscripten::function("number", &get_number);
  emscripten::function("series", &get_series);
  emscripten::function("tableOfKinds", &table_of_kinds);
}

}  // namespace stoss::web
