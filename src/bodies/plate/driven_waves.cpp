#include "bodies/plate/driven_waves.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "numeric/multiversion.hpp"

namespace stoss::bodies::plate {
namespace {

using Phasor = std::complex<double>;

/// ∫₀¹ x e^{iθx} dx and ∫₀¹ (1 − x) e^{iθx} dx
struct Shares {
  Phasor rising, falling;
};

Shares shares(double theta) {
  constexpr double small = 1.0;
  const Phasor i{0.0, 1.0};
  if (theta < small) {
    constexpr int order = 20;
    Phasor power = 1.0;  // (iθ)ⁿ/n!
    Shares sum{};
    for (int n = 0; n < order; ++n) {
      sum.rising += power / (n + 2.0);
      sum.falling += power / ((n + 1.0) * (n + 2.0));
      power *= i * theta / (n + 1.0);
    }
    return sum;
  }
  const Phasor turned = std::polar(1.0, theta), whole = (turned - 1.0) / (i * theta);
  const Phasor rising = turned / (i * theta) + (turned - 1.0) / (theta * theta);
  return {rising, whole - rising};
}

STOSS_MULTIVERSION void step(std::size_t count, const double* turn_cos, const double* turn_sin, const double* first_cos,
                             const double* first_sin, const double* next_cos, const double* next_sin, double now,
                             double next, double* real, double* imaginary) {
  for (std::size_t l = 0; l < count; ++l) {
    const double before = real[l];
    real[l] = turn_cos[l] * before - turn_sin[l] * imaginary[l] + first_cos[l] * now + next_cos[l] * next;
    imaginary[l] = turn_sin[l] * before + turn_cos[l] * imaginary[l] + first_sin[l] * now + next_sin[l] * next;
  }
}

STOSS_MULTIVERSION void turn(std::size_t count, const double* turn_cos, const double* turn_sin, double* real,
                             double* imaginary) {
  for (std::size_t l = 0; l < count; ++l) {
    const double before = real[l];
    real[l] = turn_cos[l] * before - turn_sin[l] * imaginary[l];
    imaginary[l] = turn_sin[l] * before + turn_cos[l] * imaginary[l];
  }
}

/// Σ weight · value in four sums that are added at the end.
STOSS_MULTIVERSION double product(std::size_t count, const double* weight, const double* value) {
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> sum{};
  std::size_t l = 0;
  for (; l + lanes <= count; l += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) sum[lane] += weight[l + lane] * value[l + lane];
  }
  for (; l < count; ++l) sum[0] += weight[l] * value[l];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

void DrivenWaves::add(double omega, double normal, double radial, double slow) {
  const auto weigh = [&](Weights& its, double share) {
    its.normal.push_back(share * normal / omega), its.radial.push_back(share * radial / omega);
    its.normal_rate.push_back(share * normal), its.radial_rate.push_back(share * radial);
  };
  weigh(fast_, 1.0 - slow), weigh(left_, slow);
  const double follows = slow / (omega * omega);
  fast_.slow[0] += follows * normal, fast_.slow[1] += follows * radial;
  left_.slow[0] -= follows * normal, left_.slow[1] -= follows * radial;
  const double h = instants_.step, theta = omega * h;
  turn_cos_.push_back(std::cos(theta)), turn_sin_.push_back(std::sin(theta));
  const double stride = theta * static_cast<double>(instants_.stride);
  stride_cos_.push_back(std::cos(stride)), stride_sin_.push_back(std::sin(stride));
  const Shares its = shares(theta);
  first_cos_.push_back(h * its.rising.real()), first_sin_.push_back(h * its.rising.imag());
  next_cos_.push_back(h * its.falling.real()), next_sin_.push_back(h * its.falling.imag());
}

void DrivenWaves::add(Motion& motion, std::size_t output, const std::array<double, 4>& moved) {
  motion.normal[output] += moved[0], motion.radial[output] += moved[1];
  motion.normal_velocity[output] += moved[2], motion.radial_velocity[output] += moved[3];
}

std::array<double, 4> DrivenWaves::sums(const Weights& weights, const std::vector<double>& real,
                                        const std::vector<double>& imaginary) const {
  const std::size_t count = real.size();
  return {
      product(count, weights.normal.data(), imaginary.data()), product(count, weights.radial.data(), imaginary.data()),
      product(count, weights.normal_rate.data(), real.data()), product(count, weights.radial_rate.data(), real.data())};
}

void DrivenWaves::move(const std::vector<double>& force, Motion& motion, Motion* left) const {
  const std::size_t count = turn_cos_.size(), before = instants_.before, stride = instants_.stride;
  std::vector<double> real(count, 0.0), imaginary(count, 0.0);
  const auto show = [&](const Weights& weights, Motion& to, std::size_t output, double now, double slope) {
    std::array<double, 4> its = sums(weights, real, imaginary);
    its[0] += now * weights.slow[0], its[1] += now * weights.slow[1];
    its[2] += slope * weights.slow[0], its[3] += slope * weights.slow[1];
    add(to, output, its);
  };
  const auto show_all = [&](std::size_t output, double now, double slope) {
    show(fast_, motion, output, now, slope);
    if (left != nullptr) show(left_, *left, output, now, slope);
  };
  std::size_t output = 0, j = 0;
  for (; j + 1 < force.size() && output < instants_.outputs; ++j) {
    if (j == output * stride + before) {
      show_all(output++, force[j], j > 0 ? 0.5 * (force[j + 1] - force[j - 1]) / instants_.step : 0.0);
    }
    step(count, turn_cos_.data(), turn_sin_.data(), first_cos_.data(), first_sin_.data(), next_cos_.data(),
         next_sin_.data(), force[j], force[j + 1], real.data(), imaginary.data());
  }
  // Without a force to the next instant, step by step, then from one to the next.
  for (; output < instants_.outputs && j < output * stride + before; ++j) {
    turn(count, turn_cos_.data(), turn_sin_.data(), real.data(), imaginary.data());
  }
  for (; output < instants_.outputs; ++output) {
    show_all(output, 0.0, 0.0);
    turn(count, stride_cos_.data(), stride_sin_.data(), real.data(), imaginary.data());
  }
}

}  // namespace stoss::bodies::plate
