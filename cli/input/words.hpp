#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stoss::cli {

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
