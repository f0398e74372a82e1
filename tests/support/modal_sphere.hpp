#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bodies/modal/point_compliance.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::test {

/// A sphere as its pole sees it, in its units: its axisymmetric modes up to a frequency, and its c₀.
inline ModalBody modal_sphere(double poisson, double complete_to, bool bends = true) {
  ModalBody body;
  body.mass = 4.0 * std::numbers::pi / 3.0;
  body.curvature = 1.0;
  body.poisson = poisson;
  body.compliance = bodies::modal::sphere_constant(poisson);
  body.complete_to = complete_to;
  body.has_bends = bends;
  const double root = std::sqrt(body.mass);
  for (const bodies::Mode& mode : bodies::sphere::modes(poisson, complete_to)) {
    // Near the pole U cos θ P_n − V sin θ dP_n/dθ = U + χ θ².
    const double turns = 0.5 * mode.order * (mode.order + 1.0);
    const double bend = mode.tangential * turns - 0.5 * mode.radial * (1.0 + turns);
    body.modes.push_back({mode.omega, mode.radial / root, bends ? bend / root : 0.0});
  }
  std::sort(body.modes.begin(), body.modes.end(),
            [](const PointMode& one, const PointMode& other) { return one.omega < other.omega; });
  return body;
}

}  // namespace stoss::test
