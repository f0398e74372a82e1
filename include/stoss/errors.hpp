#pragma once

#include <stdexcept>

#include "stoss/cxx20.hpp"

namespace stoss {

/// An argument outside its range. what() is one line: name, what was got, what is allowed, a hint.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A computation that could not meet its own conditions. what() is one line: what failed and what may help.
class NotConverged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stoss
