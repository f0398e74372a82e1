#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "contact/edge/edge_law.hpp"
#include "contact/edge/kept_factor.hpp"
#include "contact/edge/rough_state.hpp"

namespace stoss {

/// Forces of rough nodes, W f − q = g with the law of each (EdgeLaw), from those of the step before.
///
/// Newton's method with a factor of W + diag(d), d = −dg/df, of which the rows are kept where d hardly changes. The few
/// nodes behind those, at the edge, are loose: they obey their law with what the others leave of W, which takes rounds
/// over them alone (docs/developer/derivations/faces.md).
class RoughNodes {
 public:
  explicit RoughNodes(std::shared_ptr<const FactoredCompliance> compliance);

  /// Solves for forces and the displacement W f; `closure` receives t of each node.
  /// @return whether they were found
  [[nodiscard]] bool solve(const EdgeLaw& law, const std::vector<double>& q, std::vector<double>& closure,
                           std::vector<double>& force, std::vector<double>& displacement);

  /// Forgets the last step, after which nothing touched.
  void forget() { known_ = false; }

 private:
  static constexpr std::size_t loosest = 6;  // most loose nodes
  using Loose = std::array<double, loosest>;

  [[nodiscard]] std::size_t begin(const EdgeLaw& law, const std::vector<double>& q);
  [[nodiscard]] std::size_t predict(const EdgeLaw& law);
  [[nodiscard]] bool arrange(std::size_t end);
  [[nodiscard]] bool solve_loose(Loose& change);
  [[nodiscard]] bool press_loose(const EdgeLaw& law, std::size_t end);
  [[nodiscard]] bool find(const EdgeLaw& law, const std::vector<double>& q, std::size_t end);
  void remember();

  std::shared_ptr<const FactoredCompliance> compliance_;
  KeptFactor factor_;
  RoughState state_;
  bool known_ = false;                                 // there was a step before
  std::vector<double> before_, change_, bend_, jerk_;  // t of the step before, and differences of t
  std::vector<double> displacement_, rest_, reduced_, pushed_;
  // Of the loose nodes.
  std::vector<double> remainder_;  // S, what the others leave of W
  std::size_t loose_ = 0, end_ = 0;
  std::array<Loose, loosest> block_{};
  Loose left_{}, force_before_{};
  double open_ = 0.0;  // force that their law may still move
};

}  // namespace stoss
