#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stoss::table {

/// How a language says what the functions of a table are made of. Texts of functions have places for it: @word@, or
/// @word:argument@ for a word whose pattern has $ where the argument goes.
struct Language {
  struct Word {
    std::string_view key, pattern;
  };

  std::string_view comment, line, comment_end;  ///< begin the first line of a comment and the next ones; end it
  std::string_view array, array_end;            ///< around the cells, with places for @array@, @type@ and @size@
  std::string_view number, whole;               ///< types of cells
  std::string_view begin, end;                  ///< of a file, after its first comment
  std::vector<Word> words;
};

/// A header in C89 and C++, a module of Rust (edition 2018 and later), a module of ECMAScript 2015.
[[nodiscard]] const Language& language_c();
[[nodiscard]] const Language& language_rust();
[[nodiscard]] const Language& language_js();

/// A text with the words of a language in their places; other places stay.
[[nodiscard]] std::string worded(std::string_view text, const Language& language);

}  // namespace stoss::table
