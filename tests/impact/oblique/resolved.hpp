#pragma once

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss::test {

/// A number of points, and a step that is a share of the shortest period over 2π.
inline ImpactOptions resolved(const Contact& contact, int nodes, double share = 0.5) {
  ImpactOptions options;
  options.resolution.step = share / contact.cutoff;
  options.resolution.nodes = nodes;
  return options;
}

}  // namespace stoss::test
