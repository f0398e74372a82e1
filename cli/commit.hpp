#pragma once

#include <string_view>

namespace stoss::cli {

/// The commit that the command was built from, as in "1234567", or "1234567, changed" where tracked files differ from
/// it; "" where none is known.
[[nodiscard]] std::string_view commit();

}  // namespace stoss::cli
