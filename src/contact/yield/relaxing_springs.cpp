#include "contact/yield/relaxing_springs.hpp"

#include <algorithm>
#include <cstddef>

namespace stoss {

RelaxingSprings::RelaxingSprings(const RelaxingStep& answers, double widest) {
  if (!answers.relaxes()) return;
  constexpr int springs = 48;
  constexpr double margin = 1.05;
  for (int i = 0; i < springs; ++i) {
    const double place = margin * widest * (i + 0.5) / springs;
    square_.push_back(place * place);
  }
  springs_.resize(springs, answers.none());
}

double RelaxingSprings::move(const RelaxingStep& answers, double depth, double radius) {
  double force = 0.0, elastic = 0.0;
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const double compression = depth - square_[i] / radius, missing = answers.missing(springs_[i]);
    const double its = compression > 0.0 ? std::max(0.0, answers.answer() * compression - missing) : 0.0;
    // A free spring recovers.
    answers.keep(springs_[i], its > 0.0 ? compression : std::max(0.0, missing / answers.answer()));
    force += its;
    elastic += std::max(0.0, compression);
  }
  return elastic > 0.0 ? force / elastic : 0.0;
}

}  // namespace stoss
