#include "impact/kept_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/damped_oscillator.hpp"
#include "numeric/stable_kicks.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

KeptModes::KeptModes(const Contact& contact, const ContactGrid& grid, double step, Kicks kicks)
    : mass_(contact.mass),
      step_(step),
      count_(mode_count(contact)),
      nodes_(grid.recess.size()),
      lasting_groups_(lasting_groups(contact)) {
  constexpr std::size_t lanes = kernels::lanes;
  const std::size_t groups = contact.groups.size();
  begin_.push_back(0);
  for (std::size_t first = 0; first < groups; first += lanes) {
    std::size_t longest = 0;
    for (std::size_t g = first; g < std::min(first + lanes, groups); ++g) {
      size_.push_back(contact.groups[g].omega.size());
      longest = std::max(longest, size_.back());
    }
    begin_.push_back(begin_.back() + longest * lanes);
  }
  // Places without a mode hold an oscillator of no amplitude.
  for (auto* array : {&omega_, &cosine_}) array->resize(begin_.back(), 1.0);
  for (auto* array : {&sine_, &upper_, &lower_, &a_, &b_, &energy_sum_}) {
    array->resize(begin_.back(), 0.0);
  }
  for (std::size_t g = 0; g < groups; ++g) {
    const ModeGroup& group = contact.groups[g];
    amplitude_of_.push_back(std::sqrt(mass_ / modal_mass(contact, g)));
    for (std::size_t l = 0; l < size_[g]; ++l) {
      const std::size_t k = position(g, l);
      const double omega = group.omega[l];
      omega_[k] = omega;
      cosine_[k] = std::cos(omega * step);
      sine_[k] = std::sin(omega * step);
      upper_[k] = group.upper[l] / std::sqrt(omega);
      lower_[k] = group.lower[l] / std::sqrt(omega);
    }
  }
  if (longest_loss_time(contact) > 0.0) damp(contact, kicks);
  push_.resize(2 * blocks() * lanes);
  edge_.resize(push_.size());
  moved_.resize(nodes_);
  const std::size_t rows = grid.shape.size() / nodes_;
  amplitude_.resize((rows + lanes - 1) / lanes * lanes);
  place_rows(contact);
  shapes_ = grid.shape;
  shapes_by_node_.resize(amplitude_.size() * nodes_);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < nodes_; ++i) shapes_by_node_[i * amplitude_.size() + row] = shapes_[row * nodes_ + i];
  }
}

void KeptModes::place_rows(const Contact& contact) {
  const auto place = [this](std::size_t at, std::size_t row) {
    if (!runs_.empty() && runs_.back().at + runs_.back().count == at && runs_.back().row + runs_.back().count == row) {
      ++runs_.back().count;
    } else {
      runs_.push_back({at, row, 1});
    }
  };
  for (std::size_t g = 0; g < size_.size(); ++g) place(g, contact.groups[g].upper_row);
  for (std::size_t g = 0; g < size_.size(); ++g) place(push_.size() / 2 + g, contact.groups[g].lower_row);
  for (const ModeGroup& group : contact.groups) shapes_of_.push_back({group.upper_row, group.lower_row});
}

void KeptModes::damp(const Contact& contact, Kicks kicks) {
  velocity_cosine_ = cosine_;
  rate_.resize(cosine_.size());
  due_.resize(cosine_.size());
  lost_.resize(blocks() * kernels::lanes);
  for (std::size_t g = 0; g < size_.size(); ++g) {
    const double loss = loss_time(contact, g);
    for (std::size_t l = 0; l < size_[g]; ++l) {
      const std::size_t k = position(g, l);
      double gamma = 0.5 * loss * omega_[k] * omega_[k];
      if (kicks == Kicks::weaker) {
        const numeric::StableKicks stable = numeric::stable_kicks(omega_[k], gamma, step_);
        gamma = stable.gamma;
        upper_[k] *= std::sqrt(stable.strength);
        lower_[k] *= std::sqrt(stable.strength);
      }
      const auto [kept, coupling, velocity] = numeric::damped_motion(omega_[k], gamma, step_);
      due_[k] = numeric::share_due(omega_[k], gamma, step_);
      rate_[k] = 2.0 * gamma * omega_[k] * step_;
      cosine_[k] = kept;
      sine_[k] = coupling;
      velocity_cosine_[k] = velocity;
    }
  }
}

