#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stoss::cli {

/// The candidate that `word` begins, or that differs from it by one letter in three at most; "" if there is none.
/// Leading dashes do not count.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// Refuses a word of an option, with those that it may be and the nearest of them.
/// @param where text behind the allowed ones
[[noreturn]] void refuse_word(const std::string& option, const std::string& got,
                              const std::vector<std::string>& allowed, const std::string& where = {});

/// The parts KEY=VALUE of an option from `first` on, in order, as keys and values.
/// @param where text behind the allowed keys
/// @throws InvalidInput for an unknown key, one that comes twice, and one without a value
[[nodiscard]] std::vector<std::pair<std::string, std::string>> parse_keys(const std::string& option,
                                                                          const std::vector<std::string>& parts,
                                                                          std::size_t first,
                                                                          const std::vector<std::string>& keys,
                                                                          const std::string& where = {});

}  // namespace stoss::cli
