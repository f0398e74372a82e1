#pragma once

#include <cstddef>

namespace stoss::kernels {

/// Inner loops of an impact. Each is compiled for several instruction sets and chosen when the program starts; the
/// order of every sum is fixed by the code, not by the number of threads.

/// Kicks and rotates the oscillators [begin, end) of one group over one step and sums their edge displacement.
/// With a = ωQ and b = Q̇: b ← b − (C push_radial + S push_tangential), then (a, b) ← rotation by ω Δt.
struct Oscillators {
  double* a;
  double* b;
  const double* cosine;
  const double* sine;
  const double* radial;
  const double* tangential;
  const double* radial_per_omega;
  const double* tangential_per_omega;
};
struct EdgeAmplitude {
  double radial;
  double tangential;
};
void advance(const Oscillators& modes, const std::size_t* begin, std::size_t groups, const EdgeAmplitude* push,
             EdgeAmplitude* edge);

/// energy[k] += a² + b², the oscillators' energies in units of mass/2, after half of the kick that is due.
void accumulate_energy(const Oscillators& modes, const std::size_t* begin, std::size_t groups,
                       const EdgeAmplitude* push, double* energy);

/// position[i] += Σ_g amplitude[g].radial radial_shape[g][i] + amplitude[g].tangential tangential_shape[g][i]
/// for i < count; rows are `stride` apart.
void add_shapes(const EdgeAmplitude* amplitude, const double* radial_shape, const double* tangential_shape,
                std::size_t groups, std::size_t stride, std::size_t count, double* position);

/// push[g] = Σ_{i<count} force[i] (radial_shape[g][i], tangential_shape[g][i]).
void project_force(const double* force, const double* radial_shape, const double* tangential_shape, std::size_t groups,
                   std::size_t stride, std::size_t count, EdgeAmplitude* push);

/// result = M x for rows [row_begin, row_end) and columns [0, columns) of a row-major matrix.
void multiply(const double* matrix, std::size_t stride, std::size_t row_begin, std::size_t row_end, std::size_t columns,
              const double* x, double* result);

/// Solves (L Lᵀ) x = right for the leading block of size `count` of a row-major lower factor L.
void solve_cholesky(const double* factor, std::size_t stride, std::size_t count, const double* right, double* x);

}  // namespace stoss::kernels
