#include "shape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <variant>

#include "stoss/errors.hpp"
#include "values.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// Number of a mode among those that a body keeps.
std::optional<std::size_t> number_of(const Body& body, int order, int index) {
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const int its_index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      if (group.order == order && its_index == index) return k;
    }
  }
  return std::nullopt;
}

}  // namespace

val shape(const Meeting& meeting, int body, int order, int index, const Points& points) {
  constexpr double lowest = 8.0, highest = 400.0;
  if (body == 1 && !meeting.second) throw InvalidInput("body: got the second, allowed the first");
  const Solid& solid = meeting.solid(body);
  const BodyMaker make = maker(solid);
  BodyFrame alone;
  std::optional<std::size_t> number;
  for (double cutoff = lowest; cutoff < highest && !number; cutoff *= 2.0) {
    alone.body = std::make_shared<const Body>(make(cutoff, {}));
    number = number_of(*alone.body, order, index);
  }
  if (!number) throw InvalidInput("mode: got one above all that are computed at once");
  // No force, so that nothing but the mode moves.
  alone.points = {.radius = 1.0, .spacing = std::holds_alternative<Rod>(solid) ? 0.0 : 0.1, .count = 1};
  alone.coordinate.assign(mode_count(*alone.body), 0.0);
  alone.coordinate[*number] = 1.0;
  alone.node_force = {0.0};
  const Interior still = inside(solid, alone, points)(alone);
  double greatest = 0.0;
  for (std::size_t i = 0; i < still.radial.size(); ++i) {
    greatest = std::max(greatest, std::hypot(still.radial[i], still.tangential[i]));
  }
  val made = val::object();
  made.set("radial", float32_array(still.radial, 1.0 / greatest));
  made.set("tangential", float32_array(still.tangential, 1.0 / greatest));
  return made;
}

}  // namespace stoss::web
