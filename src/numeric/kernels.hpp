#pragma once

#include <cstddef>

/// The inner loops of an impact, apart so that they alone need vector instructions. Every sum has a fixed order.
namespace stoss::numeric::kernels {

/// Orders that the loops over modes take side by side.
inline constexpr std::size_t lanes = 8;

/// Oscillators a = √ω Q, b = Q̇/√ω with their rotation in one step and their two weights over √ω, which
/// in these coordinates are the same for kicks and for displacements. Blocks of `lanes` orders lie one after another;
/// in a block, mode l of its order i is element l · lanes + i.
struct Oscillators {
  double* a;
  double* b;
  const double* cosine;
  const double* sine;
  const double* upper;
  const double* lower;
};

/// Kicks b by −(upper push_upper + lower push_lower), then rotates (a, b); edge receives the sums over each
/// order of upper a and lower a. Block i lies at begin[i] … begin[i + 1]. Push and edge hold a
/// value for each order, first of the upper rows, then of the lower ones.
void advance(const Oscillators& modes, const std::size_t* begin, std::size_t blocks, const double* push, double* edge);

/// What damped oscillators have besides.
struct Damping {
  const double* velocity;  ///< what a free step leaves of b, where `cosine` says what it leaves of a
  const double* rate;      ///< weight of b² in the power that is lost
  const double* due;       ///< share of the kick after which b is the velocity of smooth motion
};

/// The same for damped oscillators in some blocks. Adds to `lost` of each order the sum of rate b² after the due share
/// of the kick.
void advance_damped(const Oscillators& modes, const Damping& damping, const std::size_t* begin, std::size_t blocks,
                    std::size_t block, const double* push, double* edge, double* lost);

/// What oscillators that relax have besides: decays z e^(−λt), of which each has `count`, one after another for each
/// `lanes` oscillators from `first` on. Their displacement is a + Σ z, and `speed` b − Σ λ z is ω times their velocity.
/// A kick k moves a by place k, b by jump k and z by residue k.
struct Relaxing {
  const double* velocity;  ///< as Damping has it
  const double* place;
  const double* jump;
  const double* speed;
  double* z;
  const double* residue;
  const double* kept;  ///< e^(−λΔt)
  const double* rate;  ///< λ
  std::size_t first, count;
};

/// The same for oscillators of one block that relax. Takes from `lost` of each order the sum of ω times kick times
/// velocity before it.
void advance_relaxing(const Oscillators& modes, const Relaxing& relaxing, const std::size_t* begin, std::size_t blocks,
                      std::size_t block, const double* push, double* edge, double* lost);

/// Adds the oscillators' energies a² + b², in units of mass ω/2, to energy[k], after half of the kick that is due.
void accumulate_energy(const Oscillators& modes, const std::size_t* begin, std::size_t blocks, const double* push,
                       double* energy);

/// Product of the transpose of a row-major matrix with a vector: result[i] = Σ_{j<rows} matrix[j][i] x[j] for
/// begin ≤ i < end.
void multiply_transposed(const double* matrix, std::size_t stride, std::size_t rows, std::size_t begin, std::size_t end,
                         const double* x, double* result);

/// Adds the product of the transpose of a row-major matrix with a vector: result[i] += Σ_{j<rows} matrix[j][i] x[j] for
/// i < count.
void add_transposed(const double* matrix, std::size_t stride, std::size_t rows, std::size_t count, const double* x,
                    double* result);

/// Σ a[i] b[i] for i < count.
[[nodiscard]] double dot(const double* a, const double* b, std::size_t count);

/// Takes the product of the transpose of a row-major matrix with a vector: result[i] −= Σ_{j<rows} matrix[j][i] x[j]
/// for i < count.
void take_transposed(const double* matrix, std::size_t stride, std::size_t rows, std::size_t count, const double* x,
                     double* result);

/// Nodes with asperities between smooth edges: f = f* eᵗ, g = reach − u₀ t + edge (1 − min(τ, 1))² with τ = √(f/f_e).
struct RoughNodes {
  double* closure;    ///< t
  double* force;      ///< f
  double* root;       ///< τ
  double* gap;        ///< g
  double* stiffness;  ///< −dg/df
  const double* reach;
  const double* edge;
  double asperities;  ///< u₀
};

/// The largest |change[i]|/force[i] for i < count.
[[nodiscard]] double largest_share(const double* change, const double* force, std::size_t count);

/// Adds changes of up to `most_of_force` of it to the force of each node, to rounding.
inline constexpr double most_of_force = 0.02;
void add_forces(const RoughNodes& nodes, std::size_t count, const double* change);

/// Adds changes of up to `most_of_closure` to the closure of each node, to rounding.
inline constexpr double most_of_closure = 0.25;
void add_closures(const RoughNodes& nodes, std::size_t count, const double* change);

/// result[i] = scale · x[i] for i < count.
void scale(double scale, const double* x, std::size_t count, double* result);

/// result[i] = minuend[i] − subtrahend[i] for i < count.
void subtract(const double* minuend, const double* subtrahend, std::size_t count, double* result);

/// result[i] = minuend − subtrahend[i] for i < count.
void subtract_from(double minuend, const double* subtrahend, std::size_t count, double* result);

/// result[i] = a[i] + b[i] for i < count.
void add(const double* a, const double* b, std::size_t count, double* result);

/// The largest of max(x[i], range[i]) where x[i] > −range[i], 0 if that is nowhere, not a number if an x[i] is not
/// finite; range[i] = scale · unit[i].
double largest_within(const double* x, const double* unit, double scale, std::size_t count);

/// Masses in free flight, and what they pull at (ResidualMotion).
struct Masses {
  double* displacement;
  double* velocity;
  double* acceleration;
  double* stretch;
  std::size_t count;
};

/// First half of a step by the trapezium rule: displacement and velocity become what they would be without the
/// acceleration to come; rest = displacement + fading · stretch.
void drift(const Masses& masses, double step, double fading, double* rest);

/// Second half: takes the acceleration into both; the stretch becomes moved − displacement.
void accelerate(const Masses& masses, double step, const double* moved);

/// Adds products of the rows of two row-major matrices, whose sum is symmetric, to the lower triangle of a matrix:
/// sum[i][j] += Σ_{k<rows} a[k][i] b[k][j] for first ≤ i < last and j ≤ i; entries up to the next whole vector become
/// void.
/// @param stride of all three, and `first` and `last`: whole vectors of `lanes`
void add_lower_products(const double* a, const double* b, std::size_t stride, std::size_t rows, std::size_t first,
                        std::size_t last, double* sum);

/// Sums over oscillators of a weight w each, of steps k = 1 … steps: sine[k − 1] = Σ w² sin(ω k Δt)/ω and
/// cosine[k − 1] = Σ w² cos(ω k Δt).
void sum_oscillations(const double* omega, const double* weight, std::size_t count, double step, std::size_t steps,
                      double* sine, double* cosine);

}  // namespace stoss::numeric::kernels
