#pragma once

#include <optional>
#include <string>

namespace stoss::cli {

/// Locks the open file against other processes until it is closed or this process ends, however it ends.
/// @return the process that has locked it already, as words; nothing once it is locked, and where files cannot be
///         locked
[[nodiscard]] std::optional<std::string> lock(int descriptor);

}  // namespace stoss::cli
