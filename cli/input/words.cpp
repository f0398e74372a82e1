#include "input/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "process/text.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

std::string_view without_dashes(std::string_view word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// Levenshtein's distance: letters to insert, remove or replace.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  word = without_dashes(word);
  constexpr std::size_t longest = 30;  // of what could be a misspelt option
  if (word.size() > longest) return {};
  std::size_t least = word.size() / 3 + 1;
  std::string best;
  for (const std::string& candidate : candidates) {
    const std::string_view name = without_dashes(candidate);
    const bool begins = word.size() >= 3 && name.substr(0, word.size()) == word;
    const std::size_t difference = begins ? 0 : distance(word, name);
    if (difference >= least) continue;
    least = difference;
    best = candidate;
  }
  return best;
}

void refuse_word(const std::string& option, const std::string& got, const std::vector<std::string>& allowed,
                 const std::string& where) {
  const std::string similar = nearest(got, allowed);
  const std::string names = allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, ", "));
  throw InvalidInput(fmt::format("{}: got '{}', allowed {}{}{}", option, shortened(got), names, where,
                                 similar.empty() ? "" : fmt::format(", did you mean {}?", similar)));
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
      throw InvalidInput(fmt::format("{0}: got '{1}' without a value, allowed {1}=NUMBER", option, key));
    }
    if (std::any_of(found.begin(), found.end(), [&](const auto& each) { return each.first == key; })) {
      throw InvalidInput(fmt::format("{}: got {} twice, allowed once", option, key));
    }
    found.emplace_back(key, parts[i].substr(equals + 1));
  }
  return found;
}

}  // namespace stoss::cli
