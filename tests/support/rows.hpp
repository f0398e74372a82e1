#pragma once

// Rows of bodies for tests.

#include <cstddef>
#include <utility>
#include <vector>

#include "stoss/row/row.hpp"

namespace stoss::test {

using Speeds = std::vector<double>;

inline Row row_of(std::vector<BodyMaker> kinds, std::vector<std::size_t> bodies) {
  Row row;
  row.kinds = std::move(kinds);
  row.bodies = std::move(bodies);
  return row;
}

inline Row equal(const BodyMaker& maker, std::size_t count) { return row_of({maker}, std::vector<std::size_t>(count)); }

}  // namespace stoss::test
