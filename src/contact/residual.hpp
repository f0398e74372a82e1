#pragma once

#include <functional>
#include <vector>

#include "stoss/body/body.hpp"

namespace stoss {

/// Matrix of one of a body's residual functions between the nodes of a grid.
/// @throws InvalidInput unless it has nodes × nodes values
[[nodiscard]] std::vector<double> residual_matrix(
    const Body& body, const std::function<std::vector<double>(const ContactGrid&, const Poll&)>& residual,
    const ContactGrid& grid, const Poll& poll);

}  // namespace stoss
