#pragma once

#include <string_view>

#include "stoss/cxx20.hpp"

namespace stoss {

/// Version of the library, as in "0.1.0".
[[nodiscard]] std::string_view version();

}  // namespace stoss
