#pragma once

#include <cstddef>
#include <optional>

#include "restitution/curvature.hpp"
#include "restitution/ladder/climb.hpp"
#include "restitution/ladder/outlook.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// The first level at which all modes of a vibration are kept. @throws InvalidInput if there is none
[[nodiscard]] int lowest_level(const RefinableContact& contact, const Vibration& vibration, const Levels& levels,
                               const Poll& poll);

/// Impacts along the normal, until the error of 1 − ε² is small enough: a problem of `climb`.
class CentralProblem {
 public:
  CentralProblem(const RefinableContact& contact, double speed, const RestitutionOptions& options);

  Climb where;

  void begin(int level) const;
  void compute(const Contact& resolved, int level);
  int add(int level);
  [[nodiscard]] int skip(int /*level*/) const { return next_.rungs; }

  /// How the impact at a level is computed, and the same with an impact that has been.
  [[nodiscard]] ImpactOptions options_at(const Contact& resolved) const;
  void take(Impact impact, int level);

  /// The last impact, and how many there were.
  [[nodiscard]] const Impact& finest() const { return result_.finest; }
  [[nodiscard]] std::size_t runs() const { return result_.runs.size(); }

  /// The result at the end of the climb. @throws RestitutionNotConverged; NotConverged without two runs
  Restitution concluded();

 private:
  /// The contact as it is at first.
  [[nodiscard]] const Contact& unstretched(int level) const;

  RestitutionOptions options_;
  CurvatureCorrection correction_;
  double order_;   // at which errors fall with the cutoff
  double energy_;  // at first, over that of the translation
  NextRun next_;
  std::optional<Reached> first_{};  // with the fewest runs that count
  Restitution result_;
};

}  // namespace stoss
