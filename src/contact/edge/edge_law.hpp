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
  /// A body that relaxes, and its share of the softness of both.
  struct Relaxing {
    double share;
    Relaxation relaxation;
  };

  std::vector<double> force;         ///< f* of each node
  std::vector<double> gap;           ///< g* of each node, R
  double loss_time = 0.0;            ///< η of what meets, R/c
  std::vector<Relaxing> relaxing{};  ///< bodies of what meets
  double firmness = 1.0;             ///< by which all f* are multiplied at present (follow)
  double opening = 1.0;              ///< the same of all g*
  double shrinking = 0.0;            ///< for so long, R/c

  /// Whether the law follows the edge of a lossy contact.
  [[nodiscard]] bool follows() const { return loss_time > 0.0 || !relaxing.empty(); }

  /// f* and g* of a node at present.
  [[nodiscard]] double full_force(std::size_t i) const { return firmness * force[i]; }
  [[nodiscard]] double full_gap(std::size_t i) const { return opening * gap[i]; }

  /// E/E(0) of what meets, some time after it was pressed.
  [[nodiscard]] double modulus_at(double time) const;

  /// f for any closure: none below 0, as rigid contact needs it above 1.
  [[nodiscard]] double force_at(std::size_t i, double closure) const {
    return closure > 0.0 ? full_force(i) * closure * closure : 0.0;
  }

  /// g for any closure: 0 from 1 on.
  [[nodiscard]] double gap_at(std::size_t i, double closure) const {
    return closure < 1.0 ? full_gap(i) * (1.0 - closure) * (1.0 - closure) : 0.0;
  }

  /// df/dt of a node.
  [[nodiscard]] double force_slope(std::size_t i, double closure) const {
    return closure > 0.0 ? 2.0 * full_force(i) * closure : 0.0;
  }

  /// −dg/dt of a node.
  [[nodiscard]] double gap_slope(std::size_t i, double closure) const {
    return closure < 1.0 ? 2.0 * full_gap(i) * (1.0 - closure) : 0.0;
  }

  /// t of a node that has no force, and lies behind by a distance.
  [[nodiscard]] double free_closure(std::size_t i, double behind) const {
    return 1.0 - std::sqrt(std::max(0.0, behind) / full_gap(i));
  }

  /// Follows the edge of a lossy contact in a step, as the foremost node moves to a compression.
  ///
  /// An edge that passes a node in the time p meets the modulus E(p)/E(0), which its force takes while the contact
  /// spreads. What it leaves behind was pressed for the time t since the node touched: force and gap then go with
  /// E(t)/E(0), and the gap opens with E(p)/E(0) (docs/theory/loss.md). Where Kelvin and Voigt's contact shrinks, which
  /// has no E(p), the law holds between f and g + η ġ (Ting 1966), and g + η ġ reaches g* at a smaller gap the faster
  /// the edge recedes: at g*/(1 + (24 η/p)²), a fit.
  /// @param half_width of the contact in spacings
  void follow(double before, double now, double half_width, double step);

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
