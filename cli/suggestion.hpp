#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stoss::cli {

/// The candidate that `word` begins, or that differs from it by one letter in three at most; "" if there is none.
/// Leading dashes do not count.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace stoss::cli
