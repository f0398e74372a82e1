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
void advance_lossy(const Oscillators& modes, const Losses& losses, const Decays& decays, const std::size_t* begin,
                   std::size_t blocks, const double* push, double* edge, double* lost) {
  const double* const push_lower = push + blocks * lanes;
  double* const edge_lower = edge + blocks * lanes;
  for (std::size_t block = 0; block < blocks; ++block) {
    const Lanes upper_kick = load(push + block * lanes, 1.0);
    const Lanes lower_kick = load(push_lower + block * lanes, 1.0);
    const std::size_t count = decays.count[block];
    std::size_t decay = decays.begin[block];
    Lanes upper_sum{};
    Lanes lower_sum{};
    Lanes lost_sum{};
    for (std::size_t at = begin[block]; at < begin[block + 1]; at += lanes) {
      Lanes kick{};
      Lanes moved{};
      Lanes speed{};
#pragma omp simd
      for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t k = at + i;
        kick[i] = modes.upper[k] * upper_kick[i] + modes.lower[k] * lower_kick[i];
        speed[i] = losses.speed[k] * modes.b[k];
        const double a = modes.a[k] - losses.place[k] * kick[i], b = modes.b[k] - losses.jump[k] * kick[i];
        moved[i] = a * modes.cosine[k] + b * modes.sine[k];
        modes.a[k] = moved[i];
        modes.b[k] = b * losses.velocity[k] - a * modes.sine[k];
      }
      for (std::size_t j = 0; j < count; ++j, decay += lanes) {
#pragma omp simd
        for (std::size_t i = 0; i < lanes; ++i) {
          const double z = decays.z[decay + i];
          speed[i] -= decays.rate[decay + i] * z;
          const double after = (z - decays.residue[decay + i] * kick[i]) * decays.kept[decay + i];
          decays.z[decay + i] = after;
          moved[i] += after;
        }
      }
#pragma omp simd
      for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t k = at + i;
        upper_sum[i] += modes.upper[k] * moved[i];
        lower_sum[i] += modes.lower[k] * moved[i];
        const double smooth = speed[i] - losses.due[k] * kick[i];
        lost_sum[i] += smooth * (losses.heat[k] * smooth - losses.work[k] * kick[i]);
      }
    }
    for (std::size_t i = 0; i < lanes; ++i) edge[block * lanes + i] = upper_sum[i];
    for (std::size_t i = 0; i < lanes; ++i) edge_lower[block * lanes + i] = lower_sum[i];
    for (std::size_t i = 0; i < lanes; ++i) lost[block * lanes + i] += lost_sum[i];
  }
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
