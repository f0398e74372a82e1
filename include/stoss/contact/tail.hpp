#pragma once

#include "stoss/cxx20.hpp"

namespace stoss {

/// How the modes above the cutoff answer a hard contact (docs/theory/walls.md): part of how an impact is resolved.
enum class Tail {
  quasistatic,  ///< exact static compliance; stores energy, loses none ("static" on the command line)
  radiating     ///< static compliance at low and plane-wave impedance at high frequency; absorbs energy
};

}  // namespace stoss
