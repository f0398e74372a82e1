#include "suggestion.hpp"

#include <algorithm>
#include <numeric>

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

}  // namespace stoss::cli
