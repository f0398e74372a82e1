#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

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

inline void require_keys(const std::string& where, const Json& given, const std::vector<std::string>& allowed) {
  for (const auto& [name, value] : object(where, given).items()) {
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
    std::string all;
    for (const std::string& each : allowed) all += (all.empty() ? "" : ", ") + each;
    refuse(where, name, all);
  }
}

inline double needed(const std::string& where, const Json& given, const std::string& name) {
  if (!given.contains(name)) throw InvalidInput(where + " " + name + ": got none, allowed a number in SI");
  return number(where + " " + name, given[name]);
}

inline std::vector<double> numbers(const std::string& where, const Json& value, std::optional<std::size_t> count) {
  if (!value.is_array() || (count && value.size() != *count)) {
    refuse(where, value, count ? "a list of " + std::to_string(*count) + " numbers" : "a list of numbers");
  }
  std::vector<double> all;
  for (const Json& each : value) all.push_back(number(where, each));
  return all;
}

}  // namespace stoss::json
