#pragma once

#include <cstddef>
#include <vector>

#include "contact/edge/compliance.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// The contact problem at one instant, for a symmetric positive definite compliance W and positions q:
///
///   f ≥ 0,   g = W f − q ≥ 0,   fᵀ g = 0.
///
/// It has exactly one solution: static contact. A contact that is an interval {0 … k−1} costs two products with
/// triangular matrices. Any other contact set is found by block principal pivoting with Murty's rule as the finite last
/// resort (Júdice and Pires, Comput. Oper. Res. 21, 587, 1994).
class Complementarity {
 public:
  /// @param matrix W, row-major, size × size
  /// @throws NotConverged if W is not positive definite
  Complementarity(std::vector<double> matrix, std::size_t size, Poll poll = {});

  /// Solves for f and the displacement W f; both have `size` elements. f is exactly zero outside the contact set, and
  /// no g is below −1e-13 max q.
  /// @throws NotConverged if no contact set satisfies the conditions to rounding
  void solve(const std::vector<double>& q, std::vector<double>& force, std::vector<double>& displacement);

  /// Number of leading nodes beyond which the last force vanishes.
  [[nodiscard]] std::size_t extent() const { return extent_; }

 private:
  /// The forces on the first `count` nodes that bring them to q; those behind are void.
  void solve_leading(std::size_t count, const std::vector<double>& q, std::vector<double>& force);
  bool solve_interval(const std::vector<double>& q, double tolerance, std::vector<double>& force,
                      std::vector<double>& displacement);
  void solve_any(const std::vector<double>& q, double tolerance, std::vector<double>& force,
                 std::vector<double>& displacement);
  void solve_on_set(const std::vector<std::size_t>& set, const std::vector<double>& q, std::vector<double>& force,
                    std::vector<double>& displacement) const;

  FactoredCompliance compliance_;
  std::vector<double> inner_;  // L⁻¹ q
  std::size_t extent_ = 0;
  Poll poll_;
};

}  // namespace stoss