std::size_t KeptModes::position(std::size_t group, std::size_t index) const {
  return begin_[group / kernels::lanes] + index * kernels::lanes + group % kernels::lanes;
}

kernels::Oscillators KeptModes::view() {
  return {a_.data(), b_.data(), cosine_.data(), sine_.data(), upper_.data(), lower_.data()};
}

void KeptModes::set(const std::vector<double>& coordinate, const std::vector<double>& momentum) {
  if (coordinate.size() != count_ || momentum.size() != count_) {
    throw InvalidInput("start: got " + std::to_string(coordinate.size()) + " coordinates and " +
                       std::to_string(momentum.size()) + " momenta, allowed " + std::to_string(count_) +
                       " of each (one for every kept mode of the body)");
  }
  std::size_t mode = 0;
  for (std::size_t g = 0; g < size_.size(); ++g) {
    double upper = 0.0;
    double lower = 0.0;
    for (std::size_t l = 0; l < size_[g]; ++l, ++mode) {
      const std::size_t k = position(g, l);
      a_[k] = std::sqrt(omega_[k]) * (coordinate[mode] / amplitude_of_[g]);
      b_[k] = momentum[mode] * amplitude_of_[g] / (mass_ * std::sqrt(omega_[k]));
      upper += upper_[k] * a_[k];
      lower += lower_[k] * a_[k];
    }
    edge_[g] = upper;
    edge_[push_.size() / 2 + g] = lower;
  }
}

void KeptModes::load(const std::vector<double>& force, std::size_t count) {
  kernels::multiply_transposed(shapes_by_node_.data(), amplitude_.size(), count, 0, amplitude_.size(), force.data(),
                               amplitude_.data());
  for (const auto [at, row, length] : runs_) {
    kernels::scale(step_ / mass_, amplitude_.data() + row, length, push_.data() + at);
  }
}

double KeptModes::velocity(std::size_t group, std::size_t k) const {
  return b_[k] - 0.5 * (upper_[k] * push_[group] + lower_[k] * push_[push_.size() / 2 + group]);
}

void KeptModes::begin() {
  for (std::size_t g = 0; g < size_.size(); ++g) {
    for (std::size_t l = 0; l < size_[g]; ++l) {
      const std::size_t k = position(g, l);
      b_[k] += b_[k] - velocity(g, k);
    }
    if (!lost_.empty()) lost_[g] = -half_power(g);
  }
}

void KeptModes::advance() {
  if (velocity_cosine_.empty()) {
    kernels::advance(view(), begin_.data(), blocks(), push_.data(), edge_.data());
  } else {
    kernels::advance_damped(view(), {velocity_cosine_.data(), rate_.data(), due_.data()}, begin_.data(), blocks(),
                            push_.data(), edge_.data(), lost_.data());
  }
}

KeptModes KeptModes::in_flight() const {
  KeptModes flight(*this);
  for (std::size_t g = 0; g < size_.size(); ++g) {
    for (std::size_t l = 0; l < size_[g]; ++l) {
      const std::size_t k = position(g, l);
      flight.b_[k] = velocity(g, k);
      for (int doubling = 0; doubling < 2; ++doubling) {
        const double cosine = flight.cosine_[k], sine = flight.sine_[k];
        flight.cosine_[k] = (cosine - sine) * (cosine + sine);
        flight.sine_[k] = 2.0 * cosine * sine;
      }
    }
  }
  flight.step_ = 4.0 * step_;
  std::fill(flight.push_.begin(), flight.push_.end(), 0.0);
  return flight;
}

void KeptModes::add_displacement(std::vector<double>& position) {
  std::fill(amplitude_.begin(), amplitude_.end(), 0.0);
  for (const auto [at, row, length] : runs_) {
    double* const sums = amplitude_.data() + row;
    kernels::add(sums, edge_.data() + at, length, sums);
  }
  kernels::multiply_transposed(shapes_.data(), nodes_, shapes_.size() / nodes_, 0, nodes_, amplitude_.data(),
                               moved_.data());
  kernels::add(position.data(), moved_.data(), nodes_, position.data());
}

void KeptModes::accumulate_energy() {
  kernels::accumulate_energy(view(), begin_.data(), blocks(), push_.data(), energy_sum_.data());
}

