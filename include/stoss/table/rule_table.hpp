#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// What a RuleTable is made of.
struct RuleValues {
  TableValues restitution;           ///< ε_n
  TableValues sliding;               ///< q = s′/(|s| + μ v_n): 0 at z = −1, 1 at z = 1
  std::optional<double> friction{};  ///< μ for which the values hold; nothing: any
};

/// What a collision does.
struct Rule {
  Estimate restitution;        ///< ε_n
  double sliding_after = 0.0;  ///< s′, of the sign of s where sliding goes on; |s′| ≤ |s|
  double sliding_error = 0.0;  ///< error of s′ over |v_t| + |Ω₁|R₁ + |Ω₂|R₂ + μ v_n, which is |s| + μ v_n or more
};

/// The collision rule of two bodies, or of a mixture, as a function: ε_n and s′ of the normal speed v_n, the sliding s
/// and the friction μ of Coulomb's law (Obliquity), and of the ratio of the radii.
///
/// Divided by μ the motion along the surface depends on v_n and s/μ v_n alone, where the directions do not act on each
/// other; else the table is of one friction. Tabulated is q = s′/(|s| + μ v_n) against z = (|s| − μ v_n)/(|s| + μ v_n):
/// near z = −1, where all sticks, it is −½ε_t (1 + z), and from where all slides throughout on to z = 1, with
/// s′ = s − fμ v_n, it is a straight line as well. So there is nothing beyond its range but speeds and ratios. In ln v
/// it is a monotone cubic, in z and in the ratio a cubic with the slopes of parabolas, as in PairTable.
///
/// ε_n ≤ 1 and |s′| ≤ |s| hold at any arguments: no collision gains energy. Velocity and spin count by their sum s.
/// What is not so, because contact points beside the foremost one have shorter arms, is in the error of s′.
///
/// An immutable value, for any number of threads.
class RuleTable {
 public:
  /// @param beyond error or clamp, for speeds and for ratios
  /// @throws InvalidInput for places that do not rise, values or errors that are not finite or too few, grids of
  ///         different ranges, and Beyond::law
  explicit RuleTable(RuleValues values, Beyond beyond = Beyond::error);

  /// @param speed    v_n, without its sign. @param sliding s, in the same unit. @param friction μ, 0 or more
  /// @param ratio    of a mixture; else it does not count
  /// @throws InvalidInput for what is not finite, a friction of which the table is not, and beyond the range as it says
  [[nodiscard]] Rule operator()(double speed, double sliding, double friction, double ratio = 1.0) const;

  /// The same without refusals: numbers are NaN in place of them.
  [[nodiscard]] Rule unchecked(double speed, double sliding, double friction, double ratio = 1.0) const;

  [[nodiscard]] const RuleValues& values() const;
  [[nodiscard]] Beyond beyond() const;

  /// At each place of a grid, in the order of its values: the value, then for speeds, slips and ratios, as far as there
  /// is more than one, the derivatives by ln v, z and (r − 1)/(r + 1) of all that came before.
  [[nodiscard]] const std::vector<double>& restitution_nodes() const;
  [[nodiscard]] const std::vector<double>& sliding_nodes() const;

  /// Whole error of each cell, in the order of the errors of the interpolation.
  [[nodiscard]] const std::vector<double>& restitution_errors() const;
  [[nodiscard]] const std::vector<double>& sliding_errors() const;

  /// Maximum of these errors.
  [[nodiscard]] double greatest_restitution_error() const;
  [[nodiscard]] double greatest_sliding_error() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace stoss
