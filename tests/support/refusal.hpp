#pragma once

#include <gtest/gtest.h>

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
  EXPECT_NE(message.find("allowed"), std::string::npos) << message;
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " | " << message;
}

}  // namespace stoss::test
