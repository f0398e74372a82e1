// Kept modes that no force kicks: in other steps, and moved by any time at once.
#include <cmath>

#include "impact/kept_modes.hpp"
#include "numeric/damped_oscillator.hpp"

namespace stoss {

KeptModes KeptModes::in_flight(std::shared_ptr<const ModeTables> steps) const {
  KeptModes flight(std::move(steps));
  flight.a_ = a_;
  flight.edge_ = edge_;
  for (std::size_t g = 0; g < tables_->size.size(); ++g) {
    for (std::size_t l = 0; l < tables_->size[g]; ++l) {
      const std::size_t k = tables_->position(g, l);
      flight.b_[k] = velocity(g, l);
    }
  }
  return flight;
}

void KeptModes::fly(double time) {
  const bool loses = tables_->loses();
  for (std::size_t g = 0; g < tables_->size.size(); ++g) {
    const auto held = [&] {  // that it has and has lost, over the mass
      double sum = loses ? lost_now(g) : 0.0;
      for (std::size_t l = 0; loses && l < tables_->size[g]; ++l) sum += energy_of(g, l) / tables_->mass;
      return sum;
    };
    const double before = held();
    for (std::size_t l = 0; l < tables_->size[g]; ++l) rotate(g, l, time);
    if (loses) {
      fade(g, time);
      lost_[g] += before - held();
    }
    double upper = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < tables_->size[g]; ++l) {
      const std::size_t k = tables_->position(g, l);
      const double moved = displacement(g, l);
      upper += tables_->upper[k] * moved;
      lower += tables_->lower[k] * moved;
    }
    edge_[g] = upper;
    edge_[push_.size() / 2 + g] = lower;
  }
}

void KeptModes::rotate(std::size_t group, std::size_t index, double time) {
  const std::size_t k = tables_->position(group, index);
  const double a = a_[k], b = b_[k];
  if (tables_->loses()) {
    const LossyOscillator& mode = tables_->lossy.mode[k];
    const auto [kept, coupling, slowed] = numeric::damped_motion(mode.frequency, mode.gamma, time);
    a_[k] = a * kept + b * coupling;
    b_[k] = b * slowed - a * coupling;
  } else {
    const double angle = tables_->omega[k] * time, cosine = std::cos(angle), sine = std::sin(angle);
    a_[k] = a * cosine + b * sine;
    b_[k] = b * cosine - a * sine;
  }
}

void KeptModes::fade(std::size_t group, double time) {
  const ModeTables::Lossy& its = tables_->lossy;
  for (std::size_t l = 0; l < tables_->size[group]; ++l) {
    const std::size_t k = tables_->position(group, l);
    for (std::size_t j = 0; j < its.mode[k].rate.size(); ++j) {
      if (const auto at = tables_->decay(group, l, j)) decays_[*at] *= std::exp(-its.decay_rate[*at] * time);
    }
  }
  for (std::size_t j = 0; j < common_[group].size(); ++j) {
    const double kept = std::exp(-its.common[group][j].rate * time);
    common_[group][j].upper *= kept, common_[group][j].lower *= kept;
  }
}

}  // namespace stoss
