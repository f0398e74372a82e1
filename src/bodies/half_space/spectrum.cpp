// The spectra are −(2x/π) Im Γ(ix + 0), as in lamb_kernel.cpp: with t = 1/x², B = (1 − 2t)² and η̂ < t < 1, t < η̂,
//
//   ρ_h = (2/π) √(1 − t) B/{(1 − ν)[B² + 16t² (t − η̂)(1 − t)]},   (2/π) √(1 − t)/{(1 − ν)[B + 4t √((η̂ − t)(1 − t))]}
//   ρ_T = (2/π)/√(1 − t).
//
// Γ_h has the same pole as Γ.
#include "bodies/half_space/spectrum.hpp"

#include <cmath>
#include <numbers>

namespace stoss::bodies::half_space {
namespace {

constexpr double two_over_pi = 2.0 / std::numbers::pi;

double normal_density(const LambKernel& kernel, double t) { return kernel.density_at(t); }

double along_density(const LambKernel& kernel, double t) {
  const double factor = two_over_pi / (1.0 - kernel.poisson) * std::sqrt(1.0 - t);
  const double bend = (1.0 - 2.0 * t) * (1.0 - 2.0 * t);
  const double pressure = t - kernel.squared_ratio;
  if (pressure > 0.0) return factor * bend / (bend * bend + 16.0 * t * t * pressure * (1.0 - t));
  return factor / (bend + 4.0 * t * std::sqrt(-pressure * (1.0 - t)));
}

double across_density(const LambKernel& /*kernel*/, double t) { return two_over_pi / std::sqrt(1.0 - t); }

}  // namespace

std::vector<Spectrum> spectra(const LambKernel& kernel, Direction direction) {
  if (direction == Direction::normal) {
    return {{1.0, kernel.rayleigh_weight, kernel.second_moment, false, normal_density}};
  }
  const double square = kernel.rayleigh_root * kernel.rayleigh_root, eta = kernel.squared_ratio;
  const double b_over_a = std::sqrt((1.0 - square) / (1.0 - eta * square));
  const double both = 2.0 - kernel.poisson;
  return {{(1.0 - kernel.poisson) / both, kernel.rayleigh_weight * b_over_a, kernel.second_moment - 0.5 * (1.0 - eta),
           false, along_density},
          {1.0 / both, 0.0, 0.5, true, across_density}};
}

}  // namespace stoss::bodies::half_space
