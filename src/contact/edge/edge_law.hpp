#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// The law between force f and gap g of a contact node, in place of f ≥ 0, g ≥ 0, f g = 0:
///
///   √(f/f*) + √(g/g*) = 1   for 0 < f < f*;   g = 0 for f ≥ f*;   f = 0 for g ≥ g*.
///
/// It lets the edge of the contact pass a node gradually, and the force follow the envelope of those of all whole
/// numbers of touching nodes, which is that of the exact contact at compression + h²/(24 R), of rings h²/(12 R)
/// (docs/developer/numerics.md, section 3). With the closure t = 1 − √(g/g*), f = f* t² and g = g* (1 − t)²: one smooth
/// curve.
struct EdgeLaw {
  std::vector<double> force;  ///< f* of each node
  std::vector<double> gap;    ///< g* of each node, R
  double loss_time = 0.0;     ///< η of what meets, R/c
  double opening = 1.0;       ///< by which all g* are multiplied at present (recede)

  /// f for any closure: none below 0, as rigid contact needs it above 1.
  [[nodiscard]] double force_at(std::size_t i, double closure) const {
    return closure > 0.0 ? force[i] * closure * closure : 0.0;
  }

  /// g for any closure: 0 from 1 on.
  [[nodiscard]] double gap_at(std::size_t i, double closure) const {
    return closure < 1.0 ? opening * gap[i] * (1.0 - closure) * (1.0 - closure) : 0.0;
  }

  /// df/dt of a node.
  [[nodiscard]] double force_slope(std::size_t i, double closure) const {
    return closure > 0.0 ? 2.0 * force[i] * closure : 0.0;
  }

  /// −dg/dt of a node.
  [[nodiscard]] double gap_slope(std::size_t i, double closure) const {
    return closure < 1.0 ? 2.0 * opening * gap[i] * (1.0 - closure) : 0.0;
  }

  /// t of a node that has no force, and lies behind by a distance.
  [[nodiscard]] double free_closure(std::size_t i, double behind) const {
    return 1.0 - std::sqrt(std::max(0.0, behind) / (opening * gap[i]));
  }

  /// Makes the gaps those of a contact that spreads (0), or shrinks by `rate` spacings per R/c. Where a lossy contact
  /// shrinks, the law holds between f and g + η ġ (Ting 1966), and g + η ġ reaches g* at a smaller gap the faster the
  /// edge recedes: at g*/(1 + (24 η rate)²), a fit (docs/theory/loss.md).
  void recede(double rate);

  /// Energy that the law of a node holds, ∫₀ᶠ g df.
  [[nodiscard]] double energy_at(std::size_t i, double closure) const;

  /// Distance in front of first contact from which a node of an unexcited body feels the law, R.
  [[nodiscard]] double range(const std::vector<double>& recess) const;
};

/// f* = 0.7145 κ h^{3/2}/D, g* = 0.6177 κ h^{3/2} with κ s^{3/2} the gap at a distance s from the edge of a Hertzian
/// contact, (2√2/3) √a/R at a line and (8√2/3π) √a/R at a circle, D its softness and h the spacing; a ring has π sin α
/// times that force, for the length of its edge. κ is less where the edge outruns the waves. Empty for a single point.
/// @param speed of approach, which says how fast the edge moves
[[nodiscard]] EdgeLaw edge_law(const Contact& contact, const ContactGrid& grid, double speed);

}  // namespace stoss
