#pragma once

#include "c/handles.hpp"
#include "stoss/table/restitution_function.hpp"

namespace stoss::c {

/// The law of slow impacts of these bodies. @throws InvalidInput where there is none
[[nodiscard]] SlowLaw law_of(const stoss_contact& contact);

}  // namespace stoss::c
