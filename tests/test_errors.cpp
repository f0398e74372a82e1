#include "stoss/errors.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace stoss {
namespace {

TEST(InvalidInput, IsOneLineOfItsParts) {
  const InvalidInput range = InvalidInput::out_of_range("speed", "2", "1e-8 to 1", "in c");
  EXPECT_STREQ(range.what(), "speed: got 2, allowed 1e-8 to 1 (in c)");
  EXPECT_EQ(range.kind(), InvalidInput::Kind::out_of_range);
  EXPECT_EQ(range.name(), "speed");
  EXPECT_EQ(range.got(), "2");
  EXPECT_EQ(range.allowed(), "1e-8 to 1");
  EXPECT_EQ(range.hint(), "in c");
  EXPECT_STREQ(InvalidInput::missing("radius", "a number", "in m").what(), "radius: missing, a number (in m)");
  EXPECT_STREQ(InvalidInput::missing("radius", "").what(), "radius: missing");
  const InvalidInput conflict = InvalidInput::conflict("rigid", "both bodies are rigid", "one must deform");
  EXPECT_STREQ(conflict.what(), "rigid: both bodies are rigid (one must deform)");
  EXPECT_EQ(conflict.got(), "");
}

TEST(InvalidInput, OfAPartHasTheNameOfTheWholeFirst) {
  const InvalidInput of_part = InvalidInput::out_of_range("radius", "-1", "above 0").within("against");
  EXPECT_EQ(of_part.name(), "against radius");
  EXPECT_STREQ(of_part.what(), "against radius: got -1, allowed above 0");
}

TEST(InvalidInput, MayNameTheInputByWhichItsHintIsFollowed) {
  const InvalidInput plain = InvalidInput::out_of_range("young ratio", "1e-7", "1e-6 to 1e6", "let the first be rigid");
  EXPECT_EQ(plain.way(), "");
  EXPECT_EQ(plain.with_way("rigid").way(), "rigid");
  EXPECT_STREQ(plain.with_way("rigid").what(), plain.what());
}

TEST(NotConverged, IsOneLineOfItsParts) {
  static_assert(std::is_nothrow_copy_constructible_v<NotConverged>);
  const NotConverged failed("impact: 0.1 of the energy is unaccounted for", "step", "use a smaller step");
  EXPECT_STREQ(failed.what(), "impact: 0.1 of the energy is unaccounted for (use a smaller step)");
  EXPECT_EQ(failed.failure(), "impact: 0.1 of the energy is unaccounted for");
  EXPECT_EQ(failed.input(), "step");
  EXPECT_EQ(failed.hint(), "use a smaller step");
  EXPECT_STREQ(NotConverged("no end").what(), "no end");
}

TEST(InvalidInput, IsCopiedWithoutAThrow) {
  static_assert(std::is_nothrow_copy_constructible_v<InvalidInput>);
  const InvalidInput first = InvalidInput::missing("radius", "a number");
  const InvalidInput copy = first;  // NOLINT(performance-unnecessary-copy-initialization): as a thrown one is
  EXPECT_EQ(copy.name(), first.name());
}

}  // namespace
}  // namespace stoss
