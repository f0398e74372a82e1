#include "bodies/plate/branches.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

#include "bodies/plate/stack.hpp"

namespace stoss::bodies::plate {
namespace {

/// Points of a circle, of which those on its lower half are the mirror image.
template <typename Visit>
void for_circle(double radius, int places, const Visit& visit) {
  for (int n = 0; n < places; ++n) {
    const double angle = std::numbers::pi * (n + 0.5) / places;
    visit(Complex{radius * std::cos(angle), radius * std::sin(angle)});
  }
}

template <int N>
class Search {
 public:
  using Vector = typename Branches<N>::Vector;
  using Matrix = typename Branches<N>::Matrix;

  Search(const Sheets& sheets, double wave_number, const std::vector<double>& guess, const Poll& poll)
      : sheets_(sheets), k_(wave_number), guess_(guess), poll_(poll) {}

  Branches<N> below(double cutoff) {
    // Well below the vibrations of the thickness, where modes hardly move the face, up to these: else what those above
    // the cutoff add would be lost in rounding.
    const double highest = std::max(cutoff, slowest());
    find(highest);
    add_others(highest);
    move_above(cutoff);
    return std::move(found_);
  }

 private:
  /// Numbers of modes below a frequency: all of them, and those of the plate with its upper face held.
  struct Probe {
    double omega;
    int modes, held;
  };

  /// A root of the determinant of the face, and the face there with its derivative by z.
  struct Root {
    double z;
    SmallMatrix<Differentiable, N> face;

    [[nodiscard]] double omega() const { return std::sqrt(z); }
  };

  [[nodiscard]] Probe probe(double omega) const {
    if (poll_) poll_();
    const auto all = stack<N>(sheets_, k_, omega * omega);
    return {omega, all.held + negative(all.stiffness), all.held};
  }

  /// One over the time in which shear waves cross all layers.
  [[nodiscard]] double slowest() const {
    double time = 0.0;
    for (const Sheet& sheet : sheets_.all) time += sheet.thickness * std::sqrt(sheet.density / sheet.shear_modulus);
    return 1.0 / time;
  }

  void find(double cutoff) {
    const std::vector<Root> roots = near_guesses(cutoff);
    isolate({0.0, 0, 0}, probe(cutoff), roots);
  }

  /// Different roots, rising, that Newton's method finds from the guesses.
  [[nodiscard]] std::vector<Root> near_guesses(double cutoff) const {
    constexpr double apart = 1e-5;
    std::vector<Root> roots;
    for (const double guess : guess_) {
      if (poll_) poll_();
      const double low = roots.empty() ? 0.0 : (1.0 + apart) * roots.back().omega();
      if (const std::optional<Root> root = root_from(guess, low, cutoff)) roots.push_back(*root);
    }
    return roots;
  }

  /// Adds all modes between two frequencies.
  /// @param roots those of the determinant that are known there: all if they are as many as the modes
  void isolate(const Probe& low, const Probe& high, std::span<const Root> roots) {
    constexpr double apart = 1e-7, nearest = 1e-12;  // of modes that need not, and that cannot be told from each other
    const int modes = high.modes - low.modes;
    if (modes <= 0) return;
    if (modes == static_cast<int>(roots.size())) {
      for (const Root& root : roots) add(root);
      return;
    }
    if (modes == 1 && low.held == high.held) {
      if (const std::optional<Root> root = root_between(low.omega, high.omega)) return add(*root);
    }
    const double middle = 0.5 * (low.omega + high.omega), width = high.omega - low.omega;
    if (width < nearest * middle || (width < apart * middle && modes == within(middle, 25.0 * width))) {
      return add_cluster(middle, width, modes);
    }
    const Probe between = probe(middle);
    const auto below = static_cast<std::size_t>(
        std::count_if(roots.begin(), roots.end(), [&](const Root& root) { return root.omega() < middle; }));
    isolate(low, between, roots.first(below));
    isolate(between, high, roots.subspan(below));
  }

  /// Number of modes nearer to a frequency than some distance.
  [[nodiscard]] int within(double omega, double distance) const {
    return probe(omega + distance).modes - probe(omega - distance).modes;
  }

  /// Unless rounding hides a root.
  [[nodiscard]] std::optional<Root> root_between(double low, double high) const {
    if (const std::optional<Root> root = root_from(0.5 * (low + high), low, high)) return root;
    constexpr int bits = 51;
    std::uintmax_t evaluations = 100;
    const auto function = [this](double omega) { return determinant(stack<N>(sheets_, k_, omega * omega).stiffness); };
    const double at_low = function(low), at_high = function(high);
    if (!((at_low < 0.0 && at_high > 0.0) || (at_low > 0.0 && at_high < 0.0))) return {};
    const auto [from, to] = boost::math::tools::toms748_solve(
        function, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(bits), evaluations);
    const Root root = step_from(0.25 * (from + to) * (from + to));
    return root.z > low * low && root.z < high * high ? std::optional(root) : std::nullopt;
  }

  /// By Newton's method, unless it leaves the frequencies between two or does not converge at once.
  [[nodiscard]] std::optional<Root> root_from(double guess, double low, double high) const {
    constexpr int most = 8;
    constexpr double close = 1e-12;  // the step from there ends at rounding
    double z = guess * guess, last = z;
    for (int n = 0; n < most; ++n) {
      const Root next = step_from(z);
      const double step = std::abs(next.z - z);
      if (!(next.z > low * low && next.z < high * high && step < last)) return {};
      if (step < close * z) return next;
      z = next.z, last = 0.5 * step;
    }
    return {};
  }

