#pragma once

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// Greatest strain of the bodies in an impact, estimated (Impact::strain).
[[nodiscard]] double greatest_strain(const Contact& contact, double speed, const ImpactOptions& options,
                                     const Impact& impact);

}  // namespace stoss
