#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bodies/modal/point_modes.hpp"
#include "bodies/sphere/along/toroidal.hpp"
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

/// The same with what moves the pole along the surface: modes with one wave around the axis, and its c_t.
inline ModalBody modal_sphere_along(double poisson, double complete_to, bool bends = true) {
  ModalBody body = modal_sphere(poisson, complete_to, bends);
  body.tangent = PointTangent{.mass = body.mass,
                              .inertia = 0.4 * body.mass,
                              .arm = 1.0,
                              .compliance = bodies::modal::sphere_constant_along(poisson),
                              .has_bends = bends};
  const double root = std::sqrt(body.mass);
  const auto add = [&](double omega, double upper, double middle, double lower, double n) {
    // P_n = 1 − n(n + 1) θ²/4 near the pole.
    const auto turns = [](double degree) { return 0.25 * degree * (degree + 1.0); };
    const double bend = -turns(n + 1.0) * upper - turns(n) * middle - turns(n - 1.0) * lower;
    PointMode mode{omega, 0.0};
    mode.tangential = (upper + middle + lower) / root;
    mode.tangential_bend = bends ? bend / root : 0.0;
    body.modes.push_back(mode);
  };
  for (const bodies::Mode& mode : bodies::sphere::modes(poisson, complete_to)) {
    if (mode.order == 0) continue;
    const double n = mode.order, unit = std::sqrt(0.5 * n * (n + 1.0)) / (2.0 * n + 1.0);
    add(mode.omega, unit * (n * mode.tangential - mode.radial), 0.0, unit * (mode.radial + (n + 1.0) * mode.tangential),
        n);
  }
  for (const auto& mode : bodies::sphere::toroidal_modes(poisson, complete_to, {})) {
    const double n = mode.order;
    add(mode.omega, 0.0, mode.amplitude * std::sqrt(0.5 * n * (n + 1.0)), 0.0, n);
  }
  std::sort(body.modes.begin(), body.modes.end(),
            [](const PointMode& one, const PointMode& other) { return one.omega < other.omega; });
  return body;
}

}  // namespace stoss::test
