#include "stoss/body.hpp"

namespace stoss {

std::size_t mode_count(const Body& body) {
  std::size_t count = 0;
  for (const auto& group : body.groups) count += group.omega.size();
  return count;
}

}  // namespace stoss
