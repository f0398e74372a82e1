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
val make_encounter(const val& given) {
  return answered([&] {
    val made = val::object();
    made.set("encounter", std::make_shared<Encounter>(given));
    return made;
  });
}

val get_restitution(const Encounter& encounter, double speed, double tolerance) {
  return answered([&] { return restitution(encounter, speed, tolerance); });
}

val get_curve(const Encounter& encounter, const val& speeds, double tolerance, const val& deliver) {
  return answered([&] {
    curve(encounter, numbers(speeds), tolerance, deliver);
    return val::object();
  });
}

val get_header(const Encounter& encounter, double slowest, double fastest, double error) {
  return answered([&] {
    val made = val::object();
    made.set("text", header(encounter, slowest, fastest, error));
    return made;
  });
}

/// { collision, series }, the first to be deleted after use.
val get_collision(const Encounter& encounter, double speed, double cutoff) {
  return answered([&] {
    auto collision = std::make_shared<Collision>(encounter, speed, cutoff);
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

val get_shape(const Encounter& encounter, int body, int order, int index, const val& grid) {
  return answered([&] { return shape(encounter, body, order, index, points(grid)); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(stoss) {
  emscripten::class_<Encounter>("Encounter")
      .smart_ptr<std::shared_ptr<Encounter>>("EncounterPointer")
      .function("restitution", &get_restitution)
      .function("curve", &get_curve)
      .function("header", &get_header)
      .function("collision", &get_collision)
      .function("shape", &get_shape);
  emscripten::class_<Collision>("Collision")
      .smart_ptr<std::shared_ptr<Collision>>("CollisionPointer")
      .function("frames", &get_frames);
  emscripten::function("makeEncounter", &make_encounter);
}

}  // namespace stoss::web
