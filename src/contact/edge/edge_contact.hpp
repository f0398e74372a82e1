#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "contact/edge/compliance.hpp"
#include "contact/edge/edge_law.hpp"
#include "contact/edge/edge_newton.hpp"
#include "contact/edge/rough_nodes.hpp"

namespace stoss {

/// The contact problem at one instant, for a symmetric positive definite compliance W and positions q: the forces f and
/// gaps g = W f − q that obey the edge law; for a single point, f ≥ 0, g ≥ 0, f g = 0. It has exactly one solution.
///
/// Nearly always the first k nodes are rigid (f ≥ f*, g = 0), and of the others only the next three feel the law. With
/// W = L Lᵀ these have the compliance L_zz L_zzᵀ and the position L_zz (L⁻¹q)_z: Newton's method in three variables
/// between the two products with triangles that a contact without law needs too.
class EdgeContact {
 public:
  /// @throws NotConverged if the matrix W is not positive definite
  EdgeContact(std::vector<double> matrix, EdgeLaw law, std::size_t size, const Poll& poll);
  EdgeContact(std::shared_ptr<const FactoredCompliance> compliance, EdgeLaw law, Poll poll);

  /// Solves for f and the displacement W f; both have `size` elements.
  /// @throws NotConverged if q is not finite, or no forces obey the law to rounding
  void solve(const std::vector<double>& q, std::vector<double>& force, std::vector<double>& displacement);

  /// Whether no node feels a force at these positions, with nothing else that moves it.
  /// @throws NotConverged if q is not finite
  [[nodiscard]] bool is_clear(const std::vector<double>& q) const { return closeness(q) == 0.0; }

  /// Tells the law of a lossy contact how the foremost node has moved in a step, before it is solved.
  void follow(double before, double now, double step);

  /// Whether asperities are long enough to be felt.
  [[nodiscard]] bool is_rough() const { return law_.asperities > 0.0; }

  /// Number of leading nodes beyond which the last force vanishes.
  [[nodiscard]] std::size_t extent() const { return extent_; }

  /// Gap of a node within the extent, as the law has it.
  [[nodiscard]] double gap(std::size_t i) const { return law_.gap.empty() ? 0.0 : law_.gap_at(i, closure_[i]); }

  /// Half-width of the last contact in spacings: nodes count as far as they are closed.
  [[nodiscard]] double half_width() const;

  /// Whether it reaches the last node; of asperities, with a pressure that matters.
  [[nodiscard]] bool overflows() const;

  /// Energy ½ fᵀW f of the compliance and that of the law, whose gradient in q is the last f.
  [[nodiscard]] double energy(const std::vector<double>& force, const std::vector<double>& displacement) const;

  /// That of the law alone.
  [[nodiscard]] double law_energy(const std::vector<double>& force) const;

  /// Distance in front of first contact from which an unexcited body feels the law.
  [[nodiscard]] double range(const std::vector<double>& recess) const { return law_.range(recess); }

 private:
  bool solve_edge(const std::vector<double>& q, double tolerance, std::vector<double>& force,
                  std::vector<double>& displacement);
  bool solve_rough(const std::vector<double>& q, std::vector<double>& force, std::vector<double>& displacement);
  void solve_generally(const std::vector<double>& q, double scale, std::vector<double>& force,
                       std::vector<double>& displacement);
  void reset_closures(const std::vector<double>& q);
  void solve_point(const std::vector<double>& q, std::vector<double>& force, std::vector<double>& displacement);
  void find_zone(std::size_t rigid);
  [[nodiscard]] double closeness(const std::vector<double>& q) const;  // what positions are measured by; 0: no force

  std::shared_ptr<const FactoredCompliance> compliance_;
  EdgeLaw law_;
  Poll poll_;
  std::vector<double> inner_;        // L⁻¹ q; then Lᵀ f
  std::vector<double> closure_;      // t of each node
  std::optional<RoughNodes> rough_;  // of asperities
  EdgeZone zone_;
  bool in_zone_ = false;  // the last solution of the zone is one
  std::array<double, 3> closure_before_{};
  std::size_t rigid_ = 0;
  std::size_t extent_ = 0;
};

}  // namespace stoss
