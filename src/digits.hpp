#pragma once

#include <string>

namespace stoss {

/// A number with ten digits, or as many as tell it from every other one.
[[nodiscard]] std::string shown(double value);

}  // namespace stoss
