#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// A value of ε that a table needs.
struct Request {
  const RefinableContact* contact;
  double speed;
};

/// ε of each request to a share of an absolute error, on several threads; the result does not depend on them.
/// @param place what a message says of a request, as "speed 0.1 c"
/// @throws NotConverged for a value that does not reach it; what poll throws
[[nodiscard]] std::vector<Estimate> computed_values(const std::vector<Request>& requests, double error, double share,
                                                    int threads, const Poll& poll,
                                                    const std::function<std::string(std::size_t)>& place);

}  // namespace stoss
