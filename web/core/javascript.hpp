#pragma once

#include <emscripten/val.h>

#include <initializer_list>
#include <utility>
#include <vector>

/// Values of JavaScript.
namespace stoss::web {

/// An object with these members.
[[nodiscard]] emscripten::val object(std::initializer_list<std::pair<const char*, emscripten::val>> members);

/// A copy as Float64Array.
[[nodiscard]] emscripten::val float64_array(const std::vector<double>& values);

/// A copy as Float32Array, each value times a factor.
[[nodiscard]] emscripten::val float32_array(const std::vector<double>& values, double factor = 1.0);

/// The numbers of an array or a typed array.
[[nodiscard]] std::vector<double> numbers(const emscripten::val& array);

/// Tells the worker, some four times a second, that a long computation goes on: calls Module.alive, where it is.
void say_alive();

}  // namespace stoss::web
