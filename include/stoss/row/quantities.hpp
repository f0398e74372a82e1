#pragma once

#include "stoss/quantity.hpp"
#include "stoss/row/row.hpp"

namespace stoss {

/// One body of a row, before and after.
struct RowBody {
  int number = 0;         ///< from the left, from 0
  double velocity = 0.0;  ///< before
  Estimate velocity_after;
};

/// Quantities of a body of a row.
[[nodiscard]] const Quantities<RowBody>& row_body_quantities();

/// Quantities of a contact of a row.
[[nodiscard]] const Quantities<RowContact>& row_contact_quantities();

/// Quantities of a whole row.
[[nodiscard]] const Quantities<RowResult>& row_quantities();

}  // namespace stoss
