#include "numeric/kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "numeric/multiversion.hpp"

namespace stoss::numeric::kernels {
namespace {

using Lanes = std::array<double, lanes>;

[[gnu::always_inline]] inline Lanes load(const double* from, double scale) {
  Lanes result;
  for (std::size_t i = 0; i < lanes; ++i) result[i] = scale * from[i];
  return result;
}

/// Four neighbours in memory, of any alignment.
using Vector [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
constexpr std::size_t vector = 4;
struct Sum {
  Vector value;
};

/// The next 4 · (number of places) elements of a product, held in registers while the rows pass: arrays of numbers
/// would not be.
template <std::size_t... place>
[[gnu::always_inline]] inline void multiply_vectors(const double* matrix, std::size_t stride, std::size_t rows,
                                                    const double* x, double* result, std::index_sequence<place...>) {
  std::array<Sum, sizeof...(place)> sum{};
  for (std::size_t j = 0; j < rows; ++j) {
    const auto* const row = reinterpret_cast<const Vector*>(matrix + j * stride);
    ((sum[place].value += row[place] * x[j]), ...);
  }
  ((reinterpret_cast<Vector*>(result)[place] = sum[place].value), ...);
}

template <std::size_t width>
[[gnu::always_inline]] inline void multiply_block(const double* matrix, std::size_t stride, std::size_t rows,
                                                  const double* x, double* result) {
  multiply_vectors(matrix, stride, rows, x, result, std::make_index_sequence<width / vector>());
}

/// The same for a single element.
[[gnu::always_inline]] inline void multiply_single(const double* matrix, std::size_t stride, std::size_t rows,
                                                   const double* x, double* result) {
  double sum = 0.0;
  for (std::size_t j = 0; j < rows; ++j) sum += matrix[j * stride] * x[j];
  *result = sum;
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
                    const double* push, double* edge, double* lost) {
  const double* const push_lower = push + blocks * lanes;
  double* const edge_tangential = edge + blocks * lanes;
  for (std::size_t block = 0; block < blocks; ++block) {
    const Lanes upper_kick = load(push + block * lanes, 1.0);
    const Lanes lower_kick = load(push_lower + block * lanes, 1.0);
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
    for (std::size_t i = 0; i < lanes; ++i) edge_tangential[block * lanes + i] = lower_sum[i];
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
void multiply_transposed(const double* matrix, std::size_t stride, std::size_t rows, std::size_t begin, std::size_t end,
                         const double* x, double* result) {
  if (rows == 0) {
    std::fill(result + begin, result + end, 0.0);
    return;
  }
  std::size_t i = begin;
  for (; i + 64 <= end; i += 32) multiply_block<32>(matrix + i, stride, rows, x, result + i);
  // The rest in one block if it consists of whole vectors: narrow blocks wait for their sums.
  const auto rest = [&]<std::size_t width>() {
    multiply_block<width>(matrix + i, stride, rows, x, result + i);
    i += width;
  };
  switch ((end - i) / 8) {
    case 7:
      rest.template operator()<56>();
      break;
    case 6:
      rest.template operator()<48>();
      break;
    case 5:
      rest.template operator()<40>();
      break;
    case 4:
      rest.template operator()<32>();
      break;
    case 3:
      rest.template operator()<24>();
      break;
    case 2:
      rest.template operator()<16>();
      break;
    case 1:
      rest.template operator()<8>();
      break;
    default:
      break;
  }
  for (; i < end; ++i) multiply_single(matrix + i, stride, rows, x, result + i);
}

STOSS_MULTIVERSION
void add_transposed(const double* matrix, std::size_t stride, std::size_t rows, std::size_t count, const double* x,
                    double* result) {
  constexpr std::size_t width = 16;
  std::size_t i = 0;
  for (; i + width <= count; i += width) {
    std::array<double, width> sum;
    for (std::size_t k = 0; k < width; ++k) sum[k] = result[i + k];
    for (std::size_t j = 0; j < rows; ++j) {
      const double* const row = matrix + j * stride + i;
#pragma omp simd
      for (std::size_t k = 0; k < width; ++k) sum[k] += row[k] * x[j];
    }
    for (std::size_t k = 0; k < width; ++k) result[i + k] = sum[k];
  }
  for (; i < count; ++i) {
    for (std::size_t j = 0; j < rows; ++j) result[i] += matrix[j * stride + i] * x[j];
  }
}

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
  Lanes largest{}, unbounded{};
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
void add_lower_products(const double* a, const double* b, std::size_t stride, std::size_t rows, std::size_t first,
                        std::size_t last, double* sum) {
  constexpr std::size_t height = 4;  // with `lanes` columns as many sums as stay in registers
  for (std::size_t i = first; i < last; i += height) {
    for (std::size_t j = 0; j <= i; j += lanes) {
      std::array<Lanes, height> block{};
      for (std::size_t k = 0; k < rows; ++k) {
        const double* const left = a + k * stride + i;
        const double* const right = b + k * stride + j;
        for (std::size_t h = 0; h < height; ++h) {
#pragma omp simd
          for (std::size_t l = 0; l < lanes; ++l) block[h][l] += left[h] * right[l];
        }
      }
      for (std::size_t h = 0; h < height; ++h) {
        for (std::size_t l = 0; l < lanes; ++l) sum[(i + h) * stride + j + l] += block[h][l];
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
