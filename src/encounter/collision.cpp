#include "stoss/encounter/collision.hpp"

#include <array>
#include <utility>

#include "encounter/json_values.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// The numbers that a collision has besides its angle.
constexpr std::array numbers{std::pair{"speed", &Collision::speed}, std::pair{"tangential", &Collision::tangential},
                             std::pair{"spin", &Collision::spin}, std::pair{"second_spin", &Collision::second_spin},
                             std::pair{"friction", &Collision::friction}};

}  // namespace

ObliqueCase own_units(const Encounter& encounter, const Collision& collision) {
  const auto scales = si_scales(encounter);
  const UnitSystem system = unit_system(encounter);
  const auto own = [&](const char* name, double value) {
    return in_own_units(input(Question::oblique, name), value, scales, system);
  };
  ObliqueCase made{own("speed", collision.speed),
                   {own("tangential", collision.tangential), own("spin", collision.spin),
                    own("second_spin", collision.second_spin), own("friction", collision.friction)}};
  if (!collision.angle) return made;
  if (collision.tangential != 0.0) {
    throw InvalidInput::conflict("angle", "cannot be combined with tangential", "give one of them");
  }
  made.before.tangential = tangential_at(*collision.angle, made.speed);
  return made;
}

Collision collision_from_json(std::string_view text) {
  const json::Json document = json::parsed("collision", text);
  std::vector<std::string> names{"angle"};
  for (const auto& [name, place] : numbers) names.emplace_back(name);
  json::require_keys("collision", document, names);
  if (!document.contains("speed")) throw InvalidInput::missing("collision speed", "a number");
  Collision collision;
  for (const auto& [name, place] : numbers) {
    if (document.contains(name)) collision.*place = json::number(name, document[name]);
  }
  if (document.contains("angle")) collision.angle = json::number("angle", document["angle"]);
  return collision;
}

std::string to_json(const Collision& collision) {
  json::Json document;
  for (const auto& [name, place] : numbers) {
    const double value = collision.*place;
    if (value != 0.0 || place == &Collision::speed) document[name] = value;
  }
  if (collision.angle) document["angle"] = *collision.angle;
  return document.dump();
}

}  // namespace stoss
