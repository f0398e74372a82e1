#include "bodies/plate/branches.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "bodies/plate/slab.hpp"

namespace stoss::bodies::plate {
namespace {

/// All layers, from the lower face up.
template <int N, typename T>
Face<T, N> stack(const Sheets& sheets, double k, T z) {
  Face<T, N> face{Eigen::Matrix<T, N, N>::Zero(), 0};
  for (std::size_t i = sheets.all.size(); i-- > 0;) {
    face = layer_face<N, T>(sheets.all[i], k, z, [&](const auto& slab) {
      if (i + 1 < sheets.all.size() || sheets.floor == Floor::free) return stacked(face, slab);
      if (sheets.floor == Floor::antisymmetric) return held_below(slab, 0);
      return N == 1 ? stacked(face, slab) : held_below(slab, N - 1);
    });
  }
  return face;
}

/// Of a matrix of pairs a + bε.
template <int N, int Square>
Eigen::Matrix<double, N, N> first(const Eigen::Matrix<PairNumber<Square>, N, N>& matrix) {
  return matrix.unaryExpr([](const PairNumber<Square>& x) { return x.a; });
}

template <int N, int Square>
Eigen::Matrix<double, N, N> second(const Eigen::Matrix<PairNumber<Square>, N, N>& matrix) {
  return matrix.unaryExpr([](const PairNumber<Square>& x) { return x.b; });
}

/// The same a little further, by its derivative.
template <int N>
Eigen::Matrix<Differentiable, N, N> moved(const Eigen::Matrix<Differentiable, N, N>& face, double by) {
  return face.unaryExpr([by](const Differentiable& x) { return Differentiable{x.a + x.b * by, x.b}; });
}

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

  Search(const Sheets& sheets, double wave_number, const std::vector<double>& guess)
      : sheets_(sheets), k_(wave_number), guess_(guess) {}

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

  [[nodiscard]] Probe probe(double omega) const {
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
    Probe low{0.0, 0, 0};
    for (std::size_t i = 0; i <= guess_.size(); ++i) {
      const bool last = i == guess_.size();
      const double next = last || i + 1 == guess_.size() ? cutoff : 0.5 * (guess_[i] + guess_[i + 1]);
      if (!last && !(next > low.omega && next < cutoff)) continue;
      const Probe high = probe(last ? cutoff : next);
      isolate(low, high);
      low = high;
    }
  }

  void isolate(const Probe& low, const Probe& high) {
    constexpr double apart = 1e-8;  // of modes that can be told from each other
    const int modes = high.modes - low.modes;
    if (modes <= 0) return;
    const double middle = 0.5 * (low.omega + high.omega);
    if (modes == 1 && low.held == high.held) return add_one(low, high);
    if (high.omega - low.omega < apart * high.omega) return add_cluster(middle, modes);
    const Probe between = probe(middle);
    isolate(low, between);
    isolate(between, high);
  }

  /// The face with its derivative by z, at a root of its determinant between two frequencies.
  [[nodiscard]] Eigen::Matrix<Differentiable, N, N> at_root(const Probe& low, const Probe& high, double& z) const {
    const auto at = [this](double here) { return stack<N>(sheets_, k_, Differentiable{here, 1.0}).stiffness; };
    const auto inside = [&](double here) { return here > low.omega * low.omega && here < high.omega * high.omega; };
    const auto number = static_cast<std::size_t>(low.modes);
    const double guess = number < guess_.size() ? guess_[number] : 0.5 * (low.omega + high.omega);
    z = guess * guess;
    constexpr int most = 8;
    constexpr double close = 1e-12;  // the step from there ends at rounding
    for (int n = 0; n < most && inside(z); ++n) {
      const auto face = at(z);
      const Differentiable determinant = face.determinant();
      const double step = determinant.a / determinant.b;
      z -= step;
      if (std::abs(step) < close * z && inside(z)) return moved<N>(face, -step);
    }
    constexpr int bits = 51;
    std::uintmax_t evaluations = 100;
    const auto determinant = [this](double omega) {
      return stack<N>(sheets_, k_, omega * omega).stiffness.determinant();
    };
    const auto [from, to] = boost::math::tools::toms748_solve(
        determinant, low.omega, high.omega, boost::math::tools::eps_tolerance<double>(bits), evaluations);
    z = 0.25 * (from + to) * (from + to);
    const auto face = at(z);
    const Differentiable left = face.determinant();
    const double step = left.a / left.b;
    z -= step;
    return moved<N>(face, -step);
  }

