#pragma once

#include <exception>
#include <optional>
#include <string_view>

#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/poll.hpp"
#include "stoss/stoss.h"
#include "stoss/table/restitution_function.hpp"

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

// What the handles of the C interface hold.

struct stoss_body {
  stoss::Solid value;
  bool rigid = false;
  stoss::BodyMaker maker;
  stoss::Relaxation relaxation{};  ///< times in the unit of loss times
  bool rough = false;
};

struct stoss_contact {
  stoss::RefinableContact contact;
  stoss_body first;
  std::optional<stoss_body> second{};  ///< otherwise a wall
  stoss::Encounter encounter{};        ///< with its units and vibration; without any where bodies made it
};

struct stoss_function {
  stoss::RestitutionFunction function;
};
