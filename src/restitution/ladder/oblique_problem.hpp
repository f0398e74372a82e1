#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "restitution/ladder/central_problem.hpp"
#include "restitution/ladder/climb.hpp"
#include "restitution/oblique_errors.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// What is asked for: as motion_along, or as oblique_restitution.
enum class Content { motion_along, all };

/// Oblique impacts at one speed, of bodies in which both directions do not act on each other, with friction or all
/// without; or one impact by itself. A problem of `climb`, until the error of each s′ is small enough.
///
/// Where the normal impact is a central one, ε_n follows from the same impacts. Without friction the levels are those
/// of `restitution`. With it, s′ takes every other level and ε_n the first three of these; then its own problem says
/// which it needs, and those that s′ does not need are impacts along the normal alone. So no rule depends on the others
/// that are computed with it.
class ObliqueProblem {
 public:
  ObliqueProblem(const RefinableContact& contact, const ObliqueOptions& options,
                 const std::vector<ObliqueRestitution*>& all, Content content);

  /// Fills all results. @returns the stretch of the last contact
  double solve();

  void begin(int /*level*/) const {}
  void compute(const Contact& resolved, int level);
  int add(int level);
  int skip(int level);

 private:
  [[nodiscard]] Climb& where() { return central_ ? central_->where : own_; }
  [[nodiscard]] bool wants_normal(int level) const { return normal_is_open_ && level == next_normal_; }
  [[nodiscard]] bool wants_along(int level) const { return !open_.empty() && level == next_along_; }
  [[nodiscard]] ImpactOptions options_at(const Contact& resolved, int level) const;
  [[nodiscard]] int between() const;  // rungs, for s′
  [[nodiscard]] int next(int level);  // rungs, after one that is done
  void add_normal(int level);
  void add_along(int level);
  void give_up(const std::string& reason);  // what is open of s′
  void close_normal();

  ObliqueOptions options_;
  Climb own_;
  Content content_;
  std::vector<ObliqueRestitution*> all_, open_;  // open: s′
  std::optional<CentralProblem> central_{};
  bool normal_is_open_ = false;
  Estimate normal_{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};  // ε_n
  std::vector<ObliqueRun> normal_runs_{};
  Levels along_{};  // of s′
  int next_along_ = 0, next_normal_ = 0;
  ObliquePlan plan_{};
  bool shares_ = false;          // one normal impact, for angles with friction
  double width_ = 0.0;           // of the contact, as known
  std::string trouble_along_{};  // why the last level gave no s′
  std::vector<ObliqueImpact> impacts_{};
};

}  // namespace stoss
