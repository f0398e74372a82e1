#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "stoss/errors.hpp"

namespace stoss::test {

/// What `call` says when it throws Error; empty with a test failure if it does not.
template <typename Error, typename Call>
std::string message_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

/// `call` must refuse its input in one line that has every one of `parts` (the name, what was got, what is allowed).
template <typename Call>
void expect_refusal(Call call, const std::vector<std::string>& parts) {
  const std::string message = message_of<InvalidInput>(call);
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  // A range names what is allowed; what is missing, or cannot go together, says so in its own words.
  const std::vector<std::string> ways{"allowed", "missing", "cannot", "must", "needs", "not", "has", "already"};
  EXPECT_TRUE(std::any_of(ways.begin(), ways.end(), [&](const auto& each) {
    return message.find(each) != message.npos;
  })) << message;
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " | " << message;
}

}  // namespace stoss::test
