#pragma once

#include <span>
#include <vector>

#include "stoss/body/body.hpp"

namespace stoss::bodies::rod {

/// Displacement relative to the moving centre of mass, and stress, at points along a rod.
struct Field {
  std::vector<double> displacement;  ///< u, towards what the rod meets, L
  std::vector<double> stress;        ///< σ, E; tension is positive
};

/// Displacement and stress inside a rod during an impact: the kept modes as they move, and all others in their static
/// answer to the force at the struck end,
///
///   u = u_static[F] + Σ_kept (Q_l − Q_l,static) √2 cos lπs,   u_static = −F (1/3 − s + s²/2),   Q_l,static = −√2
///   F/ω_l²,
///
/// σ = −du/ds, so that σ = −F at the struck end s = 0 and 0 at the other. Wave fronts are as sharp as the kept modes
/// make them.
/// @param body       a rod
/// @param coordinate Q of its kept modes, from Snapshot::coordinate
/// @param force      F on its end, EA
/// @param place      s, 0 … 1 L from the struck end
/// @throws InvalidInput for another number of coordinates than modes, numbers that are not finite and points outside
[[nodiscard]] Field field(const Body& body, std::span<const double> coordinate, double force,
                          const std::vector<double>& place);

}  // namespace stoss::bodies::rod
