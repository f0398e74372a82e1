#pragma once

#include "bodies/plate/given.hpp"

namespace stoss::bodies::plate {

/// Greatest strain under a load, estimated: of the layers under the pressure of the contact, of a plate that bends, and
/// where it gives way by too much of its thickness (Body::strain).
[[nodiscard]] double strain_under(const Given& given, const Load& load);

}  // namespace stoss::bodies::plate
