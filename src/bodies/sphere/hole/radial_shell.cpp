#include "bodies/sphere/hole/radial_shell.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/sphere/mode_search.hpp"
#include "numeric/quadrature.hpp"

namespace stoss::bodies::sphere {
namespace {

using Eigen::Index;
using Matrix = Eigen::MatrixXd;

constexpr Index inner_face = 0, surface = 1;  // the only functions that are not 0 at these

/// Values and slopes of the basis at x: (1 ∓ x)/2, and the integrals of P_1, P_2, …, scaled, which are 0 at both ends.
void fill_basis(double x, Eigen::VectorXd& value, Eigen::VectorXd& slope) {
  value(inner_face) = 0.5 * (1.0 - x), value(surface) = 0.5 * (1.0 + x);
  slope(inner_face) = -0.5, slope(surface) = 0.5;
  double below = 1.0, here = x;
  for (Index k = 2; k < value.size(); ++k) {
    const auto n = static_cast<double>(k);
    const double next = ((2.0 * n - 1.0) * x * here - (n - 1.0) * below) / n;
    value(k) = (next - below) / std::sqrt(2.0 * (2.0 * n - 1.0));
    slope(k) = std::sqrt(n - 0.5) * here;
    below = here;
    here = next;
  }
}

/// Takes the rigid motion t out of both: it has then no mass, and a stiffness of its own.
void remove_rigid(const Eigen::VectorXd& motion, Matrix& stiffness, Matrix& mass) {
  const Eigen::VectorXd momentum = mass * motion / std::sqrt(motion.dot(mass * motion));
  mass -= momentum * momentum.transpose();
  stiffness += momentum * momentum.transpose();
}

/// ω² = 1/μ of M x = μ K x, the largest μ first, which are accurate relative to the largest of all.
struct Vibrations {
  Eigen::VectorXd square;  // μ, rising
  Matrix shape;            // of unit mass
};

Vibrations vibrations(const Matrix& stiffness, const Matrix& mass) {
  const Eigen::LLT<Matrix> factor(stiffness);
  Matrix inverse = factor.matrixL().solve(mass);
  inverse = factor.matrixL().solve(inverse.transpose()).eval();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(inverse);
  return {solver.eigenvalues(), factor.matrixU().solve(solver.eigenvectors())};
}

}  // namespace

Index RadialShell::resolving(double frequency, double degree) const {
  // Legendre polynomials follow a wave of phase 2a from some a on. A field that a small hole makes is singular at the
  // centre, just beyond the end of the interval, so that they converge as ρ^−p, but of the share b^(2n−1) only.
  const double phase = 0.5 * (1.0 - inner_) * std::max(frequency * slowness_, degree);
  const double beyond = (1.0 + inner_) / (1.0 - inner_), rate = std::log(beyond + std::sqrt(beyond * beyond - 1.0));
  const double hole = (31.0 + std::max(3.0, 2.0 * degree - 1.0) * std::log(inner_)) / rate;
  return static_cast<Index>(std::ceil(phase + 4.0 * std::cbrt(phase) + std::max(14.0, hole))) + 1;
}

RadialShell::RadialShell(double poisson, double inner, double highest_frequency, double highest_degree)
    : inner_(inner),
      lame_(poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))),
      shear_(0.5 / (1.0 + poisson)),
      slowness_(1.0 / wave_speeds(poisson).shear),
      frequency_(highest_frequency) {
  const Index size = std::max(resolving(highest_frequency, highest_degree), resolving(highest_frequency, 0.0));
  const double half = 0.5 * (1.0 - inner);
  const numeric::GaussRule& rule = numeric::gauss_legendre(static_cast<int>(size) + 1);
  const auto nodes = static_cast<Index>(rule.node.size());
  Matrix value(nodes, size), slope(nodes, size);
  Eigen::VectorXd here(size), rise(size), radius(nodes), weight(nodes);
  for (Index i = 0; i < nodes; ++i) {
    const double x = rule.node[static_cast<std::size_t>(i)];
    fill_basis(x, here, rise);
    value.row(i) = here.transpose();
    slope.row(i) = rise.transpose() / half;
    radius(i) = inner + half * (1.0 + x);
    weight(i) = half * rule.weight[static_cast<std::size_t>(i)];
  }
  const Matrix arm = radius.asDiagonal() * value, strain = radius.asDiagonal() * slope;
  bending_ = strain.transpose() * weight.asDiagonal() * strain;
  mixed_ = strain.transpose() * weight.asDiagonal() * value;
  hooping_ = value.transpose() * weight.asDiagonal() * value;
  inertia_ = arm.transpose() * weight.asDiagonal() * arm;
}

RadialShell::Pencil RadialShell::spheroidal(int degree) const {
  const double wave = degree * (degree + 1.0);
  const Index size = std::min(resolving(frequency_, degree), bending_.rows());
  const auto bending = bending_.topLeftCorner(size, size), mixed = mixed_.topLeftCorner(size, size);
  const auto hooping = hooping_.topLeftCorner(size, size), inertia = inertia_.topLeftCorner(size, size);
  const Matrix twice = mixed + mixed.transpose();
  const Matrix radial =
      (lame_ + 2.0 * shear_) * bending + 2.0 * lame_ * twice + (4.0 * (lame_ + shear_) + shear_ * wave) * hooping;
  if (degree == 0) return {radial, inertia};
  Pencil pencil{Matrix(2 * size, 2 * size), Matrix::Zero(2 * size, 2 * size)};
  pencil.stiffness.topLeftCorner(size, size) = radial;
  pencil.stiffness.topRightCorner(size, size) =
      wave * (shear_ * mixed.transpose() - lame_ * mixed - (2.0 * lame_ + 3.0 * shear_) * hooping);
  pencil.stiffness.bottomLeftCorner(size, size) = pencil.stiffness.topRightCorner(size, size).transpose();
  pencil.stiffness.bottomRightCorner(size, size) =
      wave * (shear_ * (bending - twice) + ((lame_ + 2.0 * shear_) * wave - shear_) * hooping);
  pencil.mass.topLeftCorner(size, size) = inertia;
  pencil.mass.bottomRightCorner(size, size) = wave * inertia;
  if (degree == 1) {
    Eigen::VectorXd translation = Eigen::VectorXd::Zero(2 * size);
    for (const Index i : {inner_face, surface}) translation(i) = translation(size + i) = 1.0;
    remove_rigid(translation, pencil.stiffness, pencil.mass);
  }
  return pencil;
}

