#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// The contact against forces along the surface: of balls one, of disks two contacts of what Body::along makes.
/// @throws InvalidInput where a body has none, and at a wall that is not hard
[[nodiscard]] std::vector<Contact> contacts_along(const Contact& contact, const Poll& poll);

/// Reduced mass of whole bodies against forces along their surfaces, in units of the first.
[[nodiscard]] double mass_along(const Contact& contact);

/// What a body of it moves of the relative motion along the surface: the mass above over its own.
[[nodiscard]] double share_along(const Contact& contact, int number);

/// Two balls, or a ball at a wall, against forces alike all around the axis (Body::outward).
/// @throws InvalidInput as contacts_along
[[nodiscard]] Contact contact_outward(const Contact& contact, const Poll& poll);

/// Dundurs' constant β of the bodies of such contacts: how much pressure moves one along the other. It is
/// (1 − ν)/2 = (c_s/c_p)² of a disk at a wall, and 0 for bodies of one kind and where directions do not mix.
[[nodiscard]] double mixing(const std::vector<Contact>& along);

/// Friction above which waves of any length grow while a half-plane slides on a rigid wall, 1/(2√(β(1 − β))), so that
/// nothing has a limit as they are resolved; infinite for bodies of one kind. Between two elastic bodies, and in
/// contacts that end, some grow below it too.
[[nodiscard]] double stable_friction(const std::vector<Contact>& along);

}  // namespace stoss
