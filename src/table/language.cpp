#include "table/language.hpp"

#include <algorithm>

namespace stoss::table {

std::string worded(std::string_view text, const Language& language) {
  std::string out;
  while (!text.empty()) {
    const auto begin = text.find('@'), end = text.find('@', begin + 1);
    out += text.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::string_view place = text.substr(begin + 1, end - begin - 1);
    const std::string_view key = place.substr(0, place.find(':'));
    const std::string_view argument = place.substr(std::min(place.size(), key.size() + 1));
    const auto word = std::find_if(language.words.begin(), language.words.end(),
                                   [&](const Language::Word& each) { return each.key == key; });
    if (word == language.words.end()) {
      out += text.substr(begin, end + 1 - begin);
    } else {
      for (const char c : word->pattern) c == '$' ? out += argument : out += c;
    }
    text.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace stoss::table
