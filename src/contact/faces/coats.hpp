#pragma once

#include "stoss/contact/contact.hpp"

namespace stoss {

/// Compliance of both coats together, R/E of the first body; 0 where there is none.
[[nodiscard]] double coat_compliance(const Contact& contact);

/// What coats alone would be compressed by in an impact, Winkler's foundation on rigid bodies; 0 where there are none.
[[nodiscard]] double coat_compression(const Contact& contact, double speed);

}  // namespace stoss
