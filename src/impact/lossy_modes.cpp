// The kept modes of bodies that lose energy: sums of a decaying rotation and of decays (LossyOscillator).
#include <algorithm>
#include <cmath>

#include "impact/kept_modes.hpp"
#include "numeric/damped_oscillator.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

double KeptModes::velocity_before(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  double sum = tables_->lossy.speed[k] * b_[k];
  for (std::size_t j = 0; j < tables_->lossy.mode[k].rate.size(); ++j) {
    sum -= tables_->lossy.mode[k].rate[j] * decaying(group, index, j);
  }
  return sum / tables_->omega[k];
}

void KeptModes::begin_lossy(std::size_t group) {
  for (std::size_t l = 0; l < tables_->size[group]; ++l) {
    const std::size_t k = tables_->position(group, l);
    const double half = 0.5 * kick(group, k);
    a_[k] += tables_->lossy.place[k] * half;
    b_[k] += tables_->lossy.jump[k] * half;
    for (std::size_t j = 0; j < tables_->lossy.mode[k].rate.size(); ++j) {
      if (const auto at = tables_->decay(group, l, j)) decays_[*at] += tables_->lossy.residue[*at] * half;
    }
  }
  for (Push& each : common_[group])
    each.upper -= 0.5 * push_[group], each.lower -= 0.5 * push_[push_.size() / 2 + group];
  lost_[group] = -lost_now(group);
}

void KeptModes::advance_lossy() {
  for (std::size_t block = 0; block < tables_->blocks(); ++block) {
    if (tables_->relaxes(block)) {
      advance_relaxing(block);
    } else {
      kernels::advance_damped(
          view(), {tables_->lossy.velocity_cosine.data(), tables_->lossy.rate.data(), tables_->lossy.due.data()},
          tables_->begin.data(), tables_->blocks(), block, push_.data(), edge_.data(), lost_.data());
    }
  }
}

void KeptModes::advance_relaxing(std::size_t block) {
  const ModeTables::Lossy& its = tables_->lossy;
  const kernels::Relaxing relaxing{its.velocity_cosine.data(),
                                   its.place.data(),
                                   its.jump.data(),
                                   its.speed.data(),
                                   decays_.data(),
                                   its.residue.data(),
                                   its.kept.data(),
                                   its.decay_rate.data(),
                                   its.decay_begin[block],
                                   its.decay_count[block]};
  kernels::advance_relaxing(view(), relaxing, tables_->begin.data(), tables_->blocks(), block, push_.data(),
                            edge_.data(), lost_.data());
  const std::size_t end = std::min((block + 1) * kernels::lanes, tables_->size.size());
  for (std::size_t g = block * kernels::lanes; g < end; ++g) {
    lost_[g] += work_due(g, 1.0);
    advance_common(g);
  }
}

/// The decays that all modes of a group have in common: each has minus its residue times the kicks that are left.
void KeptModes::advance_common(std::size_t group) {
  const double up = push_[group], low = push_[push_.size() / 2 + group];
  double& upper_sum = edge_[group];
  double& lower_sum = edge_[edge_.size() / 2 + group];
  for (std::size_t j = 0; j < common_[group].size(); ++j) {
    const ModeTables::Lossy::Common& common = tables_->lossy.common[group][j];
    const ModeTables::Lossy::Due& residue = common.residue;
    Push& its = common_[group][j];
    const auto upper = [&] { return -(residue.upper * its.upper + residue.mixed * its.lower); };
    const auto lower = [&] { return -(residue.mixed * its.upper + residue.lower * its.lower); };
    lost_[group] += common.rate * (up * upper() + low * lower());
    its = {common.kept * (its.upper + up), common.kept * (its.lower + low)};
    upper_sum += upper(), lower_sum += lower();
  }
}

/// One of the decays of a mode.
double KeptModes::decaying(std::size_t group, std::size_t index, std::size_t number) const {
  if (const auto at = tables_->decay(group, index, number)) return decays_[*at];
  const std::size_t k = tables_->position(group, index);
  const Push& its = common_[group][number];
  const double kicks = tables_->upper[k] * its.upper + tables_->lower[k] * its.lower;
  return -tables_->omega[k] * tables_->lossy.mode[k].residue[number] * kicks;
}

double KeptModes::work_due(std::size_t group, double share) const {
  const ModeTables::Lossy::Due& its = tables_->lossy.work_due[group];
  const double up = share * push_[group], low = share * push_[push_.size() / 2 + group];
  return its.upper * up * up + 2.0 * its.mixed * up * low + its.lower * low * low;
}

double KeptModes::energy_of_lossy(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  const double omega = tables_->omega[k];
  const LossyOscillator& mode = tables_->lossy.mode[k];
  std::vector<double> decaying(mode.rate.size());
  for (std::size_t j = 0; j < decaying.size(); ++j) decaying[j] = this->decaying(group, index, j);
  // b counts omega times in velocities, as a in displacements.
  return tables_->mass / omega * mode.energy(a_[k], mode.frequency * b_[k], decaying, omega * kick(group, k));
}

KeptModes KeptModes::ringing() const {
  KeptModes made = *this;
  std::fill(made.decays_.begin(), made.decays_.end(), 0.0);
  for (std::vector<Push>& each : made.common_) std::fill(each.begin(), each.end(), Push{});
  for (std::size_t k = 0; k < tables_->lossy.mode.size(); ++k) {
    const LossyOscillator& mode = tables_->lossy.mode[k];
    if (!mode.rate.empty() && mode.gamma >= mode.frequency) made.a_[k] = made.b_[k] = 0.0;  // it creeps
  }
  return made;
}

double KeptModes::dissipated(std::size_t begin, std::size_t end) const {
  double sum = 0.0;
  for (std::size_t g = begin; g < end && tables_->loses(); ++g) sum += lost_[g] + lost_now(g);
  return tables_->mass * sum;
}

/// With half of the kick that is due, and less by the energy that modes hold which relax.
double KeptModes::lost_now(std::size_t group) const {
  const bool relaxes = tables_->relaxes(group / kernels::lanes);
  double sum = relaxes ? work_due(group, 0.5) : 0.0;
  for (std::size_t l = 0; l < tables_->size[group]; ++l) {
    const std::size_t k = tables_->position(group, l);
    const double before = velocity_before(group, l), due = kick(group, k);
    if (relaxes) {
      sum -= 0.5 * tables_->omega[k] * due * before + energy_of(group, l) / tables_->mass;
    } else {
      const double smooth = before - tables_->lossy.due[k] * due;
      sum += 0.5 * tables_->lossy.rate[k] * smooth * smooth;
    }
  }
  return sum;
}

double KeptModes::lossy_displacement_later(std::size_t group, std::size_t index, double time) const {
  const std::size_t k = tables_->position(group, index);
  const ModeTables::Lossy& its = tables_->lossy;
  const double half = 0.5 * kick(group, k);
  const auto [kept, coupling, slowed] = numeric::damped_motion(its.mode[k].frequency, its.mode[k].gamma, time);
  double moved = (a_[k] - its.place[k] * half) * kept + (b_[k] - its.jump[k] * half) * coupling;
  for (std::size_t j = 0; j < its.mode[k].rate.size(); ++j) {
    const double residue = tables_->omega[k] * its.mode[k].residue[j];
    moved += (decaying(group, index, j) - residue * half) * std::exp(-its.mode[k].rate[j] * time);
  }
  return moved;
}

}  // namespace stoss
