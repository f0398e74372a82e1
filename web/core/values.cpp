#include "values.hpp"

#include <algorithm>

namespace stoss::web {

using emscripten::typed_memory_view;
using emscripten::val;

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

}  // namespace stoss::web
