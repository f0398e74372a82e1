#pragma once

#include <string_view>

namespace stoss::cli {

/// Writes one line on stderr. If stderr cannot be written, the line is lost and nothing else changes.
void say(std::string_view line) noexcept;

/// Writes on stderr as it is, without a line end, and as safely as `say`.
void show(std::string_view text) noexcept;

}  // namespace stoss::cli
