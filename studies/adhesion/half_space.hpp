#pragma once

#include <Eigen/Core>
#include <vector>

#include "law.hpp"

namespace adhesion_study {

/// A paraboloid and an elastic half-space, R = E* = w = 1, on rings of equal width: gap = r²/2 − approach + (U p)(r),
/// where U has the exact displacements under uniform pressure on each ring, read at its middle.
class Rings {
 public:
  Rings(Law law, double radius, int count);

  [[nodiscard]] Eigen::Index count() const { return radius_.size(); }
  /// Gaps where nothing acts.
  [[nodiscard]] Eigen::VectorXd undeformed(double innermost) const {
    return 0.5 * (radius_.cwiseAbs2().array() - radius_[0] * radius_[0]) + innermost;
  }
  [[nodiscard]] double force(const Eigen::VectorXd& gap) const;
  /// Energy of the law and of the half-space: its derivative with respect to the approach is the force.
  [[nodiscard]] double energy(const Eigen::VectorXd& gap) const;
  /// Finds the gaps and the approach at the gap on the innermost ring, from a guess of both.
  /// @returns whether Newton's iteration converges
  [[nodiscard]] bool solve(double innermost, Eigen::VectorXd& gap, double& approach) const;

 private:
  Law law_;
  Eigen::VectorXd radius_, area_;
  Eigen::MatrixXd compliance_;
};

/// A point of the curve of equilibria, whose parameter is the gap on the innermost ring.
struct Equilibrium {
  double innermost, approach, force, energy;
};

/// All of the curve from far away to an approach, past both folds.
/// @throws std::runtime_error where it cannot be followed
[[nodiscard]] std::vector<Equilibrium> curve(const Rings& rings, double start, double last_approach, double step);

/// What the curve says: forces in wR, lengths in (w²R/E*²)^{1/3}, work in (w⁵R⁴/E*²)^{1/3}.
struct Static {
  double pull_off;  ///< greatest pull
  double jump_in;   ///< approach at which the gap closes by itself, 0 without jumps
  double jump_out;  ///< approach at which it opens
  double work;      ///< taken by both jumps if the approach is prescribed
};

[[nodiscard]] Static read(const std::vector<Equilibrium>& curve);

/// All of that for the exponential law of a Tabor number, on so many rings over a region that is wide enough.
[[nodiscard]] Static exponential_statics(double tabor, int rings, double ratio = 0.5);

/// The same for Lennard-Jones' law.
[[nodiscard]] Static lennard_jones_statics(double tabor, int rings);

}  // namespace adhesion_study
