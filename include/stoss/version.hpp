#pragma once

#include <string_view>

#include "stoss/cxx20.hpp"

namespace stoss {

/// Version of the linked library at run time, as in "2.0.0".
///
/// The first of its three numbers rises if users must change something, the second with new features, the third with
/// fixes (docs/developer/versions.md). Files that stoss writes name it. The commit is known to the command (`stoss
/// --version`).
[[nodiscard]] std::string_view version();

}  // namespace stoss
