#include "javascript.hpp"

#include <emscripten.h>

#include <algorithm>

namespace stoss::web {

using emscripten::typed_memory_view;
using emscripten::val;

val object(std::initializer_list<std::pair<const char*, val>> members) {
  val made = val::object();
  for (const auto& [name, value] : members) made.set(name, value);
  return made;
}

val float64_array(const std::vector<double>& values) {
  return val::global("Float64Array").new_(typed_memory_view(values.size(), values.data()));
}

val float32_array(const std::vector<double>& values, double factor) {
  std::vector<float> rounded(values.size());
  std::transform(values.begin(), values.end(), rounded.begin(),
                 [factor](double value) { return static_cast<float>(factor * value); });
  return val::global("Float32Array").new_(typed_memory_view(rounded.size(), rounded.data()));
}

std::vector<double> numbers(const val& array) { return emscripten::convertJSArrayToNumberVector<double>(array); }

void say_alive() {
  constexpr double pause = 250.0;  // ms
  static double last = 0.0;
  const double now = emscripten_get_now();
  if (now - last < pause) return;
  last = now;
  if (const val alive = val::module_property("alive"); !alive.isUndefined()) alive();
}

}  // namespace stoss::web
