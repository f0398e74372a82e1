#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// The contact against forces along the surface: of balls one, of disks two contacts of what Body::along makes.
/// @throws InvalidInput where a body has none, and at a wall that is not hard
[[nodiscard]] std::vector<Contact> contacts_along(const Contact& contact, const Poll& poll);

}  // namespace stoss
