#include "impact/kept_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/damped_oscillator.hpp"
#include "stoss/errors.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

KeptModes::KeptModes(std::shared_ptr<const ModeTables> tables)
    : tables_(std::move(tables)),
      a_(tables_->begin.back()),
      b_(tables_->begin.back()),
      energy_sum_(tables_->begin.back()),
      decays_(tables_->lossy.kept.size()),
      lost_(tables_->loses() ? tables_->blocks() * kernels::lanes : 0),
      push_(2 * tables_->blocks() * kernels::lanes),
      edge_(push_.size()),
      amplitude_(tables_->rows),
      moved_(tables_->nodes) {}

KeptModes::KeptModes(const Contact& contact, const ContactGrid& grid, double step, Kicks kicks)
    : KeptModes(std::make_shared<const ModeTables>(contact, grid, step, kicks)) {}

kernels::Oscillators KeptModes::view() {
  return {
      a_.data(), b_.data(), tables_->cosine.data(), tables_->sine.data(), tables_->upper.data(), tables_->lower.data()};
}

void KeptModes::set(const std::vector<double>& coordinate, const std::vector<double>& momentum) {
  if (coordinate.size() != tables_->count || momentum.size() != tables_->count) {
    throw InvalidInput::out_of_range(
        "start", std::to_string(coordinate.size()) + " coordinates and " + std::to_string(momentum.size()) + " momenta",
        std::to_string(tables_->count) + " of each", "one for every kept mode of the body");
  }
  std::size_t mode = 0;
  for (std::size_t g = 0; g < tables_->size.size(); ++g) {
    double upper = 0.0;
    double lower = 0.0;
    for (std::size_t l = 0; l < tables_->size[g]; ++l, ++mode) {
      const std::size_t k = tables_->position(g, l);
      a_[k] = std::sqrt(tables_->omega[k]) * (coordinate[mode] / tables_->amplitude_of[g]);
      b_[k] = momentum[mode] * tables_->amplitude_of[g] / (tables_->mass * std::sqrt(tables_->omega[k]));
      if (tables_->loses())
        b_[k] *= tables_->omega[k] / tables_->lossy.speed[k];  // of long standing: its decays are over
      upper += tables_->upper[k] * a_[k];
      lower += tables_->lower[k] * a_[k];
    }
    edge_[g] = upper;
    edge_[push_.size() / 2 + g] = lower;
  }
}

void KeptModes::load(const std::vector<double>& force, std::size_t count) {
  kernels::multiply_transposed(tables_->shapes_by_node.data(), amplitude_.size(), count, 0, amplitude_.size(),
                               force.data(), amplitude_.data());
  for (const auto [at, row, length] : tables_->runs) {
    kernels::scale(tables_->step / tables_->mass, amplitude_.data() + row, length, push_.data() + at);
  }
}

double KeptModes::kick(std::size_t group, std::size_t k) const {
  return tables_->upper[k] * push_[group] + tables_->lower[k] * push_[push_.size() / 2 + group];
}

double KeptModes::displacement(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  double sum = a_[k];
  for (std::size_t j = 0; tables_->loses() && j < tables_->lossy.mode[k].rate.size(); ++j) {
    sum += decays_[tables_->decay(group, index, j)];
  }
  return sum;
}

double KeptModes::velocity(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  if (!tables_->loses()) return b_[k] - 0.5 * kick(group, k);
  return velocity_before(group, index) - 0.5 * kick(group, k);
}

double KeptModes::velocity_before(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  double sum = tables_->lossy.speed[k] * b_[k];
  for (std::size_t j = 0; j < tables_->lossy.mode[k].rate.size(); ++j) {
    const std::size_t at = tables_->decay(group, index, j);
    sum -= tables_->lossy.decay_rate[at] * decays_[at];
  }
  return sum / tables_->omega[k];
}

void KeptModes::begin() {
  for (std::size_t g = 0; g < tables_->size.size(); ++g) {
    for (std::size_t l = 0; l < tables_->size[g]; ++l) {
      const std::size_t k = tables_->position(g, l);
      if (!tables_->loses()) {
        b_[k] += b_[k] - velocity(g, l);
        continue;
      }
      const double half = 0.5 * kick(g, k);
      a_[k] += tables_->lossy.place[k] * half;
      b_[k] += tables_->lossy.jump[k] * half;
      for (std::size_t j = 0; j < tables_->lossy.mode[k].rate.size(); ++j) {
        const std::size_t at = tables_->decay(g, l, j);
        decays_[at] += tables_->lossy.residue[at] * half;
      }
    }
    if (tables_->loses()) lost_[g] = -lost_now(g);
  }
}

void KeptModes::advance() {
  if (!tables_->loses()) {
    kernels::advance(view(), tables_->begin.data(), tables_->blocks(), push_.data(), edge_.data());
    return;
  }
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
  for (std::size_t g = block * kernels::lanes; g < end; ++g) lost_[g] += work_due(g, 1.0);
}

double KeptModes::work_due(std::size_t group, double share) const {
  const ModeTables::Lossy::Due& its = tables_->lossy.work_due[group];
  const double up = share * push_[group], low = share * push_[push_.size() / 2 + group];
  return its.upper * up * up + 2.0 * its.mixed * up * low + its.lower * low * low;
}

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

void KeptModes::add_displacement(std::vector<double>& position) {
  std::fill(amplitude_.begin(), amplitude_.end(), 0.0);
  for (const auto [at, row, length] : tables_->runs) {
    double* const sums = amplitude_.data() + row;
    kernels::add(sums, edge_.data() + at, length, sums);
  }
  kernels::multiply_transposed(tables_->shapes.data(), tables_->nodes, tables_->shapes.size() / tables_->nodes, 0,
                               tables_->nodes, amplitude_.data(), moved_.data());
  kernels::add(position.data(), moved_.data(), tables_->nodes, position.data());
}

