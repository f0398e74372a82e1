#include "input/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "process/text.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
void refuse_word(const std::string& option, const std::string& got, const std::vector<std::string>& allowed,
                 const std::string& where) {
  const std::string similar = nearest(got, allowed);
  const std::string names = allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, ", "));
  throw InvalidInput::out_of_range(
      fmt::format("{}", option), fmt::format("'{}'", shortened(got)),
      fmt::format("{}{}{}", names, where, similar.empty() ? "" : fmt::format(", did you mean {}?", similar)));
}

std::vector<std::pair<std::string, std::string>> parse_keys(const std::string& option,
                                                            const std::vector<std::string>& parts, std::size_t first,
                                                            const std::vector<std::string>& keys,
                                                            const std::string& where) {
  std::vector<std::pair<std::string, std::string>> found;
  for (std::size_t i = first; i < parts.size(); ++i) {
    const auto equals = parts[i].find('=');
    const std::string key = without_spaces(parts[i].substr(0, equals));
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) refuse_word(option, key, keys, where);
    if (equals == std::string::npos) {
      throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("'{}' without a value", key),
                                       fmt::format("{}=NUMBER", key));
    }
    if (std::any_of(found.begin(), found.end(), [&](const auto& each) { return each.first == key; })) {
      throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("{} twice", key), "once");
    }
    found.emplace_back(key, parts[i].substr(equals + 1));
  }
  return found;
}

}  // namespace stoss::cli
