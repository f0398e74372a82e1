#pragma once

#include <vector>

#include "restitution/ladder/climb.hpp"
#include "restitution/oblique_errors.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// What is asked for: as motion_along, or as oblique_restitution.
enum class Content { motion_along, all };

/// Oblique impacts for results that share them, those with one normal impact at each cutoff, or for one by itself,
/// until the error of each s′ is small enough: a problem of `climb`.
class ObliqueProblem {
 public:
  ObliqueProblem(const RefinableContact& contact, const ObliqueOptions& options, std::vector<ObliqueRestitution*> open,
                 Content content);

  Climb where;

  /// Rungs from one run to the next.
  [[nodiscard]] int between() const;

  void begin(int /*level*/) const {}
  void compute(const Contact& resolved, int level);
  int add(int level);

  /// Says of all results that are left why they have not converged.
  void conclude();

 private:
  ObliqueOptions options_;
  std::vector<ObliqueRestitution*> open_;
  Content content_;
  ObliquePlan plan_;
  bool shares_ = false;  // one normal impact
  double width_ = 0.0;   // of the contact, as known
  std::vector<ObliqueImpact> impacts_;
};

}  // namespace stoss
