#include "bodies/half_space/depth_profile.hpp"

#include <cmath>

namespace stoss::bodies::half_space {
namespace {

std::complex<double> root_above_branch_point(double square) {
  return square >= 0.0 ? std::complex<double>(std::sqrt(square)) : std::complex<double>(0.0, std::sqrt(-square));
}

}  // namespace

WaveProfile::WaveProfile(const LambKernel& kernel, double x)
    : pressure_decay_(root_above_branch_point(1.0 - kernel.squared_ratio * x * x)),
      shear_decay_(root_above_branch_point(1.0 - x * x)) {
  const double square = x * x, sum = 2.0 - square;  // 1 + b²
  const Complex a = pressure_decay_, b = shear_decay_;
  // What belongs to the Rayleigh wave is real: i makes it an imaginary part like the others.
  const Complex inverse = x > 1.0 ? 1.0 / (sum * sum - 4.0 * a * b) : Complex(0.0, 1.0);
  const double surface = -(a * square * inverse).imag();
  const Complex unit = inverse / surface;
  pressure_lateral_ = sum * unit;
  shear_lateral_ = -2.0 * a * b * unit;
  pressure_normal_ = a * pressure_lateral_;
  shear_normal_ = -2.0 * a * unit;
}

DepthProfile WaveProfile::at(double phase) const {
  const Complex pressure = std::exp(-pressure_decay_ * phase), shear = std::exp(-shear_decay_ * phase);
  return {(pressure_lateral_ * pressure + shear_lateral_ * shear).imag(),
          (pressure_normal_ * pressure + shear_normal_ * shear).imag()};
}

DepthProfile static_profile(double poisson, double phase) {
  const double decay = std::exp(-phase), half = 0.5 / (1.0 - poisson);
  return {decay * (phase - 1.0 + 2.0 * poisson) * half, decay * (1.0 + phase * half)};
}

}  // namespace stoss::bodies::half_space
