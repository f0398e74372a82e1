#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "impact/oblique/frame.hpp"
#include "impact/pressures.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/oblique_snapshot.hpp"

namespace stoss {

/// A normal impact at an instant.
struct NormalInstant {
  double time;
  double velocity, center;        ///< of whole bodies (WholeBodies): along the normal, and as Snapshot::center
  const double* force = nullptr;  ///< pressure of each node times its area; null: none
};

/// A normal impact with its pressures.
struct NormalCourse {
  NormalCourse(const Contact& contact, double speed, const ImpactOptions& options);

  /// Between and beside the steps with a force bodies fly freely.
  [[nodiscard]] NormalInstant at(long step) const;

  Impact impact;
  Pressures pressures;
  ObliqueFrame frame;
  double mass;    ///< of what is there
  double extent;  ///< distance of the centres at first touch
  double unit;    ///< of force, mc²/R of the first
  ContactPoints nodes;
  std::array<std::vector<double>, 2> arm;  ///< of friction at each node about the centre of each body that turns
  std::vector<ObliquePoint> points;        ///< at rest
};

}  // namespace stoss
