// The spectrum of Γ is −(2x/π) Im Γ(ix + 0): with t = 1/x² and the roots a = i√(η̂x² − 1), b = i√(x² − 1) above their
// branch points
//
//   η̂ < t < 1:   ρ = (8/π) t (t − η̂) √(1 − t) / {(1 − ν)[(1 − 2t)⁴ + 16t² (t − η̂)(1 − t)]}
//   0 ≤ t < η̂:   ρ = (2/π) √(η̂ − t) / {(1 − ν)[(1 − 2t)² + 4t √((η̂ − t)(1 − t))]},
//
// and its only pole off the cuts is the root of the bracket at x < 1.
// The spectra are −(2x/π) Im Γ(ix + 0), as in lamb_kernel.cpp: with t = 1/x², B = (1 − 2t)² and η̂ < t < 1, t < η̂,
//
//   ρ_h = (2/π) √(1 − t) B/{(1 − ν)[B² + 16t² (t − η̂)(1 − t)]},   (2/π) √(1 − t)/{(1 − ν)[B + 4t √((η̂ − t)(1 − t))]}
//   ρ_T = (2/π)/√(1 − t).
//
// Γ_h has the same pole as Γ.
#include "bodies/half_space/lamb_kernel.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cassert>
#include <cmath>
#include <numbers>

namespace stoss::bodies::half_space {
namespace {

constexpr double pi = std::numbers::pi;

/// x² of the Rayleigh wave, the root in (0, 1) of y³ − 8y² + (24 − 16η̂) y − 16(1 − η̂): concave there, so that Newton's
/// steps from 0 rise to it.
double rayleigh_square(double squared_ratio) {
  const double linear = 24.0 - 16.0 * squared_ratio, constant = 16.0 * (1.0 - squared_ratio);
  double y = 0.0;
  while (true) {
    const double next = y - (((y - 8.0) * y + linear) * y - constant) / ((3.0 * y - 16.0) * y + linear);
    if (!(next > y)) return y;
    y = next;
  }
}

}  // namespace

double LambKernel::density_at(double t) const {
  const double factor = 2.0 / (pi * (1.0 - poisson));
  const double bend = (1.0 - 2.0 * t) * (1.0 - 2.0 * t);
  const double pressure = t - squared_ratio;
  if (pressure > 0.0) {
    return factor * 4.0 * t * pressure * std::sqrt(1.0 - t) / (bend * bend + 16.0 * t * t * pressure * (1.0 - t));
  }
  return factor * std::sqrt(-pressure) / (bend + 4.0 * t * std::sqrt(-pressure * (1.0 - t)));
}

LambKernel lamb_kernel(double poisson) {
  assert(poisson >= -19.0 && poisson <= 0.4999);
  const double eta = 0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson);
  const double square = rayleigh_square(eta), x = std::sqrt(square);
  const double a = std::sqrt(1.0 - eta * square), b = std::sqrt(1.0 - square);
  const double slope = 4.0 * x * (eta * b / a + a / b - 2.0 + square);  // of (2 − x²)² − 4ab
  return {.poisson = poisson,
          .squared_ratio = eta,
          .rayleigh_root = x,
          .rayleigh_weight = 2.0 * x * square * a / ((1.0 - poisson) * slope),
          .second_moment = (3.0 + (3.0 * eta - 4.0) * eta) / (4.0 * (1.0 - eta))};
}

double radiation_coefficient(const LambKernel& kernel) {
  // ∫ρ/x³ dx = ½∫ρ dt, in two parts: ρ is analytic but for roots at their ends.
  const auto density = [&](double t) { return kernel.density_at(t); };
  boost::math::quadrature::tanh_sinh<double> integrate;
  const double continuum = 0.5 * (integrate.integrate(density, 0.0, kernel.squared_ratio) +
                                  integrate.integrate(density, kernel.squared_ratio, 1.0));
  const double x = kernel.rayleigh_root;
  return 0.25 * (1.0 - kernel.poisson) * (kernel.rayleigh_weight / (x * x * x) + continuum);
}

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
