#pragma once

#include <functional>
#include <vector>

#include "stoss/restitution/ladder.hpp"
#include "stoss/table/adaptive_rule.hpp"
#include "table/adaptive_grid.hpp"
#include "table/axes.hpp"
#include "table/rule/computed_rules.hpp"

namespace stoss {

/// z of s = 9μv, from where on all slides throughout: friction changes s by (1 + ε)·7/2 μv at most.
inline constexpr double gross_slip = 0.8;

/// The rule at crossings of ln v, z and s, which grow until what is computed is predicted.
class AdaptiveRules {
 public:
  /// @throws NotConverged where the ways to slide leave too little of an error
  AdaptiveRules(std::function<RefinableContact(double)> contact, const TableRange& range,
                const RuleTableOptions& options);

  void refine();

  /// A quantity with what the ways to slide differ by in its errors. @param quantity 0: q, 1: ε_n where directions mix
  [[nodiscard]] TableValues values(std::size_t quantity) const;

 private:
  using Place = AdaptiveGrid::Place;

  /// Parts of an error: of each value, and of the middles along each axis.
  struct Budget {
    double values, grid;
  };

  /// What the errors of values count in those of the table.
  [[nodiscard]] double weight() const;

  /// What the ways to slide differ by at a speed and a ratio.
  [[nodiscard]] double difference(double v, double s, std::size_t quantity) const;

  /// What is left of an error beside such a difference.
  [[nodiscard]] Budget without(double error, double difference) const;
  void require_left(const char* option, double error, double difference) const;
  void set_budget();

  [[nodiscard]] std::vector<std::vector<RulePoint>> points(const std::vector<Place>& lines,
                                                           const std::vector<std::vector<RuleSlip>>& slips);

  /// Computes what is missing; beyond gross_slip it follows.
  void compute(const std::vector<Place>& open);
  void follow(const std::vector<Place>& open);

  AdaptiveGrid grid_;  ///< of q, of ε_n, and of what the ways to slide differ by in either
  TableRange range_;
  Contacts contacts_;
  const RuleTableOptions& options_;
  Budget sliding_{}, restitution_{};
};

}  // namespace stoss
