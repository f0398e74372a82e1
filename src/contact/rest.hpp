#pragma once

#include "contact/response.hpp"

namespace stoss {

/// Whether no force acts in a contact and nothing in it moves any more by itself, to a displacement that is negligible:
/// only then it may rest.
[[nodiscard]] bool is_still(ContactResponse& response, double negligible);

/// Goes on for some time in which no node comes within its range.
void rest(ContactResponse& response, double time);

}  // namespace stoss
