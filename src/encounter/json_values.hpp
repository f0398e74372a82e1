#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "stoss/errors.hpp"

/// Values of a JSON document, or a refusal of one line.
namespace stoss::json {

using Json = nlohmann::ordered_json;

[[noreturn]] inline void refuse(const std::string& where, const Json& got, const std::string& allowed) {
  constexpr std::size_t most = 60;
  std::string text = got.dump();
  if (text.size() > most) text = text.substr(0, most) + "...";
  throw InvalidInput(where + ": got " + text + ", allowed " + allowed);
}

inline double number(const std::string& where, const Json& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(where, value, "a finite number");
  return value.get<double>();
}

inline std::string word(const std::string& where, const Json& value, const std::string& allowed) {
  if (!value.is_string()) refuse(where, value, allowed);
  return value.get<std::string>();
}

inline const Json& object(const std::string& where, const Json& value) {
  if (!value.is_object()) refuse(where, value, "an object");
  return value;
}

}  // namespace stoss::json
