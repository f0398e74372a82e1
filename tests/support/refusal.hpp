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
  std::string message;
  try {
    call();
    ADD_FAILURE() << "nothing was refused";
  } catch (const InvalidInput& refusal) {
    message = refusal.what();
    const bool range = refusal.kind() == InvalidInput::Kind::out_of_range;
    EXPECT_FALSE(refusal.name().empty()) << message;
    EXPECT_EQ(refusal.got().empty(), !range) << message;
    EXPECT_TRUE(!refusal.allowed().empty() || refusal.kind() == InvalidInput::Kind::missing) << message;
  }
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " | " << message;
}

}  // namespace stoss::test
