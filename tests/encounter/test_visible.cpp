// Text of others in messages.
#include "stoss/encounter/visible.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stoss {
namespace {

TEST(Visible, LongTextsAreShortenedBetweenCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc... (4 bytes)");
  EXPECT_EQ(shortened("ab\u03b5d", 3), "ab... (5 bytes)");
}

TEST(Visible, LeavesWhatCanBePrinted) {
  for (const char* text :
       {"", "abc \\n", "\u00e9", "\u03b5", "\u20ac", "\xed\x9f\xbf", "\ue000", "\U00010000", "\U0010fffd"}) {
    EXPECT_EQ(visible(text), text);
  }
}

TEST(Visible, ShowsTheBytesOfWhatCannot) {
  EXPECT_EQ(visible("a\nb\r\tc\x1b\x7f"), "a\\nb\\r\\tc\\x1b\\x7f");
  EXPECT_EQ(visible(std::string(1, '\0')), "\\x00");
  // No UTF-8: cut off, alone, longer than needed, of a surrogate, beyond the last character.
  EXPECT_EQ(visible("\xc3"), "\\xc3");
  EXPECT_EQ(visible("\x80z"), "\\x80z");
  EXPECT_EQ(visible("\xe0\x80\x80"), "\\xe0\\x80\\x80");
  EXPECT_EQ(visible("\xf0\x80\x80\x80"), "\\xf0\\x80\\x80\\x80");
  EXPECT_EQ(visible("\xed\xa0\x80"), "\\xed\\xa0\\x80");
  EXPECT_EQ(visible("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  // Further line ends, and controls of more than a byte.
  EXPECT_EQ(visible("\u2028\u2029\xc2\x85"), "\\xe2\\x80\\xa8\\xe2\\x80\\xa9\\xc2\\x85");
}

TEST(Visible, TakesAnotherCode) {
  EXPECT_EQ(visible("\x1b!", [](unsigned char byte) { return "<" + std::to_string(byte) + ">"; }), "<27>!");
}

TEST(Visible, QuotesTheBeginning) { EXPECT_EQ(in_quotes(std::string(61, '\n')).substr(0, 5), "'\\n\\n"); }

}  // namespace
}  // namespace stoss
