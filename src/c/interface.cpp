#include "c/interface.hpp"

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

/// The message and its parts, in arrays, which are there without memory to be had. Longer texts end early.
struct Failure {
  using Text = std::array<char, 1024>;
  Text message{};
  int kind = 0;
  Text name{}, got{}, allowed{}, hint{};
};

thread_local Failure last;

void copy(std::string_view text, Failure::Text& to) noexcept {
  const std::size_t length = std::min(text.size(), to.size() - 1);
  std::copy_n(text.begin(), length, to.begin());
  to[length] = '\0';
}

int keep(int status, std::string_view text) noexcept {
  last = {};
  copy(text, last.message);
  return status;
}

int keep(const InvalidInput& refusal) noexcept {
  keep(STOSS_INVALID_INPUT, refusal.what());
  constexpr std::array kinds{STOSS_OUT_OF_RANGE, STOSS_MISSING, STOSS_CONFLICT};
  last.kind = kinds[static_cast<std::size_t>(refusal.kind())];
  copy(refusal.name(), last.name);
  copy(refusal.got(), last.got);
  copy(refusal.allowed(), last.allowed);
  copy(refusal.hint(), last.hint);
  return STOSS_INVALID_INPUT;
}

}  // namespace

int status_of_exception() noexcept {
  try {
    throw;
  } catch (const Interrupted&) {
    return keep(STOSS_INTERRUPTED, "interrupted by the poll of the caller");
  } catch (const InvalidInput& error) {
    return keep(error);
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
  if (pointer == nullptr) throw InvalidInput::out_of_range(std::string(name), "NULL", "a pointer to it");
}

Poll poll_of(const stoss_control* control) {
  if (control == nullptr || control->poll == nullptr) return {};
  return [poll = control->poll, context = control->context] {
    if (poll(context) != 0) throw Interrupted{};
  };
}

int threads_of(const stoss_control* control) { return control == nullptr ? 0 : control->threads; }

}  // namespace stoss::c

extern "C" {

const char* stoss_message() { return stoss::c::last.message.data(); }

stoss_refusal stoss_last_refusal() {
  const auto& last = stoss::c::last;
  return {last.kind, last.name.data(), last.got.data(), last.allowed.data(), last.hint.data()};
}
}
