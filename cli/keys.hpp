#pragma once

#include <string>
#include <vector>

namespace stoss::cli {

/// The text without spaces at its ends.
[[nodiscard]] std::string without_spaces(const std::string& text);

/// One KEY=VALUE of an option.
struct KeyedValue {
  std::string key;
  std::string value;
};

/// Refuses a word of an option, with those that it may be and the nearest of them.
/// @param where text behind the allowed ones
[[noreturn]] void refuse_word(const std::string& option, const std::string& got,
                              const std::vector<std::string>& allowed, const std::string& where = {});

/// The parts KEY=VALUE of an option from `first` on, in order.
/// @param where text behind the allowed keys
/// @throws InvalidInput for an unknown key, one that comes twice, and one without a value
[[nodiscard]] std::vector<KeyedValue> parse_keys(const std::string& option, const std::vector<std::string>& parts,
                                                 std::size_t first, const std::vector<std::string>& keys,
                                                 const std::string& where = {});

}  // namespace stoss::cli