  void add_one(const Probe& low, const Probe& high) {
    double z = 0.0;
    const auto face = at_root(low, high, z);
    const double slope = Differentiable(face.determinant()).b;
    const Matrix stiffness = first<N>(face);
    Vector amplitude;
    if constexpr (N == 1) {
      amplitude(0) = std::sqrt(std::max(-1.0 / slope, 0.0));
    } else {
      // The residue −adj(Q)/det′ is φφᵀ.
      const double across = stiffness(1, 1) / -slope, depth = stiffness(0, 0) / -slope;
      amplitude = {std::sqrt(std::max(across, 0.0)), std::sqrt(std::max(depth, 0.0))};
      if (stiffness(0, 1) / slope < 0.0) amplitude(0) = -amplitude(0);
    }
    found_.omega.push_back(std::clamp(std::sqrt(std::max(z, 0.0)), low.omega, high.omega));
    found_.amplitude.push_back(amplitude);
  }

  /// Modes that are too close to each other to be told apart: those of the sum of their φφᵀ.
  void add_cluster(double omega, int modes) {
    constexpr int places = 6;
    // Nearer than other modes, and farther than these are from each other.
    const auto alone = [&](double away) {
      return probe(omega * (1.0 + away)).modes - probe(omega * (1.0 - away)).modes;
    };
    double away = 1e-4;
    while (away > 1e-7 && alone(3.0 * away) > modes) away *= 0.2;
    const double center = omega * omega;
    Matrix strength = Matrix::Zero();
    for_circle(away * center, places, [&](const Complex& from) {
      const Eigen::Matrix<Complex, N, N> response = stack<N>(sheets_, k_, center + from).stiffness.inverse();
      strength -= first<N, -1>(from * response) / places;
    });
    const Eigen::SelfAdjointEigenSolver<Matrix> parts(strength);
    for (int i = 0; i < std::min(modes, N); ++i) {
      const Eigen::Index n = N - 1 - i;
      found_.omega.push_back(omega);
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
    constexpr int places = 8;
    constexpr double share = 0.15;  // of the radius, in that of the next singularity at least
    for_circle(share * cutoff * cutoff, places, [&](const Complex& z) {
      Eigen::Matrix<Complex, N, N> response = stack<N>(sheets_, k_, z).stiffness.inverse();
      for (std::size_t m = 0; m < found_.omega.size(); ++m) {
        const Vector& amplitude = found_.amplitude[m];
        const Complex over = 1.0 / (found_.omega[m] * found_.omega[m] - z);
        for (int i = 0; i < N; ++i) {
          for (int j = 0; j < N; ++j) response(i, j) -= amplitude(i) * amplitude(j) * over;
        }
      }
      found_.compliance += first<N, -1>(response) / places;
      found_.second_moment += first<N, -1>((1.0 / z) * response) / places;
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
  Branches<N> found_;
};

}  // namespace

template <int N>
Branches<N> branches(const Sheets& sheets, double wave_number, double cutoff, const std::vector<double>& guess) {
  return Search<N>(sheets, wave_number, guess).below(cutoff);
}

template <int N>
int count_below(const Sheets& sheets, double wave_number, double omega) {
  const auto all = stack<N>(sheets, wave_number, omega * omega);
  return all.held + negative(all.stiffness);
}

template <int N>
Eigen::Matrix<double, N, N> static_compliance(const Sheets& sheets, double wave_number) {
  return stack<N>(sheets, wave_number, 0.0).stiffness.inverse();
}

template <int N>
Eigen::Matrix<double, N, N> static_second_moment(const Sheets& sheets, double wave_number) {
  const Eigen::Matrix<Differentiable, N, N> response =
      stack<N>(sheets, wave_number, Differentiable{0.0, 1.0}).stiffness.inverse();
  return second<N>(response);
}

template Branches<1> branches<1>(const Sheets&, double, double, const std::vector<double>&);
template Branches<2> branches<2>(const Sheets&, double, double, const std::vector<double>&);
template int count_below<1>(const Sheets&, double, double);
template int count_below<2>(const Sheets&, double, double);
template Eigen::Matrix<double, 1, 1> static_compliance<1>(const Sheets&, double);
template Eigen::Matrix<double, 2, 2> static_compliance<2>(const Sheets&, double);
template Eigen::Matrix<double, 1, 1> static_second_moment<1>(const Sheets&, double);
template Eigen::Matrix<double, 2, 2> static_second_moment<2>(const Sheets&, double);

}  // namespace stoss::bodies::plate
