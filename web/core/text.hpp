#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace stoss::web {

/// A number for a message.
inline std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return buffer.data();
}

}  // namespace stoss::web
