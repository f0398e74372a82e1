#pragma once

#include <cstddef>
#include <string>

#include "encounter/json_values.hpp"

/// Names of the documents, with their versions (docs/versions.md).
namespace stoss::json {

inline constexpr const char* encounter_format = "stoss encounter 1";
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
