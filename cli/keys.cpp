#include "keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stoss/errors.hpp"
#include "suggestion.hpp"
#include "text.hpp"

namespace stoss::cli {

std::string without_spaces(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

void refuse_word(const std::string& option, const std::string& got, const std::vector<std::string>& allowed,
                 const std::string& where) {
  const std::string similar = nearest(got, allowed);
  const std::string names = allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, ", "));
  throw InvalidInput(fmt::format("{}: got '{}', allowed {}{}{}", option, shortened(got), names, where,
                                 similar.empty() ? "" : fmt::format(", did you mean {}?", similar)));
}

std::vector<KeyedValue> parse_keys(const std::string& option, const std::vector<std::string>& parts, std::size_t first,
                                   const std::vector<std::string>& keys, const std::string& where) {
  std::vector<KeyedValue> found;
  for (std::size_t i = first; i < parts.size(); ++i) {
    const auto equals = parts[i].find('=');
    const std::string key = without_spaces(parts[i].substr(0, equals));
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) refuse_word(option, key, keys, where);
    if (equals == std::string::npos) {
      throw InvalidInput(fmt::format("{0}: got '{1}' without a value, allowed {1}=NUMBER", option, key));
    }
    if (std::any_of(found.begin(), found.end(), [&](const KeyedValue& each) { return each.key == key; })) {
      throw InvalidInput(fmt::format("{}: got {} twice, allowed once", option, key));
    }
    found.push_back({key, parts[i].substr(equals + 1)});
  }
  return found;
}

}  // namespace stoss::cli
