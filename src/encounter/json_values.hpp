#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

/// Values of a JSON document, or a refusal of one line.
namespace stoss::json {

using Json = nlohmann::ordered_json;

[[noreturn]] inline void refuse(const std::string& where, const Json& got, const std::string& allowed) {
  throw InvalidInput::out_of_range(where, visible(shortened(got.dump())), allowed);
}

/// A document without a key that is twice in an object, where readers differ in which of both counts, and nested so
/// far only that what goes through it by recursion has room on any stack.
inline Json parsed(const std::string& where, std::string_view text) {
  constexpr int deepest = 32;
  std::vector<std::unordered_set<std::string>> keys;  // of the objects that are open
  const auto is_read = [&](int depth, Json::parse_event_t event, const Json& part) {
    if (depth > deepest) {
      throw InvalidInput::out_of_range(where, "values nested more than " + std::to_string(deepest) + " deep", "fewer");
    }
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(part.get<std::string>()).second) {
      throw InvalidInput::out_of_range(where, "the key " + visible(shortened(part.dump())) + " twice", "once");
    }
    return true;
  };
  try {
    return Json::parse(text, is_read);
  } catch (const Json::exception& error) {
    constexpr std::size_t most = 200;
    throw InvalidInput::conflict(where, "not a JSON document", visible(shortened(error.what(), most)));
  }
}

inline double number(const std::string& where, const Json& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(where, value, "a finite number");
  return value.get<double>();
}

inline std::string word(const std::string& where, const Json& value, const std::string& allowed) {
  if (!value.is_string()) refuse(where, value, allowed);
  return value.get<std::string>();
}

/// A text for headers and messages, where a further line would be another thing.
inline std::string line(const std::string& where, const Json& value, std::size_t most) {
  const std::string allowed = "one line of at most " + std::to_string(most) + " bytes";
  std::string text = word(where, value, allowed);
  if (text.size() > most || visible(text) != text) refuse(where, value, allowed);
  return text;
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
  if (!given.contains(name)) throw InvalidInput::missing(where + " " + name, "a number in SI");
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

/// Names of the documents, with their versions (docs/developer/versions.md).
namespace stoss::json {

inline constexpr const char* encounter_format = "stoss encounter 1";
inline constexpr const char* row_format = "stoss row 1";
inline constexpr const char* modal_body_format = "stoss modal body 1";

/// Refuses a document of another format than this one, and says so if it is of a later version.
inline void require_format(const std::string& where, const Json& given, const std::string& format) {
  if (given == format) return;
  const std::string name = format.substr(0, format.rfind(' ') + 1);
  const std::string text = given.is_string() ? given.get<std::string>() : std::string();
  std::string hint;
  if (text.starts_with(name)) {
    const std::string version = text.substr(name.size()), own = format.substr(name.size());
    const bool whole = version.find_first_not_of("0123456789") == std::string::npos && !version.starts_with('0');
    const bool later = version.size() > own.size() || (version.size() == own.size() && version > own);
    if (whole && later) hint = " (written by a later stoss)";
  }
  refuse(where, given, '"' + format + '"' + hint);
}

}  // namespace stoss::json
