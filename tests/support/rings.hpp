#pragma once

#include "stoss/impact/impact.hpp"

namespace stoss::test {

/// How finely spheres meet, with a fixed number of rings and a fixed step.
inline ImpactOptions rings(int nodes, double step) {
  ImpactOptions options;
  options.resolution.nodes = nodes;
  options.resolution.step = step;
  return options;
}

}  // namespace stoss::test
