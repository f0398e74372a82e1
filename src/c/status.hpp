#pragma once

#include <exception>
#include <string_view>

#include "stoss/poll.hpp"
#include "stoss/stoss.h"

namespace stoss::c {

/// Keeps the message of the exception that is being handled for stoss_message and returns its status.
int status_of_exception() noexcept;

/// Runs what a function of the C interface does, and makes a status of what it throws.
template <typename Work>
int guarded(const Work& work) noexcept {
  try {
    work();
    return STOSS_OK;
  } catch (...) {
    return status_of_exception();
  }
}

/// Throws InvalidInput for NULL.
void require_given(const void* pointer, std::string_view name);

/// The poll of a caller, which ends the computation as it says; empty where there is none.
[[nodiscard]] Poll poll_of(const stoss_control* control);

/// The number of threads that the caller wants.
[[nodiscard]] int threads_of(const stoss_control* control);

}  // namespace stoss::c
