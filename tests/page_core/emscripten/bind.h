#pragma once

#include <map>
#include <string>

#include "val.h"

namespace emscripten {

using Answer = val (*)(const val& given, const val& deliver);

/// The questions that are answered, by name.
[[nodiscard]] inline std::map<std::string, Answer>& questions() {
  static std::map<std::string, Answer> all;
  return all;
}

inline void function(const char* name, Answer answer) { questions()[name] = answer; }

}  // namespace emscripten

#define EMSCRIPTEN_BINDINGS(name)                         \
  static void bind_##name();                              \
  static const bool bound_##name = (bind_##name(), true); \
  static void bind_##name()
