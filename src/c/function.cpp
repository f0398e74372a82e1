#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "c/interface.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/adaptive.hpp"

namespace {

using stoss::c::guarded;
using stoss::c::require_given;

stoss::Beyond beyond_of(int number) {
  if (number == STOSS_BEYOND_ERROR) return stoss::Beyond::error;
  if (number == STOSS_BEYOND_CLAMP) return stoss::Beyond::clamp;
  if (number == STOSS_BEYOND_LAW) return stoss::Beyond::law;
  throw stoss::InvalidInput::out_of_range("beyond", std::to_string(number),
                                          "STOSS_BEYOND_ERROR, STOSS_BEYOND_CLAMP or STOSS_BEYOND_LAW");
}

stoss::SlowLaw law_of(const stoss_contact& contact) {
  if (contact.first.rough || (contact.second && contact.second->rough)) {
    throw stoss::InvalidInput::conflict("beyond", "the law of slow impacts knows smooth faces alone");
  }
  stoss::refuse_rough(contact.encounter, "the law of slow impacts");
  const stoss_body& first = contact.first;
  if (!contact.second) return stoss::slow_law(first.value, {}, {first.rigid, false, first.relaxation, {}});
  const stoss_body& second = *contact.second;
  return stoss::slow_law(first.value, second.value, {first.rigid, second.rigid, first.relaxation, second.relaxation});
}

void require_unexcited(const stoss_contact& contact) {
  if (contact.encounter.vibration.empty()) return;
  throw stoss::InvalidInput::conflict("vibration", "a function of the speed is of bodies that do not vibrate before");
}

}  // namespace

extern "C" {

int stoss_function_make(const stoss_contact* contact, double slowest, double fastest, double error, int beyond,
                        const stoss_control* control, stoss_function** function) {
  return guarded([&] {
    require_given(contact, "contact");
    require_given(function, "function");
    require_unexcited(*contact);
    const stoss::FunctionOptions options{.error = error,
                                         .beyond = beyond_of(beyond),
                                         .law = beyond == STOSS_BEYOND_LAW ? law_of(*contact) : nullptr,
                                         .threads = stoss::c::threads_of(control),
                                         .poll = stoss::c::poll_of(control)};
    *function = new stoss_function{stoss::restitution_function(contact->contact, slowest, fastest, options)};
  });
}

int stoss_function_evaluate(const stoss_function* function, const double* speeds, size_t count, double* values,
                            double* errors) {
  int status = guarded([&] {
    require_given(function, "function");
    require_given(speeds, "speeds");
    require_given(values, "values");
  });
  if (status != STOSS_OK) return status;
  for (std::size_t i = 0; i < count; ++i) {
    const int own = guarded([&] {
      if (errors == nullptr) {
        values[i] = function->function.value(speeds[i]);
      } else {
        const stoss::Estimate estimate = function->function(speeds[i]);
        values[i] = estimate.value;
        errors[i] = estimate.error;
      }
    });
    if (own == STOSS_OK) continue;
    status = own;
    values[i] = std::numeric_limits<double>::quiet_NaN();
    if (errors != nullptr) errors[i] = std::numeric_limits<double>::infinity();
  }
  return status;
}

int stoss_function_range(const stoss_function* function, double* slowest, double* fastest, double* greatest_error) {
  return guarded([&] {
    require_given(function, "function");
    if (slowest != nullptr) *slowest = function->function.slowest();
    if (fastest != nullptr) *fastest = function->function.fastest();
    if (greatest_error != nullptr) *greatest_error = function->function.greatest_error();
  });
}

void stoss_function_free(stoss_function* function) { delete function; }

}  // extern "C"
