#include "kernels.hpp"

#include <array>

// Function multiversioning: one portable binary that uses AVX2 where the processor has it (AVX-512 was no faster).
// Sanitizers cannot run before the resolver, and clang 14 lacks architecture levels here; both get the portable code.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__ELF__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define STOSS_MULTIVERSION __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define STOSS_MULTIVERSION
#endif

namespace stoss::kernels {

STOSS_MULTIVERSION
void advance(const Oscillators& modes, const std::size_t* begin, std::size_t groups, const EdgeAmplitude* push,
             EdgeAmplitude* edge) {
  double* const a = modes.a;
  double* const b = modes.b;
  const double* const cosine = modes.cosine;
  const double* const sine = modes.sine;
  const double* const radial = modes.radial;
  const double* const tangential = modes.tangential;
  const double* const radial_per_omega = modes.radial_per_omega;
  const double* const tangential_per_omega = modes.tangential_per_omega;
  for (std::size_t g = 0; g < groups; ++g) {
    const double push_radial = push[g].radial;
    const double push_tangential = push[g].tangential;
    double sum_radial = 0.0;
    double sum_tangential = 0.0;
    const std::size_t end = begin[g + 1];
#pragma omp simd reduction(+ : sum_radial, sum_tangential)
    for (std::size_t k = begin[g]; k < end; ++k) {
      const double before = a[k];
      const double kicked = b[k] - (radial[k] * push_radial + tangential[k] * push_tangential);
      const double after = before * cosine[k] + kicked * sine[k];
      a[k] = after;
      b[k] = kicked * cosine[k] - before * sine[k];
      sum_radial += radial_per_omega[k] * after;
      sum_tangential += tangential_per_omega[k] * after;
    }
    edge[g] = {sum_radial, sum_tangential};
  }
}

STOSS_MULTIVERSION
void accumulate_energy(const Oscillators& modes, const std::size_t* begin, std::size_t groups,
                       const EdgeAmplitude* push, double* energy) {
  for (std::size_t g = 0; g < groups; ++g) {
    const double push_radial = 0.5 * push[g].radial;
    const double push_tangential = 0.5 * push[g].tangential;
    const std::size_t end = begin[g + 1];
#pragma omp simd
    for (std::size_t k = begin[g]; k < end; ++k) {
      const double a = modes.a[k];
      const double b = modes.b[k] - (modes.radial[k] * push_radial + modes.tangential[k] * push_tangential);
      energy[k] += a * a + b * b;
    }
  }
}

STOSS_MULTIVERSION
void add_shapes(const EdgeAmplitude* amplitude, const double* radial_shape, const double* tangential_shape,
                std::size_t groups, std::size_t stride, std::size_t count, double* position) {
  constexpr std::size_t block = 32;
  std::size_t start = 0;
  for (; start + block <= count; start += block) {
    std::array<double, block> sum{};
    for (std::size_t g = 0; g < groups; ++g) {
      const double* const radial = radial_shape + g * stride + start;
      const double* const tangential = tangential_shape + g * stride + start;
      const double r = amplitude[g].radial;
      const double t = amplitude[g].tangential;
#pragma omp simd
      for (std::size_t i = 0; i < block; ++i) sum[i] += r * radial[i] + t * tangential[i];
    }
    for (std::size_t i = 0; i < block; ++i) position[start + i] += sum[i];
  }
  for (std::size_t g = 0; g < groups; ++g) {
    const double* const radial = radial_shape + g * stride;
    const double* const tangential = tangential_shape + g * stride;
    for (std::size_t i = start; i < count; ++i) {
      position[i] += amplitude[g].radial * radial[i] + amplitude[g].tangential * tangential[i];
    }
  }
}

STOSS_MULTIVERSION
void project_force(const double* force, const double* radial_shape, const double* tangential_shape, std::size_t groups,
                   std::size_t stride, std::size_t count, EdgeAmplitude* push) {
  for (std::size_t g = 0; g < groups; ++g) {
    const double* const radial = radial_shape + g * stride;
    const double* const tangential = tangential_shape + g * stride;
    double sum_radial = 0.0;
    double sum_tangential = 0.0;
#pragma omp simd reduction(+ : sum_radial, sum_tangential)
    for (std::size_t i = 0; i < count; ++i) {
      sum_radial += force[i] * radial[i];
      sum_tangential += force[i] * tangential[i];
    }
    push[g] = {sum_radial, sum_tangential};
  }
}

STOSS_MULTIVERSION
void multiply(const double* matrix, std::size_t stride, std::size_t row_begin, std::size_t row_end, std::size_t columns,
              const double* x, double* result) {
  for (std::size_t i = row_begin; i < row_end; ++i) {
    const double* const row = matrix + i * stride;
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t j = 0; j < columns; ++j) sum += row[j] * x[j];
    result[i] = sum;
  }
}

STOSS_MULTIVERSION
void solve_cholesky(const double* factor, std::size_t stride, std::size_t count, const double* right, double* x) {
  for (std::size_t i = 0; i < count; ++i) {
    const double* const row = factor + i * stride;
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t j = 0; j < i; ++j) sum += row[j] * x[j];
    x[i] = (right[i] - sum) / row[i];
  }
  for (std::size_t i = count; i-- > 0;) {
    const double* const row = factor + i * stride;
    const double value = x[i] / row[i];
    x[i] = value;
    for (std::size_t j = 0; j < i; ++j) x[j] -= row[j] * value;
  }
}

}  // namespace stoss::kernels
