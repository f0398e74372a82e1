#include "contact/yield/relaxing_step.hpp"

#include <cmath>
#include <cstddef>

#include "contact/touch.hpp"

namespace stoss {

RelaxingStep::RelaxingStep(const Contact& contact, double step) : lag_(touch(contact).loss_time / step) {
  for (const RelaxingBody& body : relaxing_bodies(contact)) {
    for (const RelaxationTerm& term : body.relaxation.terms) {
      const double steps = step / term.time, kept = std::exp(-steps), mean = -std::expm1(-steps) / steps;
      branches_.push_back({body.share * term.share, kept, mean - kept, 1.0 - mean});
      answer_ -= branches_.back().share * branches_.back().end;
    }
  }
  answer_ += lag_;
}

double RelaxingStep::missing(const Memory& memory) const {
  double sum = lag_ * memory.before;
  for (std::size_t j = 0; j < branches_.size(); ++j) {
    sum += branches_[j].share * (branches_[j].kept * memory.relaxed[j] + branches_[j].begin * memory.before);
  }
  return sum;
}

void RelaxingStep::keep(Memory& memory, double now) const {
  for (std::size_t j = 0; j < branches_.size(); ++j) {
    const Branch& its = branches_[j];
    memory.relaxed[j] = its.kept * memory.relaxed[j] + its.begin * memory.before + its.end * now;
  }
  memory.before = now;
}

}  // namespace stoss
