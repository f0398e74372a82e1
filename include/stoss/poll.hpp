#pragma once

#include <functional>

#include "stoss/cxx20.hpp"

namespace stoss {

/// A function that a long computation calls every few milliseconds, on its own thread; what it throws ends the
/// computation. Empty: none is called.
using Poll = std::function<void()>;

}  // namespace stoss
