#include "numeric/kernels.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "numeric/multiversion.hpp"

namespace stoss::numeric::kernels {
namespace {

using Lanes = std::array<double, lanes>;

using Vector [[gnu::vector_size(32)]] = double;
constexpr std::size_t vector = 4;

struct Sum {
  Vector value;

  /// Adds four neighbours in memory, of any alignment: GCC forgets that of a reference where it splits a vector in two.
  [[gnu::always_inline]] void add(const double* from, double factor) {
    Vector each;
    std::memcpy(&each, from, sizeof each);
    value += each * factor;
  }
};

/// The next 4 · (number of places) elements of a product, held in registers while the rows pass: arrays of numbers
/// would not be.
template <std::size_t... place>
[[gnu::always_inline]] inline void multiply_vectors(const double* matrix, std::size_t stride, std::size_t rows,
                                                    const double* x, double* result, std::index_sequence<place...>) {
  std::array<Sum, sizeof...(place)> sum{};
  for (std::size_t j = 0; j < rows; ++j) {
    const double* const row = matrix + j * stride;
    (sum[place].add(row + vector * place, x[j]), ...);
  }
  (std::memcpy(result + vector * place, &sum[place].value, sizeof(Vector)), ...);
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

namespace {

/// In eight sums, of a fixed order.
[[gnu::always_inline]] inline double dot_here(const double* a, const double* b, std::size_t count) {
  Lanes sum{};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
#pragma omp simd
    for (std::size_t k = 0; k < lanes; ++k) sum[k] += a[i + k] * b[i + k];
  }
  for (std::size_t k = 0; i < count; ++i, ++k) sum[k] += a[i] * b[i];
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

}  // namespace

STOSS_MULTIVERSION
double dot(const double* a, const double* b, std::size_t count) { return dot_here(a, b, count); }

STOSS_MULTIVERSION
void take_transposed(const double* matrix, std::size_t stride, std::size_t rows, std::size_t count, const double* x,
                     double* result) {
  for (std::size_t j = 0; j < rows; ++j) {
    const double* const row = matrix + j * stride;
    const double each = x[j];
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) result[i] -= row[i] * each;
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

}  // namespace stoss::numeric::kernels
