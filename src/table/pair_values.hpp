#pragma once

#include "stoss/table/pair_table.hpp"

namespace stoss {

/// Throws InvalidInput for what a PairTable cannot be made of.
void require_values(const PairValues& values);

/// Throws InvalidInput for what a PairTable does not do beyond its range.
void require_beyond(Beyond beyond);

}  // namespace stoss
