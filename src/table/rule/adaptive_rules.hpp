#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "stoss/restitution/ladder.hpp"
#include "stoss/table/adaptive_rule.hpp"
#include "table/adaptive_grid.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/rule/computed_rules.hpp"

namespace stoss {

/// z of s = 9μv, from where on all slides throughout: friction changes s by (1 + ε)·7/2 μv at most.
inline constexpr double gross_slip = 0.8;

/// What speeds and ratios a table of the rule is of.
struct RuleRanges {
  AxisRange speeds, ratios;
  bool is_mixture, alike;

  [[nodiscard]] std::size_t axes() const { return is_mixture ? 3 : 2; }

  /// What the errors of values count in those of the table.
  [[nodiscard]] double weight() const {
    return table::weight_between_places * (is_mixture ? table::weight_between_places : 1.0);
  }
};

/// The rule at crossings of ln v, z and s, which grow until what is computed is predicted.
class AdaptiveRules {
 public:
  /// @throws NotConverged where the ways to slide leave too little of an error
  AdaptiveRules(std::function<RefinableContact(double)> contact, const RuleRanges& ranges,
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

  [[nodiscard]] double ratio(double s) const { return ranges_.is_mixture ? ranges_.ratios.ratio(s) : 1.0; }
  [[nodiscard]] std::string named(double speed, double s) const;
  const RefinableContact& contact(double s);

  /// What the ways to slide differ by at a speed and a ratio.
  [[nodiscard]] double difference(double v, double s, std::size_t quantity) const;

  /// What is left of an error beside such a difference.
  [[nodiscard]] Budget without(double error, double difference) const;
  void require_left(const char* option, double error, double difference) const;
  void set_budget();

  [[nodiscard]] std::vector<std::vector<RulePoint>> points(const std::vector<Place>& lines,
                                                           const std::vector<std::vector<RuleSlip>>& slips);

  /// Computes what is missing; beyond gross_slip it follows.
  void compute();
  void follow(const std::vector<Place>& open);

  AdaptiveGrid grid_;  ///< of q, of ε_n, and of what the ways to slide differ by in either
  std::function<RefinableContact(double)> contact_;
  RuleRanges ranges_;
  const RuleTableOptions& options_;
  Budget sliding_{}, restitution_{};
  std::map<double, RefinableContact> contacts_{};  ///< by s
};

}  // namespace stoss