void KeptModes::accumulate_energy() {
  kernels::accumulate_energy(view(), tables_->begin.data(), tables_->blocks(), push_.data(), energy_sum_.data());
}

double KeptModes::energy() const {
  double sum = 0.0;
  for (const double energy : energies()) sum += energy;
  return sum;
}

double KeptModes::energy_of(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  const double omega = tables_->omega[k];
  if (!tables_->loses()) {
    const double v = velocity(group, index);
    return 0.5 * tables_->mass * omega * (a_[k] * a_[k] + v * v);
  }
  const LossyOscillator& mode = tables_->lossy.mode[k];
  std::vector<double> decaying(mode.rate.size());
  for (std::size_t j = 0; j < decaying.size(); ++j) decaying[j] = decays_[tables_->decay(group, index, j)];
  // b counts omega times in velocities, as a in displacements.
  return tables_->mass / omega *
         mode.energy(tables_->rates_of(group), a_[k], mode.frequency * b_[k], decaying, omega * kick(group, k));
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

/// Σ weight(ω) |A| over the modes that stay, with the largest displacement that each has at the nodes begin … end − 1.
template <typename Weight>
double KeptModes::sum_of_amplitudes(std::size_t begin, std::size_t end, Weight weight) const {
  const auto greatest = [this, begin, end](std::size_t row) {
    double result = 0.0;
    for (std::size_t i = begin; i < end; ++i)
      result = std::max(result, std::abs(tables_->shapes[row * tables_->nodes + i]));
    return result;
  };
  double sum = 0.0;
  for (std::size_t g = 0; g < tables_->lasting_groups; ++g) {
    const double upper = greatest(tables_->shapes_of[g].upper);
    const double lower = greatest(tables_->shapes_of[g].lower);
    for (std::size_t l = 0; l < tables_->size[g]; ++l) {
      const std::size_t k = tables_->position(g, l);
      const double a = displacement(g, l), v = velocity(g, l), amplitude = std::sqrt(a * a + v * v);
      sum += weight(tables_->omega[k]) * amplitude *
             (std::abs(tables_->upper[k]) * upper + std::abs(tables_->lower[k]) * lower);
    }
  }
  return sum;
}

double KeptModes::reach(std::size_t begin, std::size_t end) const {
  return sum_of_amplitudes(begin, end, [](double) { return 1.0; });
}

double KeptModes::greatest_acceleration() const {
  return sum_of_amplitudes(0, tables_->nodes, [](double omega) { return omega * omega; });
}

double KeptModes::waves_later(double time) const {
  double sum = 0.0;
  for (std::size_t g = tables_->lasting_groups; g < tables_->size.size(); ++g) {
    double upper = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < tables_->size[g]; ++l) {
      const std::size_t k = tables_->position(g, l);
      const double moved = displacement_later(g, l, time);
      upper += tables_->upper[k] * moved;
      lower += tables_->lower[k] * moved;
    }
    sum += upper * tables_->shapes[tables_->shapes_of[g].upper * tables_->nodes] +
           lower * tables_->shapes[tables_->shapes_of[g].lower * tables_->nodes];
  }
  return sum;
}

/// In free motion, after the half of the kick that is due.
double KeptModes::displacement_later(std::size_t group, std::size_t index, double time) const {
  const std::size_t k = tables_->position(group, index);
  if (!tables_->loses()) {
    const double phase = tables_->omega[k] * time;
    return a_[k] * std::cos(phase) + velocity(group, index) * std::sin(phase);
  }
  const ModeTables::Lossy& its = tables_->lossy;
  const double half = 0.5 * kick(group, k);
  const auto [kept, coupling, slowed] = numeric::damped_motion(its.mode[k].frequency, its.mode[k].gamma, time);
  double moved = (a_[k] - its.place[k] * half) * kept + (b_[k] - its.jump[k] * half) * coupling;
  for (std::size_t j = 0; j < its.mode[k].rate.size(); ++j) {
    const std::size_t at = tables_->decay(group, index, j);
    moved += (decays_[at] - its.residue[at] * half) * std::exp(-its.mode[k].rate[j] * time);
  }
  return moved;
}

template <typename Value>
std::vector<double> KeptModes::collect(Value value) const {
  std::vector<double> result;
  result.reserve(tables_->count);
  for (std::size_t g = 0; g < tables_->size.size(); ++g) {
    for (std::size_t l = 0; l < tables_->size[g]; ++l) result.push_back(value(g, l));
  }
  return result;
}

std::vector<double> KeptModes::coordinate() const {
  return collect([this](std::size_t g, std::size_t l) {
    return tables_->amplitude_of[g] * displacement(g, l) / std::sqrt(tables_->omega[tables_->position(g, l)]);
  });
}

std::vector<double> KeptModes::momentum() const {
  return collect([this](std::size_t g, std::size_t l) {
    return tables_->mass / tables_->amplitude_of[g] * std::sqrt(tables_->omega[tables_->position(g, l)]) *
           velocity(g, l);
  });
}

std::vector<double> KeptModes::energies() const {
  return collect([this](std::size_t g, std::size_t l) { return energy_of(g, l); });
}

std::vector<double> KeptModes::accumulated_energy() const {
  return collect([this](std::size_t g, std::size_t l) {
    const std::size_t k = tables_->position(g, l);
    return 0.5 * tables_->mass * tables_->omega[k] * energy_sum_[k];
  });
}

}  // namespace stoss
