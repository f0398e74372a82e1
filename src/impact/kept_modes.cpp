#include "impact/kept_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stoss/errors.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

KeptModes::KeptModes(std::shared_ptr<const ModeTables> tables)
    : tables_(std::move(tables)),
      a_(tables_->begin.back()),
      b_(tables_->begin.back()),
      energy_sum_(tables_->begin.back()),
      decays_(tables_->lossy.kept.size()),
      common_(tables_->lossy.common.size()),
      lost_(tables_->loses() ? tables_->blocks() * kernels::lanes : 0),
      push_(2 * tables_->blocks() * kernels::lanes),
      edge_(push_.size()),
      amplitude_(tables_->rows),
      moved_(tables_->nodes) {
  for (std::size_t g = 0; g < common_.size(); ++g) common_[g].resize(tables_->lossy.common[g].size());
}

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
    sum += decaying(group, index, j);
  }
  return sum;
}

double KeptModes::velocity(std::size_t group, std::size_t index) const {
  const std::size_t k = tables_->position(group, index);
  if (!tables_->loses()) return b_[k] - 0.5 * kick(group, k);
  return velocity_before(group, index) - 0.5 * kick(group, k);
}

void KeptModes::begin() {
  for (std::size_t g = 0; g < tables_->size.size(); ++g) {
    if (tables_->loses()) {
      begin_lossy(g);
      continue;
    }
    for (std::size_t l = 0; l < tables_->size[g]; ++l) {
      const std::size_t k = tables_->position(g, l);
      b_[k] += b_[k] - velocity(g, l);
    }
  }
}

void KeptModes::advance() {
  if (tables_->loses()) return advance_lossy();
  kernels::advance(view(), tables_->begin.data(), tables_->blocks(), push_.data(), edge_.data());
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
  if (tables_->loses()) return energy_of_lossy(group, index);
  const std::size_t k = tables_->position(group, index);
  const double v = velocity(group, index);
  return 0.5 * tables_->mass * tables_->omega[k] * (a_[k] * a_[k] + v * v);
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
  if (tables_->loses()) return lossy_displacement_later(group, index, time);
  const std::size_t k = tables_->position(group, index);
  const double phase = tables_->omega[k] * time;
  return a_[k] * std::cos(phase) + velocity(group, index) * std::sin(phase);
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
