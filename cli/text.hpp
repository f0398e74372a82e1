#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stoss::cli {

/// The text on one line: control characters, and bytes that are no UTF-8, as \n or \x1b.
[[nodiscard]] std::string visible(std::string_view text);

/// The beginning of a text that is longer than `most` bytes, and how long it is; a shorter one as it is.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = 60);

/// The word as a shell reads it back: bare, in '…' or, with control characters, in $'…'.
[[nodiscard]] std::string shell_quoted(std::string_view word);

/// The parts of `text` between separators, empty ones too.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

}  // namespace stoss::cli
