#include "relaxation/creep.hpp"

#include <algorithm>
#include <cmath>

namespace stoss {

Creep kelvin_voigt_creep(double loss_time) { return {0.0, {{1.0 / loss_time, 1.0 / loss_time}}}; }

Creep creep(const Rates& rates) {
  Creep result;
  for (const RealZero& zero : real_zeros(rates, 0.0)) result.terms.push_back({1.0 / zero.slope, zero.rate});
  return result;
}

CreepMemory::CreepMemory(const Creep& creep, double step, std::size_t size)
    : glass_(creep.glass), share_(creep.glass), elastic_(size), remembered_(size) {
  for (const auto [fluidity, rate] : creep.terms) {
    const double kept = 1.0 / (1.5 + rate * step);
    terms_.push_back(
        {fluidity * step * kept, kept, rate / fluidity, rate, std::vector<double>(size), std::vector<double>(size)});
    share_ += terms_.back().driven;
  }
}

const std::vector<double>& CreepMemory::predict() {
  std::fill(remembered_.begin(), remembered_.end(), 0.0);
  for (const Term& term : terms_) {
    for (std::size_t i = 0; i < remembered_.size(); ++i) {
      remembered_[i] += term.kept * (2.0 * term.last[i] - 0.5 * term.before[i]);
    }
  }
  return remembered_;
}

void CreepMemory::follow(const std::vector<double>& strain) {
  for (std::size_t i = 0; i < elastic_.size(); ++i) elastic_[i] = (strain[i] - remembered_[i]) / share_;
  take(elastic_);
}

void CreepMemory::take(const std::vector<double>& elastic) {
  elastic_ = elastic;
  for (Term& term : terms_) {
    for (std::size_t i = 0; i < elastic_.size(); ++i) {
      const double now = term.driven * elastic_[i] + term.kept * (2.0 * term.last[i] - 0.5 * term.before[i]);
      term.before[i] = term.last[i];
      term.last[i] = now;
    }
  }
}

void CreepMemory::fade(double time) {
  std::fill(elastic_.begin(), elastic_.end(), 0.0);
  for (Term& term : terms_) {
    const double kept = std::exp(-term.rate * time);
    for (std::size_t i = 0; i < elastic_.size(); ++i) term.last[i] *= kept, term.before[i] *= kept;
  }
}

std::vector<double> CreepMemory::crept() const {
  std::vector<double> sum = elastic_;
  for (double& each : sum) each *= glass_;
  for (const Term& term : terms_) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term.last[i];
  }
  return sum;
}

double CreepMemory::energy(const CreepMemory& stress) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < elastic_.size(); ++i) sum += 0.5 * glass_ * elastic_[i] * stress.elastic_[i];
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const Term &strains = terms_[k], &stresses = stress.terms_[k];
    for (std::size_t i = 0; i < elastic_.size(); ++i) {
      sum += 0.5 * strains.stiffness * strains.last[i] * stresses.last[i];
    }
  }
  return sum;
}

}  // namespace stoss
