#pragma once

#include "restitution/error_bar.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Error of what the material takes in one run, from its nodes: those that a lossy contact leaves are the worse
/// resolved the fewer there are and the less each of them relaxes meanwhile. Asperities smear out the edge that leaves.
[[nodiscard]] Term node_error_of_losses(const Contact& contact, double speed, const Run& run);

}  // namespace stoss
