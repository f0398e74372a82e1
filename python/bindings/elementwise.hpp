#pragma once

#include <pybind11/numpy.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "interpreter.hpp"
#include "stoss/poll.hpp"

namespace stoss::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style>;

/// An array of function(i), which is computed without the interpreter, for arrays of one size.
template <typename Function, typename... Arrays>
auto over(const Function& function, const Doubles& first, const Arrays&... others) {
  const auto size = static_cast<std::size_t>(first.size());
  if ((... || (others.size() != first.size()))) throw std::invalid_argument("arrays: all of one size");
  std::vector<decltype(function(size))> values(size);
  const Poll poll = signal_poll();
  {
    const Released released;
    for (std::size_t i = 0; i < size; ++i) {
      if (poll) poll();
      values[i] = function(i);
    }
  }
  return take(std::move(values));
}

/// The law of compression of a name, of lines or of points. @throws std::invalid_argument for another name
template <typename Law>
Law to_law(const std::string& name);

/// A function of law, Poisson's ratio and another number, over arrays of both.
template <typename Law>
auto over_law(double (*function)(Law, double, double)) {
  return [function](const std::string& law, const Doubles& poisson, const Doubles& argument) {
    const Law chosen = to_law<Law>(law);
    const double *nu = poisson.data(), *x = argument.data();
    return over([&](std::size_t i) { return function(chosen, nu[i], x[i]); }, poisson, argument);
  };
}

/// The same of law and Poisson's ratio alone.
template <typename Law>
auto over_law(double (*function)(Law, double)) {
  return [function](const std::string& law, const Doubles& poisson) {
    const Law chosen = to_law<Law>(law);
    const double* nu = poisson.data();
    return over([&](std::size_t i) { return function(chosen, nu[i]); }, poisson);
  };
}

}  // namespace stoss::python
