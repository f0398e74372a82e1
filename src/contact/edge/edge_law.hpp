#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/touch.hpp"
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
///
/// Between rough faces asperities of the length u₀ are in series with it, f = p₀A e^{−g/u₀}. Then f = f* e^t for t > 0
/// and g = g* − u₀ t less what the edge has closed, with f* a force that does not matter and g* the gap at which it
/// acts. Where asperities are much longer than the gaps of the edge, its law leaves: edges are then smeared out over
/// more than a spacing (docs/theory/roughness.md).
struct EdgeLaw {
  std::vector<double> force;             ///< f* of each node
  std::vector<double> gap;               ///< g* of each node, R
  double asperities = 0.0;               ///< u₀, R; 0 between smooth faces
  std::vector<double> edge_force{};      ///< what f* is between smooth faces, and
  std::vector<double> edge_gap{};        ///< g*, as far as the edge is not smeared out, and
  std::vector<double> edge_open{};       ///< the share of it that is left at f*; all three of rough faces alone
  double loss_time = 0.0;                ///< η of what meets, R/c
  std::vector<RelaxingBody> relaxing{};  ///< of what meets
  double firmness = 1.0;                 ///< by which all f* are multiplied at present (follow)
  double opening = 1.0;                  ///< the same of all g*
  double shrinking = 0.0;                ///< for so long, R/c

  /// Whether the law follows the edge of a lossy contact.
  [[nodiscard]] bool follows() const { return loss_time > 0.0 || !relaxing.empty(); }

  /// f* and g* of a node at present.
  [[nodiscard]] double full_force(std::size_t i) const { return firmness * force[i]; }
  [[nodiscard]] double full_gap(std::size_t i) const { return opening * gap[i]; }

  /// E/E(0) of what meets, some time after it was pressed.
  [[nodiscard]] double modulus_at(double time) const;

  /// f for any closure: none below 0, as rigid contact needs it above 1.
  [[nodiscard]] double force_at(std::size_t i, double closure) const {
    if (!(closure > 0.0)) return 0.0;
    return asperities > 0.0 ? force[i] * std::exp(closure) : full_force(i) * closure * closure;
  }

  /// g for any closure: 0 from 1 on, or below 0 where asperities are pressed beyond their mean plane.
  [[nodiscard]] double gap_at(std::size_t i, double closure) const {
    if (asperities > 0.0) {
      if (!(closure > 0.0)) return gap[i] - asperities * closure;
      const double open = 1.0 - edge_closure(i, closure);
      return gap[i] - asperities * closure - edge_gap[i] * (edge_open[i] - open * open);
    }
    return closure < 1.0 ? full_gap(i) * (1.0 - closure) * (1.0 - closure) : 0.0;
  }

  /// df/dt of a node.
  [[nodiscard]] double force_slope(std::size_t i, double closure) const {
    if (asperities > 0.0) return force_at(i, closure);
    return closure > 0.0 ? 2.0 * full_force(i) * closure : 0.0;
  }

  /// −dg/dt of a node.
  [[nodiscard]] double gap_slope(std::size_t i, double closure) const {
    if (asperities > 0.0) {
      const double closed = edge_closure(i, closure);
      return asperities + edge_gap[i] * closed * (1.0 - closed);
    }
    return closure < 1.0 ? 2.0 * full_gap(i) * (1.0 - closure) : 0.0;
  }

  /// t after a step of Newton's method; of asperities that with which the node by itself, w f + u₀ t, moves as the step
  /// has it, however far that is.
  /// @param own compliance of the node alone, w
  [[nodiscard]] double moved(std::size_t i, double closure, double change, double own) const;

  /// t of a node that has no force, and lies behind by a distance.
  [[nodiscard]] double free_closure(std::size_t i, double behind) const {
    if (asperities > 0.0) return (gap[i] - behind) / asperities;
    return 1.0 - std::sqrt(std::max(0.0, behind) / full_gap(i));
  }

  /// t of a node that begins to feel the law, as far as it is closed at most.
  /// @param behind as above @param compliance of the node alone
  [[nodiscard]] double first_closure(std::size_t i, double behind, double compliance) const {
    const double free = free_closure(i, behind);
    if (!(asperities > 0.0)) return std::min(0.5, free);
    return free > 0.0 ? std::min(free, std::log1p((gap[i] - behind) / (compliance * force[i]))) : free;
  }

  /// √(f/f*) of the smooth edge between rough faces, at most 1.
  [[nodiscard]] double edge_closure(std::size_t i, double closure) const {
    return closure > 0.0 ? std::min(1.0, std::sqrt(force_at(i, closure) / edge_force[i])) : 0.0;
  }

  /// Whether asperities push on a node with a pressure that matters beside the greatest.
  [[nodiscard]] static bool pushes_at(const std::vector<double>& closure, std::size_t i);

  /// Half-width in spacings within which asperities push with a thousandth of the greatest pressure or more.
  [[nodiscard]] static double pressed(const std::vector<double>& closure);

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
/// Of asperities A is the projected area of a node, and f* and g* are those of a layer that holds 10⁻¹² of the energy,
/// or pushes as little in the time 1/ω_c.
/// @param speed of an impact with all the energy there is, which says how fast the edge moves
[[nodiscard]] EdgeLaw edge_law(const Contact& contact, const ContactGrid& grid, double speed);

/// Share of the gap of a smooth edge that asperities leave at the edge of the contact that is expected; 1 between
/// smooth faces. @param speed as above
[[nodiscard]] double edge_left(const Contact& contact, const ContactGrid& grid, double speed);

}  // namespace stoss
