// "0.5:1+0.2:10": a relaxation on one line.
#include <string>

#include "check.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss {

Relaxation parse_relaxation(const std::string& name, std::string_view text) {
  Relaxation made;
  for (std::size_t begin = 0; begin <= text.size();) {
    // A sign of an exponent, as in 1e+3, is no end of a term.
    std::size_t end = text.find('+', begin);
    while (end != std::string_view::npos && end > begin && (text[end - 1] == 'e' || text[end - 1] == 'E')) {
      end = text.find('+', end + 1);
    }
    const std::string_view term = text.substr(begin, end == std::string_view::npos ? end : end - begin);
    const std::size_t colon = term.find(':');
    if (colon == std::string_view::npos || colon == 0 || colon + 1 == term.size()) {
      throw InvalidInput::out_of_range(name, in_quotes(text), "SHARE:TIME+SHARE:TIME..., as in 0.5:1+0.2:10",
                                       "shares of E(0) and their times");
    }
    made.terms.push_back({parse_number(name, std::string(term.substr(0, colon))),
                          parse_number(name, std::string(term.substr(colon + 1)))});
    if (end == std::string_view::npos) break;
    begin = end + 1;
  }
  return made;
}

std::string text_of(const Relaxation& relaxation) {
  std::string text;
  for (const RelaxationTerm& term : relaxation.terms) {
    if (!text.empty()) text += '+';
    text += shown(term.share);
    text += ':';
    text += shown(term.time);
  }
  return text;
}

}  // namespace stoss
