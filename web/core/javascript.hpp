#pragma once

#include <emscripten.h>
#include <emscripten/val.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

/// Values of JavaScript.
namespace stoss::web {

/// A member of an object: a number, a flag, a text, or a value of JavaScript.
struct Member {
  template <typename Value>
  Member(std::string called, const Value& its) : name(std::move(called)), value(its) {}

  std::string name;
  emscripten::val value;
};

/// An object with these members.
[[nodiscard]] inline emscripten::val object(std::initializer_list<Member> members) {
  emscripten::val made = emscripten::val::object();
  for (const auto& [name, value] : members) made.set(name, value);
  return made;
}

/// An array of what some values become.
template <typename Values, typename Made>
[[nodiscard]] emscripten::val list(const Values& values, const Made& made) {
  emscripten::val all = emscripten::val::array();
  for (const auto& each : values) all.call<void>("push", made(each));
  return all;
}

/// A copy as Float64Array, or as Float32Array, each value times a factor.
[[nodiscard]] inline emscripten::val float64_array(std::vector<double> values, double factor = 1.0) {
  for (double& value : values) value *= factor;
  return emscripten::val::global("Float64Array").new_(emscripten::typed_memory_view(values.size(), values.data()));
}
[[nodiscard]] inline emscripten::val float32_array(const std::vector<double>& values, double factor = 1.0) {
  return emscripten::val::global("Float32Array").new_(float64_array(values, factor));
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