RadialShell::Pencil RadialShell::toroidal(int degree) const {
  const double wave = degree * (degree + 1.0);
  const Index size = std::min(resolving(frequency_, degree), bending_.rows());
  const auto mixed = mixed_.topLeftCorner(size, size);
  Pencil pencil{shear_ * (bending_.topLeftCorner(size, size) - mixed - mixed.transpose() +
                          (wave - 1.0) * hooping_.topLeftCorner(size, size)),
                inertia_.topLeftCorner(size, size)};
  if (degree == 1) {
    Eigen::VectorXd rotation = Eigen::VectorXd::Zero(size);
    rotation(inner_face) = inner_, rotation(surface) = 1.0;
    remove_rigid(rotation, pencil.stiffness, pencil.mass);
  }
  return pencil;
}

std::vector<Mode> RadialShell::modes(int degree, double cutoff) const {
  const Pencil pencil = spheroidal(degree);
  const Vibrations all = vibrations(pencil.stiffness, pencil.mass);
  const double norm = std::sqrt((2.0 * degree + 1.0) / 3.0);
  const Index size = degree == 0 ? 0 : pencil.mass.rows() / 2;
  std::vector<Mode> modes;
  for (Index k = all.square.size() - 1; k >= 0 && all.square(k) * cutoff * cutoff >= 1.0; --k) {
    const double scale = norm / std::sqrt(all.square(k));  // shapes are of unit stiffness
    const double radial = scale * all.shape(surface, k),
                 tangential = degree == 0 ? 0.0 : scale * all.shape(size + 1, k);
    const double sign = std::copysign(1.0, radial);
    modes.push_back(
        {degree, static_cast<int>(modes.size()), 1.0 / std::sqrt(all.square(k)), sign * radial, sign * tangential});
  }
  return modes;
}

std::vector<ToroidalMode> RadialShell::toroidal_modes(int degree, double cutoff) const {
  const Pencil pencil = toroidal(degree);
  const Vibrations all = vibrations(pencil.stiffness, pencil.mass);
  const double norm = std::sqrt((2.0 * degree + 1.0) / (3.0 * degree * (degree + 1.0)));
  std::vector<ToroidalMode> modes;
  for (Index k = all.square.size() - 1; k >= 0 && all.square(k) * cutoff * cutoff >= 1.0; --k) {
    const double scale = norm / std::sqrt(all.square(k));
    modes.push_back({degree, static_cast<int>(modes.size()), 1.0 / std::sqrt(all.square(k)),
                     std::abs(scale * all.shape(surface, k))});
  }
  return modes;
}

namespace {

/// fᵀ K⁻¹ f and fᵀ K⁻¹ M K⁻¹ f of unit forces on some functions.
struct Answer {
  Matrix compliance, second_moment;
};

Answer answer(const Matrix& stiffness, const Matrix& mass, const std::vector<Index>& functions) {
  Matrix force = Matrix::Zero(mass.rows(), static_cast<Index>(functions.size()));
  for (std::size_t k = 0; k < functions.size(); ++k) force(functions[k], static_cast<Index>(k)) = 1.0;
  const Matrix moved = stiffness.llt().solve(force);
  return {force.transpose() * moved, moved.transpose() * mass * moved};
}

}  // namespace

RadialShell::Response RadialShell::response(int degree) const {
  const Pencil pencil = spheroidal(degree);
  const double unit = (2.0 * degree + 1.0) / 3.0;
  if (degree == 0) {
    const Answer its = answer(pencil.stiffness, pencil.mass, {surface});
    return {{unit * its.compliance(0, 0), 0.0, 0.0}, {unit * its.second_moment(0, 0), 0.0, 0.0}};
  }
  Answer its = answer(pencil.stiffness, pencil.mass, {surface, surface + pencil.mass.rows() / 2});
  if (degree == 1) its.compliance.array() -= 1.0 / share_of_mass(inner_);  // of the translation (remove_rigid)
  const auto entries = [unit](const Matrix& of) {
    return Flexibility{unit * of(0, 0), unit * of(0, 1), unit * of(1, 1)};
  };
  return {entries(its.compliance), entries(its.second_moment)};
}

RadialShell::ToroidalResponse RadialShell::toroidal_response(int degree) const {
  const Pencil pencil = toroidal(degree);
  const double unit = (2.0 * degree + 1.0) / (3.0 * degree * (degree + 1.0));
  const Answer its = answer(pencil.stiffness, pencil.mass, {surface});
  const double rotation = degree == 1 ? 5.0 / share_of_inertia(inner_) : 0.0;
  return {unit * (its.compliance(0, 0) - rotation), unit * its.second_moment(0, 0)};
}

}  // namespace stoss::bodies::sphere
