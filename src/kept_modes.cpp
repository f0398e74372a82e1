#include "kept_modes.hpp"

#include <algorithm>
#include <cmath>

#include "stoss/errors.hpp"

namespace stoss {

KeptModes::KeptModes(const Body& body, double step) : mass_(body.mass), step_(step), count_(mode_count(body)) {
  constexpr std::size_t lanes = 8;
  begin_.push_back(0);
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double omega = group.omega[l];
      omega_.push_back(omega);
      cosine_.push_back(std::cos(omega * step));
      sine_.push_back(std::sin(omega * step));
      radial_.push_back(group.radial[l]);
      tangential_.push_back(group.tangential[l]);
      radial_per_omega_.push_back(group.radial[l] / omega);
      tangential_per_omega_.push_back(group.tangential[l] / omega);
    }
    const std::size_t padded = (omega_.size() + lanes - 1) / lanes * lanes;
    for (auto* array : {&omega_, &cosine_}) array->resize(padded, 1.0);
    for (auto* array : {&sine_, &radial_, &tangential_, &radial_per_omega_, &tangential_per_omega_}) {
      array->resize(padded, 0.0);
    }
    size_.push_back(group.omega.size());
    begin_.push_back(padded);
  }
  a_.resize(omega_.size());
  b_.resize(omega_.size());
  energy_sum_.resize(omega_.size());
  push_.resize(body.groups.size());
  edge_.resize(body.groups.size());
}

kernels::Oscillators KeptModes::view() {
  return {a_.data(),      b_.data(),          cosine_.data(),           sine_.data(),
          radial_.data(), tangential_.data(), radial_per_omega_.data(), tangential_per_omega_.data()};
}

void KeptModes::set(const std::vector<double>& coordinate, const std::vector<double>& momentum) {
  if (coordinate.size() != count_ || momentum.size() != count_) {
    throw InvalidInput("start: got " + std::to_string(coordinate.size()) + " coordinates and " +
                       std::to_string(momentum.size()) + " momenta, allowed " + std::to_string(count_) +
                       " of each (one for every kept mode of the body)");
  }
  std::size_t mode = 0;
  for (std::size_t g = 0; g < size_.size(); ++g) {
    edge_[g] = {0.0, 0.0};
    for (std::size_t l = 0; l < size_[g]; ++l, ++mode) {
      const std::size_t k = begin_[g] + l;
      a_[k] = omega_[k] * coordinate[mode];
      b_[k] = momentum[mode] / mass_;
      edge_[g].radial += radial_[k] * coordinate[mode];
      edge_[g].tangential += tangential_[k] * coordinate[mode];
    }
  }
}

void KeptModes::load(const ContactGrid& grid, const std::vector<double>& force, std::size_t count) {
  const std::size_t stride = grid.recess.size();
  kernels::project_force(force.data(), grid.radial_shape.data(), grid.tangential_shape.data(), push_.size(), stride,
                         count, push_.data());
  const double scale = step_ / mass_;
  for (auto& push : push_) push = {push.radial * scale, push.tangential * scale};
}

double KeptModes::velocity(std::size_t group, std::size_t k) const {
  return b_[k] - 0.5 * (radial_[k] * push_[group].radial + tangential_[k] * push_[group].tangential);
}

void KeptModes::begin() {
  for (std::size_t g = 0; g < push_.size(); ++g) {
    for (std::size_t k = begin_[g]; k < begin_[g + 1]; ++k) b_[k] += b_[k] - velocity(g, k);
  }
}

void KeptModes::advance() { kernels::advance(view(), begin_.data(), push_.size(), push_.data(), edge_.data()); }

void KeptModes::add_displacement(const ContactGrid& grid, std::vector<double>& position) const {
  kernels::add_shapes(edge_.data(), grid.radial_shape.data(), grid.tangential_shape.data(), edge_.size(),
                      position.size(), position.size(), position.data());
}

void KeptModes::accumulate_energy() {
  kernels::accumulate_energy(view(), begin_.data(), push_.size(), push_.data(), energy_sum_.data());
}

double KeptModes::energy() const {
  double sum = 0.0;
  for (const double energy : energies()) sum += energy;
  return sum;
}

double KeptModes::reach(const ContactGrid& grid) const {
  const std::size_t nodes = grid.recess.size();
  const auto largest = [nodes](const std::vector<double>& shape, std::size_t group) {
    double result = 0.0;
    for (std::size_t i = 0; i < nodes; ++i) result = std::max(result, std::abs(shape[group * nodes + i]));
    return result;
  };
  double sum = 0.0;
  for (std::size_t g = 0; g < size_.size(); ++g) {
    const double radial = largest(grid.radial_shape, g);
    const double tangential = largest(grid.tangential_shape, g);
    for (std::size_t k = begin_[g]; k < begin_[g] + size_[g]; ++k) {
      sum += std::hypot(a_[k], velocity(g, k)) *
             (std::abs(radial_per_omega_[k]) * radial + std::abs(tangential_per_omega_[k]) * tangential);
    }
  }
  return sum;
}

template <typename Value>
std::vector<double> KeptModes::collect(Value value) const {
  std::vector<double> result;
  result.reserve(count_);
  for (std::size_t g = 0; g < size_.size(); ++g) {
    for (std::size_t k = begin_[g]; k < begin_[g] + size_[g]; ++k) result.push_back(value(g, k));
  }
  return result;
}

std::vector<double> KeptModes::coordinate() const {
  return collect([this](std::size_t, std::size_t k) { return a_[k] / omega_[k]; });
}

std::vector<double> KeptModes::momentum() const {
  return collect([this](std::size_t g, std::size_t k) { return mass_ * velocity(g, k); });
}

std::vector<double> KeptModes::energies() const {
  return collect([this](std::size_t g, std::size_t k) {
    const double v = velocity(g, k);
    return 0.5 * mass_ * (a_[k] * a_[k] + v * v);
  });
}

std::vector<double> KeptModes::accumulated_energy() const {
  return collect([this](std::size_t, std::size_t k) { return 0.5 * mass_ * energy_sum_[k]; });
}

}  // namespace stoss
