#include "c/status.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string>

#include "stoss/errors.hpp"

namespace stoss::c {
namespace {

/// The poll of the caller asked for the end.
struct Interrupted {};

// An array, which is there without memory to be had. Longer messages end early.
thread_local std::array<char, 1024> message{};

int keep(int status, std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), message.size() - 1);
  std::copy_n(text.begin(), length, message.begin());
  message[length] = '\0';
  return status;
}

}  // namespace

int status_of_exception() noexcept {
  try {
    throw;
  } catch (const Interrupted&) {
    return keep(STOSS_INTERRUPTED, "interrupted by the poll of the caller");
  } catch (const InvalidInput& error) {
    return keep(STOSS_INVALID_INPUT, error.what());
  } catch (const NotConverged& error) {
    return keep(STOSS_NOT_CONVERGED, error.what());
  } catch (const std::bad_alloc&) {
    return keep(STOSS_OUT_OF_MEMORY, "out of memory");
  } catch (const std::length_error&) {  // of a container that no memory could hold
    return keep(STOSS_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return keep(STOSS_FAILED, error.what());
  } catch (...) {
    return keep(STOSS_FAILED, "unknown exception");
  }
}

void require_given(const void* pointer, std::string_view name) {
  if (pointer == nullptr) throw InvalidInput(std::string(name) + ": got NULL, allowed a pointer to it");
}

Poll poll_of(const stoss_control* control) {
  if (control == nullptr || control->poll == nullptr) return {};
  return [poll = control->poll, context = control->context] {
    if (poll(context) != 0) throw Interrupted{};
  };
}

int threads_of(const stoss_control* control) { return control == nullptr ? 0 : control->threads; }

}  // namespace stoss::c

extern "C" const char* stoss_message() { return stoss::c::message.data(); }
