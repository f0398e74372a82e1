#pragma once

#include <emscripten/val.h>

#include <exception>
#include <string>
#include <vector>

/// Values of JavaScript.
namespace stoss::web {

/// A copy as Float64Array.
[[nodiscard]] emscripten::val float64_array(const std::vector<double>& values);

/// A copy as Float32Array, each value times a factor.
[[nodiscard]] emscripten::val float32_array(const std::vector<double>& values, double factor = 1.0);

/// The numbers of an array or a typed array.
[[nodiscard]] std::vector<double> numbers(const emscripten::val& array);

/// What `answer` returns, or { error } with one line where it throws: no exception leaves for JavaScript, which cannot
/// read those of C++.
template <typename Answer>
emscripten::val answered(Answer answer) {
  std::string what;
  try {
    return answer();
  } catch (const std::bad_alloc&) {
    what = "memory: the computation needs more than there is (a greater tolerance needs less)";
  } catch (const std::exception& error) {
    what = error.what();
  }
  emscripten::val failure = emscripten::val::object();
  failure.set("error", what);
  return failure;
}

}  // namespace stoss::web
