#include "numeric/kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/multiversion.hpp"

namespace stoss::numeric::kernels {
namespace {

using Lanes = std::array<double, lanes>;

[[gnu::always_inline]] inline Lanes load(const double* from, double scale) {
  Lanes result;
  for (std::size_t i = 0; i < lanes; ++i) result[i] = scale * from[i];
  return result;
}

}  // namespace

STOSS_MULTIVERSION
void advance(const Oscillators& modes, const std::size_t* begin, std::size_t blocks, const double* push, double* edge) {
  const double* const push_lower = push + blocks * lanes;
  double* const edge_tangential = edge + blocks * lanes;
  for (std::size_t block = 0; block < blocks; ++block) {
    const Lanes upper_kick = load(push + block * lanes, 1.0);
    const Lanes lower_kick = load(push_lower + block * lanes, 1.0);
    Lanes upper_sum{};
    Lanes lower_sum{};
    for (std::size_t at = begin[block]; at < begin[block + 1]; at += lanes) {
      double* const a = modes.a + at;
      double* const b = modes.b + at;
      const double* const cosine = modes.cosine + at;
      const double* const sine = modes.sine + at;
      const double* const upper = modes.upper + at;
      const double* const lower = modes.lower + at;
#pragma omp simd
      for (std::size_t i = 0; i < lanes; ++i) {
        const double before = a[i];
        const double kicked = b[i] - (upper[i] * upper_kick[i] + lower[i] * lower_kick[i]);
        const double after = before * cosine[i] + kicked * sine[i];
        a[i] = after;
        b[i] = kicked * cosine[i] - before * sine[i];
        upper_sum[i] += upper[i] * after;
        lower_sum[i] += lower[i] * after;
      }
    }
    for (std::size_t i = 0; i < lanes; ++i) edge[block * lanes + i] = upper_sum[i];
    for (std::size_t i = 0; i < lanes; ++i) edge_tangential[block * lanes + i] = lower_sum[i];
  }
}

STOSS_MULTIVERSION
void advance_damped(const Oscillators& modes, const Damping& damping, const std::size_t* begin, std::size_t blocks,
                    std::size_t block, const double* push, double* edge, double* lost) {
  const Lanes upper_kick = load(push + block * lanes, 1.0);
  const Lanes lower_kick = load(push + (blocks + block) * lanes, 1.0);
  Lanes upper_sum{};
  Lanes lower_sum{};
  Lanes lost_sum{};
  for (std::size_t at = begin[block]; at < begin[block + 1]; at += lanes) {
    double* const a = modes.a + at;
    double* const b = modes.b + at;
    const double* const cosine = modes.cosine + at;
    const double* const sine = modes.sine + at;
    const double* const velocity = damping.velocity + at;
    const double* const rate = damping.rate + at;
    const double* const due = damping.due + at;
    const double* const upper = modes.upper + at;
    const double* const lower = modes.lower + at;
#pragma omp simd
    for (std::size_t i = 0; i < lanes; ++i) {
      const double before = a[i];
      const double kick = upper[i] * upper_kick[i] + lower[i] * lower_kick[i];
      const double kicked = b[i] - kick, between = b[i] - due[i] * kick;
      const double after = before * cosine[i] + kicked * sine[i];
      a[i] = after;
      b[i] = kicked * velocity[i] - before * sine[i];
      upper_sum[i] += upper[i] * after;
      lower_sum[i] += lower[i] * after;
      lost_sum[i] += rate[i] * between * between;
    }
  }
  for (std::size_t i = 0; i < lanes; ++i) edge[block * lanes + i] = upper_sum[i];
  for (std::size_t i = 0; i < lanes; ++i) edge[(blocks + block) * lanes + i] = lower_sum[i];
  for (std::size_t i = 0; i < lanes; ++i) lost[block * lanes + i] += lost_sum[i];
}

STOSS_MULTIVERSION
void advance_relaxing(const Oscillators& modes, const Relaxing& relaxing, const std::size_t* begin, std::size_t blocks,
                      std::size_t block, const double* push, double* edge, double* lost) {
  const Lanes upper_kick = load(push + block * lanes, 1.0);
  const Lanes lower_kick = load(push + (blocks + block) * lanes, 1.0);
  Lanes upper_sum{};
  Lanes lower_sum{};
  Lanes taken{};
  std::size_t decay = relaxing.first;
  for (std::size_t at = begin[block]; at < begin[block + 1]; at += lanes) {
    double* const a = modes.a + at;
    double* const b = modes.b + at;
    const double* const cosine = modes.cosine + at;
    const double* const sine = modes.sine + at;
    const double* const velocity = relaxing.velocity + at;
    const double* const place = relaxing.place + at;
    const double* const jump = relaxing.jump + at;
    const double* const of_b = relaxing.speed + at;
    const double* const upper = modes.upper + at;
    const double* const lower = modes.lower + at;
    Lanes kick;
    Lanes moved;
    Lanes speed;
#pragma omp simd
    for (std::size_t i = 0; i < lanes; ++i) {
      kick[i] = upper[i] * upper_kick[i] + lower[i] * lower_kick[i];
      speed[i] = of_b[i] * b[i];
      const double before = a[i] - place[i] * kick[i], kicked = b[i] - jump[i] * kick[i];
      moved[i] = before * cosine[i] + kicked * sine[i];
      a[i] = moved[i];
      b[i] = kicked * velocity[i] - before * sine[i];
    }
    for (std::size_t j = 0; j < relaxing.count; ++j, decay += lanes) {
      double* const z = relaxing.z + decay;
      const double* const residue = relaxing.residue + decay;
      const double* const kept = relaxing.kept + decay;
      const double* const rate = relaxing.rate + decay;
#pragma omp simd
      for (std::size_t i = 0; i < lanes; ++i) {
        speed[i] -= rate[i] * z[i];
        z[i] = (z[i] - residue[i] * kick[i]) * kept[i];
        moved[i] += z[i];
      }
    }
#pragma omp simd
    for (std::size_t i = 0; i < lanes; ++i) {
      upper_sum[i] += upper[i] * moved[i];
      lower_sum[i] += lower[i] * moved[i];
      taken[i] += kick[i] * speed[i];
    }
  }
  for (std::size_t i = 0; i < lanes; ++i) edge[block * lanes + i] = upper_sum[i];
  for (std::size_t i = 0; i < lanes; ++i) edge[(blocks + block) * lanes + i] = lower_sum[i];
  for (std::size_t i = 0; i < lanes; ++i) lost[block * lanes + i] -= taken[i];
}

STOSS_MULTIVERSION
void accumulate_energy(const Oscillators& modes, const std::size_t* begin, std::size_t blocks, const double* push,
                       double* energy) {
  for (std::size_t block = 0; block < blocks; ++block) {
    const Lanes upper_kick = load(push + block * lanes, 0.5);
    const Lanes lower_kick = load(push + (blocks + block) * lanes, 0.5);
    for (std::size_t at = begin[block]; at < begin[block + 1]; at += lanes) {
#pragma omp simd
      for (std::size_t i = 0; i < lanes; ++i) {
        const double a = modes.a[at + i];
        const double b = modes.b[at + i] - (modes.upper[at + i] * upper_kick[i] + modes.lower[at + i] * lower_kick[i]);
        energy[at + i] += a * a + b * b;
      }
    }
  }
}

STOSS_MULTIVERSION
void sum_oscillations(const double* omega, const double* weight, std::size_t count, double step, std::size_t steps,
                      double* sine, double* cosine) {
  std::fill(sine, sine + steps, 0.0);
  std::fill(cosine, cosine + steps, 0.0);
  for (std::size_t first = 0; first < count; first += lanes) {
    Lanes a{}, b{}, turn_a{}, turn_b{}, share{};
    for (std::size_t i = 0; i < std::min(lanes, count - first); ++i) {
      const double w = weight[first + i];
      a[i] = w * w;
      turn_a[i] = std::cos(omega[first + i] * step);
      turn_b[i] = std::sin(omega[first + i] * step);
      share[i] = 1.0 / omega[first + i];
    }
    for (std::size_t k = 0; k < steps; ++k) {
      double sum_a = 0.0, sum_b = 0.0;
#pragma omp simd reduction(+ : sum_a, sum_b)
      for (std::size_t i = 0; i < lanes; ++i) {
        const double before = a[i];
        a[i] = before * turn_a[i] - b[i] * turn_b[i];
        b[i] = before * turn_b[i] + b[i] * turn_a[i];
        sum_a += a[i];
        sum_b += b[i] * share[i];
      }
      cosine[k] += sum_a;
      sine[k] += sum_b;
    }
  }
}

}  // namespace stoss::numeric::kernels
