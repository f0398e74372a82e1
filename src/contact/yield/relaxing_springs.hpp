#pragma once

#include <vector>

#include "contact/yield/relaxing_step.hpp"

namespace stoss {

/// What a material that relaxes leaves of the force of a round contact, by independent springs.
///
/// A contact of half-spaces is one of springs at the places x, which are compressed by c(x) = δ − x²/R and carry no
/// tension, each by itself (the method of dimensionality reduction; V. L. Popov and M. Heß, 2015). With the force of
/// each as RelaxingStep has it the sum is that of T. C. T. Ting (1966), in growing and in shrinking contacts.
class RelaxingSprings {
 public:
  /// @param widest half-width of the contact that is expected, in the unit of places
  RelaxingSprings(const RelaxingStep& answers, double widest);

  /// Goes on by a step to springs of the compressions `depth` − x²/`radius`. @return their force over that of springs
  /// that do not relax
  double move(const RelaxingStep& answers, double depth, double radius);

 private:
  std::vector<double> square_;  // x²
  std::vector<RelaxingStep::Memory> springs_;
};

}  // namespace stoss