double KeptModes::energy() const {
  double sum = 0.0;
  for (const double energy : energies()) sum += energy;
  return sum;
}

double KeptModes::dissipated(std::size_t begin, std::size_t end) const {
  double sum = 0.0;
  for (std::size_t g = begin; g < end && !lost_.empty(); ++g) sum += lost_[g] + half_power(g);
  return mass_ * sum;
}

double KeptModes::half_power(std::size_t group) const {
  double sum = 0.0;
  for (std::size_t l = 0; l < size_[group]; ++l) {
    const std::size_t k = position(group, l);
    const double kick = upper_[k] * push_[group] + lower_[k] * push_[push_.size() / 2 + group];
    const double velocity = b_[k] - due_[k] * kick;
    sum += 0.5 * rate_[k] * velocity * velocity;
  }
  return sum;
}

/// Σ weight(ω) |A| over the modes that stay, with the largest displacement that each has at the nodes begin … end − 1.
template <typename Weight>
double KeptModes::sum_of_amplitudes(std::size_t begin, std::size_t end, Weight weight) const {
  const auto greatest = [this, begin, end](std::size_t row) {
    double result = 0.0;
    for (std::size_t i = begin; i < end; ++i) result = std::max(result, std::abs(shapes_[row * nodes_ + i]));
    return result;
  };
  double sum = 0.0;
  for (std::size_t g = 0; g < lasting_groups_; ++g) {
    const double upper = greatest(shapes_of_[g].upper);
    const double lower = greatest(shapes_of_[g].lower);
    for (std::size_t l = 0; l < size_[g]; ++l) {
      const std::size_t k = position(g, l);
      const double v = velocity(g, k);
      const double amplitude = std::sqrt(a_[k] * a_[k] + v * v);
      sum += weight(omega_[k]) * amplitude * (std::abs(upper_[k]) * upper + std::abs(lower_[k]) * lower);
    }
  }
  return sum;
}

double KeptModes::reach(std::size_t begin, std::size_t end) const {
  return sum_of_amplitudes(begin, end, [](double) { return 1.0; });
}

double KeptModes::greatest_acceleration() const {
  return sum_of_amplitudes(0, nodes_, [](double omega) { return omega * omega; });
}

double KeptModes::waves_later(double time) const {
  double sum = 0.0;
  for (std::size_t g = lasting_groups_; g < size_.size(); ++g) {
    double upper = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < size_[g]; ++l) {
      const std::size_t k = position(g, l);
      const double phase = omega_[k] * time, gamma = rate_.empty() ? 0.0 : 0.5 * rate_[k] / (omega_[k] * step_);
      const double moved = std::exp(-gamma * time) * (a_[k] * std::cos(phase) + velocity(g, k) * std::sin(phase));
      upper += upper_[k] * moved;
      lower += lower_[k] * moved;
    }
    sum += upper * shapes_[shapes_of_[g].upper * nodes_] + lower * shapes_[shapes_of_[g].lower * nodes_];
  }
  return sum;
}

template <typename Value>
std::vector<double> KeptModes::collect(Value value) const {
  std::vector<double> result;
  result.reserve(count_);
  for (std::size_t g = 0; g < size_.size(); ++g) {
    for (std::size_t l = 0; l < size_[g]; ++l) result.push_back(value(g, position(g, l)));
  }
  return result;
}

std::vector<double> KeptModes::coordinate() const {
  return collect([this](std::size_t g, std::size_t k) { return amplitude_of_[g] * a_[k] / std::sqrt(omega_[k]); });
}

std::vector<double> KeptModes::momentum() const {
  return collect([this](std::size_t g, std::size_t k) {
    return mass_ / amplitude_of_[g] * std::sqrt(omega_[k]) * velocity(g, k);
  });
}

std::vector<double> KeptModes::energies() const {
  return collect([this](std::size_t g, std::size_t k) {
    const double v = velocity(g, k);
    return 0.5 * mass_ * omega_[k] * (a_[k] * a_[k] + v * v);
  });
}

std::vector<double> KeptModes::accumulated_energy() const {
  return collect([this](std::size_t, std::size_t k) { return 0.5 * mass_ * omega_[k] * energy_sum_[k]; });
}

}  // namespace stoss
