#include "numeric/kernels.hpp"

#include <algorithm>
#include <array>

#include "numeric/multiversion.hpp"

namespace stoss::numeric::kernels {

STOSS_MULTIVERSION
void scale(double scale, const double* x, std::size_t count, double* result) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) result[i] = scale * x[i];
}

STOSS_MULTIVERSION
void subtract(const double* minuend, const double* subtrahend, std::size_t count, double* result) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) result[i] = minuend[i] - subtrahend[i];
}

STOSS_MULTIVERSION
void subtract_from(double minuend, const double* subtrahend, std::size_t count, double* result) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) result[i] = minuend - subtrahend[i];
}

STOSS_MULTIVERSION
void add(const double* a, const double* b, std::size_t count, double* result) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) result[i] = a[i] + b[i];
}

STOSS_MULTIVERSION
double largest_within(const double* x, const double* unit, double scale, std::size_t count) {
  std::array<double, lanes> largest{}, unbounded{};
  const auto take = [&](std::size_t lane, std::size_t i) {
    const double range = scale * unit[i], larger = x[i] > range ? x[i] : range, felt = x[i] > -range ? larger : 0.0;
    largest[lane] = felt > largest[lane] ? felt : largest[lane];
    unbounded[lane] += 0.0 * x[i];
  };
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
#pragma omp simd
    for (std::size_t lane = 0; lane < lanes; ++lane) take(lane, i + lane);
  }
  for (; i < count; ++i) take(0, i);
  double result = 0.0, all = 0.0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    result = std::max(result, largest[lane]);
    all += unbounded[lane];
  }
  return result + all;
}

STOSS_MULTIVERSION
void drift(const Masses& masses, double step, double fading, double* rest) {
  double* const displacement = masses.displacement;
  double* const velocity = masses.velocity;
  const double* const acceleration = masses.acceleration;
  const double* const stretch = masses.stretch;
  const double half = 0.5 * step;
#pragma omp simd
  for (std::size_t k = 0; k < masses.count; ++k) {
    displacement[k] += step * velocity[k] + half * half * acceleration[k];
    velocity[k] += half * acceleration[k];
    rest[k] = displacement[k] + fading * stretch[k];
  }
}

STOSS_MULTIVERSION
void accelerate(const Masses& masses, double step, const double* moved) {
  double* const displacement = masses.displacement;
  double* const velocity = masses.velocity;
  const double* const acceleration = masses.acceleration;
  double* const stretch = masses.stretch;
  const double half = 0.5 * step;
#pragma omp simd
  for (std::size_t k = 0; k < masses.count; ++k) {
    displacement[k] += half * half * acceleration[k];
    velocity[k] += half * acceleration[k];
    stretch[k] = moved[k] - displacement[k];
  }
}

}  // namespace stoss::numeric::kernels
