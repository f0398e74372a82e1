#pragma once

#include <emscripten.h>
#include <emscripten/val.h>

#include <initializer_list>
#include <utility>
#include <vector>

/// Values of JavaScript.
namespace stoss::web {

/// An object with these members.
[[nodiscard]] inline emscripten::val object(std::initializer_list<std::pair<const char*, emscripten::val>> members) {
  emscripten::val made = emscripten::val::object();
  for (const auto& [name, value] : members) made.set(name, value);
  return made;
}

/// A copy as Float64Array.
[[nodiscard]] inline emscripten::val float64_array(const std::vector<double>& values) {
  return emscripten::val::global("Float64Array").new_(emscripten::typed_memory_view(values.size(), values.data()));
}

/// A copy as Float32Array, each value times a factor.
[[nodiscard]] inline emscripten::val float32_array(const std::vector<double>& values, double factor = 1.0) {
  std::vector<float> rounded;
  for (const double value : values) rounded.push_back(static_cast<float>(factor * value));
  return emscripten::val::global("Float32Array").new_(emscripten::typed_memory_view(rounded.size(), rounded.data()));
}

/// The numbers of an array or a typed array.
[[nodiscard]] inline std::vector<double> numbers(const emscripten::val& array) {
  return emscripten::convertJSArrayToNumberVector<double>(array);
}

/// Tells the worker, some four times a second, that a long computation goes on: calls Module.alive, where it is.
inline void say_alive() {
  constexpr double pause = 250.0;  // ms
  static double last = 0.0;
  const double now = emscripten_get_now();
  if (now - last < pause) return;
  last = now;
  if (const auto alive = emscripten::val::module_property("alive"); !alive.isUndefined()) alive();
}

}  // namespace stoss::web
