#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stoss/encounter/visible.hpp"

namespace stoss::cli {

/// The word as a shell reads it back: bare, in '…' or, with control characters, in $'…'.
[[nodiscard]] std::string shell_quoted(std::string_view word);

/// The parts of `text` between separators, empty ones too.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// The text without spaces at its ends.
[[nodiscard]] std::string without_spaces(const std::string& text);

/// Writes one line on stderr. If stderr cannot be written, the line is lost and nothing else changes.
void say(std::string_view line) noexcept;

}  // namespace stoss::cli
