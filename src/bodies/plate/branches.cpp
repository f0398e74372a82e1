#include "bodies/plate/branches.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

#include "bodies/plate/slab.hpp"

namespace stoss::bodies::plate {
namespace {

/// All layers, from the lower face up.
template <int N, typename T>
Face<T, N> stack(const Sheets& sheets, double k, T z) {
  Face<T, N> face;
  for (std::size_t i = sheets.all.size(); i-- > 0;) {
    face = layer_face<N, T>(sheets.all[i], k, z, [&](const auto& slab) {
      if (i + 1 < sheets.all.size() || sheets.floor == Floor::free) return stacked(face, slab);
      if (sheets.floor == Floor::antisymmetric) return held_below(slab, 0);
      return N == 1 ? stacked(face, slab) : held_below(slab, N - 1);
    });
  }
  return face;
}

/// Of a matrix of pairs a + bε, a or b.
template <typename T, int N, typename Part>
Eigen::Matrix<double, N, N> part_of(const SmallMatrix<T, N>& matrix, Part part) {
  return Eigen::Matrix<double, N, N>::NullaryExpr(
      [&](Eigen::Index i, Eigen::Index j) { return matrix(static_cast<int>(i), static_cast<int>(j)).*part; });
}

template <int N, int Square>
Eigen::Matrix<double, N, N> first(const SmallMatrix<PairNumber<Square>, N>& matrix) {
  return part_of(matrix, &PairNumber<Square>::a);
}

template <int N, int Square>
Eigen::Matrix<double, N, N> second(const SmallMatrix<PairNumber<Square>, N>& matrix) {
  return part_of(matrix, &PairNumber<Square>::b);
}

double determinant(const Eigen::Matrix<double, 1, 1>& matrix) { return matrix(0, 0); }
double determinant(const Eigen::Matrix<double, 2, 2>& matrix) { return matrix.determinant(); }

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

  /// A root of the determinant of the face, and the face there with its derivative by z.
  struct Root {
    double omega;
    SmallMatrix<Differentiable, N> face;
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
    constexpr double beyond = 1e-6;  // of a root
    const Probe end = probe(cutoff);
    Probe last{0.0, 0, 0};
    const std::vector<Root> roots = near_guesses(cutoff);
    const int number = static_cast<int>(roots.size());
    // As many roots as there are modes are all of them.
    if (number > 0 && number < end.modes) last = probe(std::min((1.0 + beyond) * roots.back().omega, cutoff));
    if (number == end.modes || number == last.modes) {
      for (const Root& root : roots) add(root);
    } else {
      last = {0.0, 0, 0};
    }
    if (number != end.modes) isolate(last, end);
  }

  /// Roots that Newton's method finds from the guesses, up to the first that it does not.
  [[nodiscard]] std::vector<Root> near_guesses(double cutoff) const {
    constexpr double apart = 1e-5;
    std::vector<Root> roots;
    for (const double guess : guess_) {
      const double low = roots.empty() ? 0.0 : (1.0 + apart) * roots.back().omega;
      const std::optional<Root> root = root_from(guess, low, cutoff);
      if (!root) break;
      roots.push_back(*root);
    }
    return roots;
  }

  void isolate(const Probe& low, const Probe& high) {
    constexpr double apart = 1e-7, nearest = 1e-12;  // of modes that need not, and that cannot be told from each other
    const int modes = high.modes - low.modes;
    if (modes <= 0) return;
    if (modes == 1 && low.held == high.held) return add(root_between(low.omega, high.omega));
    const double middle = 0.5 * (low.omega + high.omega), width = high.omega - low.omega;
    if (width < nearest * middle || (width < apart * middle && modes == within(middle, 25.0 * width))) {
      return add_cluster(middle, width, modes);
    }
    const Probe between = probe(middle);
    isolate(low, between);
    isolate(between, high);
  }

  /// Number of modes nearer to a frequency than some distance.
  [[nodiscard]] int within(double omega, double distance) const {
    return probe(omega + distance).modes - probe(omega - distance).modes;
  }

  [[nodiscard]] Root root_between(double low, double high) const {
    if (const std::optional<Root> root = root_from(0.5 * (low + high), low, high)) return *root;
    constexpr int bits = 51;
    std::uintmax_t evaluations = 100;
    const auto function = [this](double omega) { return determinant(stack<N>(sheets_, k_, omega * omega).stiffness); };
    const auto [from, to] = boost::math::tools::toms748_solve(
        function, low, high, boost::math::tools::eps_tolerance<double>(bits), evaluations);
    const double z = 0.25 * (from + to) * (from + to);
    return {std::sqrt(z), stack<N>(sheets_, k_, Differentiable{z, 1.0}).stiffness};
  }

  /// By Newton's method, unless it leaves the frequencies between two.
  [[nodiscard]] std::optional<Root> root_from(double guess, double low, double high) const {
    constexpr int most = 8;
    constexpr double close = 1e-12;  // the step from there ends at rounding
    double z = guess * guess;
    for (int n = 0; n < most && z > low * low && z < high * high; ++n) {
      auto face = stack<N>(sheets_, k_, Differentiable{z, 1.0}).stiffness;
      const Differentiable value = determinant(face);
      // Of both roots of the determinant of Q + Q′ step, Q′ definite, that at which it has the slope of this side.
      const double curvature = N == 1 ? 0.0 : determinant(second(face));
      const double both = std::sqrt(std::max(value.b * value.b - 4.0 * curvature * value.a, 0.0));
      const double step = -2.0 * value.a / (value.b + std::copysign(both, value.b));
      z += step;
      if (std::abs(step) < close * z && z > low * low && z < high * high) {
        face = matrix_of<N>([&](int i, int j) { return face(i, j) + step * face(i, j).b; });
        return Root{std::sqrt(z), face};
      }
    }
    return {};
  }

  void add(const Root& root) {
    const double slope = determinant(root.face).b;
    const Matrix stiffness = first(root.face);
    Vector amplitude;
    if constexpr (N == 1) {
      amplitude(0) = std::sqrt(std::max(-1.0 / slope, 0.0));
    } else {
      // The residue −adj(Q)/det′ is φφᵀ.
      const double across = stiffness(1, 1) / -slope, depth = stiffness(0, 0) / -slope;
      amplitude = {std::sqrt(std::max(across, 0.0)), std::sqrt(std::max(depth, 0.0))};
      if (stiffness(0, 1) / slope < 0.0) amplitude(0) = -amplitude(0);
    }
    found_.omega.push_back(root.omega);
    found_.amplitude.push_back(amplitude);
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
    constexpr int places = 5;
    constexpr double share = 0.05;  // of the radius, in that of the next singularity at least
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
  const SmallMatrix<double, N> its = inverse(stack<N>(sheets, wave_number, 0.0).stiffness);
  return Eigen::Matrix<double, N, N>::NullaryExpr(
      [&](Eigen::Index i, Eigen::Index j) { return its(static_cast<int>(i), static_cast<int>(j)); });
}

template <int N>
Eigen::Matrix<double, N, N> static_second_moment(const Sheets& sheets, double wave_number) {
  return second(inverse(stack<N>(sheets, wave_number, Differentiable{0.0, 1.0}).stiffness));
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
