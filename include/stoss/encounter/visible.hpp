#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "stoss/cxx20.hpp"

/// Text of others in messages of one line: whatever it is, what comes back is printable UTF-8.
namespace stoss {

/// The beginning of a text that is longer than `most` bytes, and how long it is; a shorter one as it is.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = 60);

/// The text on one line: control characters, and bytes that are no UTF-8, as `\n` or `\x1b`.
[[nodiscard]] std::string visible(std::string_view text);

/// The same with another code than `\x1b` for what has no letter. @param code of a byte
[[nodiscard]] std::string visible(std::string_view text, const std::function<std::string(unsigned char byte)>& code);

/// The beginning of the text on one line, in quotation marks.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The candidate that a misspelt word may mean, whatever its dashes and capitals; "" if none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace stoss
