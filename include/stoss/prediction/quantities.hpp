#pragma once

#include "stoss/prediction/prediction.hpp"
#include "stoss/quantity.hpp"

namespace stoss {

/// Quantities of a prediction, all in SI; influences and warnings are not among them.
[[nodiscard]] const Quantities<Prediction>& prediction_quantities();

}  // namespace stoss
