#include "numeric/kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

STOSS_MULTIVERSION
double largest_share(const double* change, const double* force, std::size_t count) {
  std::array<double, lanes> largest{};
  const auto take = [&](std::size_t lane, std::size_t i) {
    const double share = std::abs(change[i]) / force[i];
    largest[lane] = share > largest[lane] ? share : largest[lane];
  };
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
#pragma omp simd
    for (std::size_t lane = 0; lane < lanes; ++lane) take(lane, i + lane);
  }
  for (; i < count; ++i) take(0, i);
  return *std::max_element(largest.begin(), largest.end());
}

namespace {

[[gnu::always_inline]] inline void obey(const RoughNodes& nodes, std::size_t i) {
  const double closed = nodes.root[i] < 1.0 ? nodes.root[i] : 1.0, open = 1.0 - closed;
  nodes.gap[i] = nodes.reach[i] - nodes.asperities * nodes.closure[i] + nodes.edge[i] * open * open;
  nodes.stiffness[i] = (nodes.asperities + nodes.edge[i] * closed * open) / nodes.force[i];
}

}  // namespace

STOSS_MULTIVERSION
void add_forces(const RoughNodes& nodes, std::size_t count, const double* change) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double x = change[i] / nodes.force[i];
    // Series of ln(1 + x) and √(1 + x).
    const double logarithm =
        x *
        (1.0 - x * (1.0 / 2 - x * (1.0 / 3 - x * (1.0 / 4 - x * (1.0 / 5 - x * (1.0 / 6 - x * (1.0 / 7 - x / 8)))))));
    const double root =
        1.0 +
        x * (1.0 / 2 -
             x * (1.0 / 8 - x * (1.0 / 16 - x * (5.0 / 128 - x * (7.0 / 256 - x * (21.0 / 1024 - x * 33.0 / 2048))))));
    nodes.closure[i] += logarithm;
    nodes.force[i] += change[i];
    nodes.root[i] *= root;
    obey(nodes, i);
  }
}

STOSS_MULTIVERSION
void add_closures(const RoughNodes& nodes, std::size_t count, const double* change) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.5 * change[i];
    const double half =
        1.0 +
        x * (1.0 +
             x / 2 *
                 (1.0 +
                  x / 3 *
                      (1.0 + x / 4 * (1.0 + x / 5 * (1.0 + x / 6 * (1.0 + x / 7 * (1.0 + x / 8 * (1.0 + x / 9))))))));
    nodes.closure[i] += change[i];
    nodes.root[i] *= half;
    nodes.force[i] *= half * half;
    obey(nodes, i);
  }
}

}  // namespace stoss::numeric::kernels
