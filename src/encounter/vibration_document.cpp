#include "encounter/vibration_document.hpp"

#include <cmath>
#include <limits>

namespace stoss::json {
namespace {

int whole(const std::string& where, const Json& value) {
  constexpr double most = std::numeric_limits<int>::max();
  if (!value.is_number_integer() || std::abs(value.get<double>()) > most) refuse(where, value, "a whole number");
  return value.get<int>();
}

Oscillation oscillation(const std::string& where, const Json& given) {
  Oscillation mode;
  for (const char* needed : {"order", "index", "energy"}) {
    if (!object(where, given).contains(needed)) refuse(where, given, "an object with order, index and energy");
  }
  for (const auto& [name, value] : given.items()) {
    const std::string place = where + " " + name;
    if (name == "order") {
      mode.order = whole(place, value);
    } else if (name == "index") {
      mode.index = whole(place, value);
    } else if (name == "energy") {
      mode.energy = number(place, value);
    } else if (name == "phase") {
      mode.phase = number(place, value);
    } else if (name == "body" && (value == "first" || value == "second")) {
      mode.body = value == "first" ? 0 : 1;
    } else if (name == "body") {
      refuse(place, value, "\"first\" or \"second\"");
    } else {
      refuse(where, name, "body, order, index, energy, phase");
    }
  }
  return mode;
}

}  // namespace

Vibration vibration(const std::string& where, const Json& given) {
  if (!given.is_array()) refuse(where, given, "a list of modes");
  Vibration made;
  for (const Json& each : given) made.push_back(oscillation(where, each));
  return made;
}

Json document_of(const Vibration& vibration) {
  Json modes = Json::array();
  for (const Oscillation& mode : vibration) {
    modes.push_back({{"body", mode.body == 0 ? "first" : "second"},
                     {"order", mode.order},
                     {"index", mode.index},
                     {"energy", mode.energy},
                     {"phase", mode.phase}});
  }
  return modes;
}

}  // namespace stoss::json
