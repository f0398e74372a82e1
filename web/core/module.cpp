// What the worker calls. Answers are those of web/src/core/protocol.ts; each may be { error } instead.
#include <emscripten/bind.h>

#include <memory>
#include <string>

#include "collision.hpp"
#include "encounter.hpp"
#include "restitution.hpp"
#include "shape.hpp"
#include "stoss/version.hpp"
#include "values.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// { encounter }, to be deleted after use.
val make_encounter(const std::string& document) {
  return answered([&] {
    val made = val::object();
    made.set("encounter", std::make_shared<Meeting>(document));
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
      .function("units", &units)
      .function("restitution", &get_restitution)
      .function("curve", &get_curve)
      .function("header", &get_header)
      .function("collision", &get_collision)
      .function("shape", &get_shape);
  emscripten::class_<Collision>("Collision")
      .smart_ptr<std::shared_ptr<Collision>>("CollisionPointer")
      .function("frames", &get_frames);
  emscripten::function("makeEncounter", &make_encounter);
  emscripten::function("tableOfKinds", &table_of_kinds);
}

}  // namespace stoss::web