  /// Where the determinant of Q + Q′ step is 0: of both roots, as Q′ is definite, the one at which it has the slope of
  /// this side.
  [[nodiscard]] Root step_from(double z) const {
    const auto face = stack<N>(sheets_, k_, Differentiable{z, 1.0}).stiffness;
    const Differentiable value = determinant(face);
    const double curvature = N == 1 ? 0.0 : second(face).determinant();
    const double both = std::sqrt(std::max(value.b * value.b - 4.0 * curvature * value.a, 0.0));
    const double step = -2.0 * value.a / (value.b + std::copysign(both, value.b));
    return {z + step, matrix_of<N>([&](int i, int j) { return face(i, j) + step * face(i, j).b; })};
  }

  /// The face φ of its mode, with φᵀQ′φ = −1.
  void add(const Root& root) {
    const Matrix stiffness = first(root.face);
    Vector shape = Vector::Ones();
    if constexpr (N == 2) {
      const double across = stiffness(0, 0), depth = stiffness(1, 1), mixed = stiffness(0, 1);
      shape = std::abs(across) > std::abs(depth) ? Vector{-mixed, across} : Vector{depth, -mixed};
    }
    const double mass = -shape.dot(second(root.face) * shape);
    found_.omega.push_back(root.omega());
    found_.amplitude.push_back(std::sqrt(mass > 0.0 ? 1.0 / mass : 0.0) * shape);
  }

  /// Modes within a width that are too close to each other to be told apart, and far from others: those of the sum of
  /// their φφᵀ, at the mean of their frequencies.
  void add_cluster(double omega, double width, int modes) {
    constexpr int places = 6;
    const double center = omega * omega;
    Matrix strength = Matrix::Zero();
    double moment = 0.0;
    for_circle(5.0 * width * omega, places, [&](const Complex& from) {
      const SmallMatrix<Complex, N> residue = from * inverse(stack<N>(sheets_, k_, center + from).stiffness);
      strength -= first(residue) / places;
      moment -= first(from * residue).trace() / places;
    });
    const double all = strength.trace(), most = width * omega;
    const double mean = all > 0.0 ? std::sqrt(center + std::clamp(moment / all, -most, most)) : omega;
    const Eigen::SelfAdjointEigenSolver<Matrix> parts(strength);
    for (int i = 0; i < std::min(modes, N); ++i) {
      const Eigen::Index n = N - 1 - i;
      found_.omega.push_back(mean);
      found_.amplitude.push_back(std::sqrt(std::max(parts.eigenvalues()(n), 0.0)) * parts.eigenvectors().col(n));
    }
  }

  void add_others(double cutoff) {
    found_.compliance = found_.second_moment = Matrix::Zero();
    if (found_.omega.empty()) {
      found_.compliance = static_compliance<N>(sheets_, k_);
      found_.second_moment = static_second_moment<N>(sheets_, k_);
      return;
    }
    constexpr int places = 12;
    constexpr double share = 0.35;  // of the radius, in that of the next singularity at least
    for_circle(share * cutoff * cutoff, places, [&](const Complex& z) {
      SmallMatrix<Complex, N> response = inverse(stack<N>(sheets_, k_, z).stiffness);
      for (std::size_t m = 0; m < found_.omega.size(); ++m) {
        const Vector& amplitude = found_.amplitude[m];
        const Complex over = 1.0 / (found_.omega[m] * found_.omega[m] - z);
        for (int i = 0; i < N; ++i) {
          for (int j = 0; j < N; ++j) response(i, j) = response(i, j) - amplitude(i) * amplitude(j) * over;
        }
      }
      found_.compliance += first(response) / places;
      found_.second_moment += first((1.0 / z) * response) / places;
    });
  }

  /// Counts modes above the cutoff to the others.
  void move_above(double cutoff) {
    while (!found_.omega.empty() && found_.omega.back() > cutoff) {
      const double square = found_.omega.back() * found_.omega.back();
      const Matrix strength = found_.amplitude.back() * found_.amplitude.back().transpose();
      found_.compliance += strength / square;
      found_.second_moment += strength / (square * square);
      found_.omega.pop_back();
      found_.amplitude.pop_back();
    }
  }

  const Sheets& sheets_;
  double k_;
  const std::vector<double>& guess_;
  const Poll& poll_;
  Branches<N> found_;
};

}  // namespace

template <int N>
Branches<N> branches(const Sheets& sheets, double wave_number, double cutoff, const std::vector<double>& guess,
                     const Poll& poll) {
  return Search<N>(sheets, wave_number, guess, poll).below(cutoff);
}

template <int N>
int count_below(const Sheets& sheets, double wave_number, double omega) {
  const auto all = stack<N>(sheets, wave_number, omega * omega);
  return all.held + negative(all.stiffness);
}

template <int N>
Eigen::Matrix<double, N, N> static_compliance(const Sheets& sheets, double wave_number) {
  return first(inverse(stack<N>(sheets, wave_number, 0.0).stiffness));
}

template <int N>
Eigen::Matrix<double, N, N> static_second_moment(const Sheets& sheets, double wave_number) {
  return second(inverse(stack<N>(sheets, wave_number, Differentiable{0.0, 1.0}).stiffness));
}

template Branches<1> branches<1>(const Sheets&, double, double, const std::vector<double>&, const Poll&);
template Branches<2> branches<2>(const Sheets&, double, double, const std::vector<double>&, const Poll&);
template int count_below<1>(const Sheets&, double, double);
template int count_below<2>(const Sheets&, double, double);
template Eigen::Matrix<double, 1, 1> static_compliance<1>(const Sheets&, double);
template Eigen::Matrix<double, 2, 2> static_compliance<2>(const Sheets&, double);
template Eigen::Matrix<double, 1, 1> static_second_moment<1>(const Sheets&, double);
template Eigen::Matrix<double, 2, 2> static_second_moment<2>(const Sheets&, double);

}  // namespace stoss::bodies::plate
