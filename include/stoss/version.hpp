#pragma once

#include <string_view>

#include "stoss/cxx20.hpp"

namespace stoss {

/// Version of the library, as in "2.0.0": that of what is linked, at run time.
///
/// Three numbers: the first changes with what users must change, the second with what is new, the third with what is
/// mended (docs/developer/versions.md). Files that stoss writes name it. The commit is known to the command (`stoss
/// --version`).
[[nodiscard]] std::string_view version();

}  // namespace stoss
