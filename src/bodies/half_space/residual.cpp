#include "bodies/half_space/residual.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "numeric/gauss_legendre.hpp"
#include "numeric/special_functions.hpp"

namespace stoss::bodies::half_space {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Index;

/// Σ weight · s sᵀ over rows s of shapes, some rows at a time.
class ShapeProducts {
 public:
  ShapeProducts(const Medium& medium, const ContactPoints& points, const Poll& poll)
      : medium_(medium),
        poll_(poll),
        distance_(points.count),
        sum_(Matrix::Zero(count(points), count(points))),
        shape_(block, count(points)),
        load_(block, count(points)) {
    for (std::size_t i = 0; i < points.count; ++i) distance_[i] = lateral_distance(points, i);
  }

  void add(double wave_number, double weight) {
    for (std::size_t i = 0; i < distance_.size(); ++i) {
      shape_(rows_, static_cast<Index>(i)) = medium_.shape(wave_number * distance_[i]);
    }
    load_.row(rows_) = weight * shape_.row(rows_);
    if (++rows_ == block) flush();
  }

  /// Adds ∫ weight(k) s sᵀ dk, for a weight that is smooth over factors of 2.
  template <typename Weight>
  void add_range(double begin, double end, Weight weight) {
    constexpr double phase = 16.0;  // by which a product of two shapes turns in a panel
    const auto& rule = numeric::gauss_legendre(16);
    const double widest = 0.5 * phase / distance_.back();
    for (double from = begin; from < end;) {
      const double to = std::min({end, 2.0 * from, from + widest});
      for (std::size_t i = 0; i < rule.node.size(); ++i) {
        const double k = 0.5 * (from + to) + 0.5 * (to - from) * rule.node[i];
        add(k, weight(k) * 0.5 * (to - from) * rule.weight[i]);
      }
      from = to;
    }
  }

  [[nodiscard]] Matrix& sum() {
    flush();
    return sum_;
  }

 private:
  static constexpr Index block = 64;
  static Index count(const ContactPoints& points) { return static_cast<Index>(points.count); }

  void flush() {
    if (poll_) poll_();
    sum_.noalias() += shape_.topRows(rows_).transpose() * load_.topRows(rows_);
    rows_ = 0;
  }

  const Medium& medium_;
  const Poll& poll_;
  std::vector<double> distance_;
  Matrix sum_, shape_, load_;
  Index rows_ = 0;
};

std::vector<double> values(const Matrix& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

/// Points that are equally spaced in angle lie closer to each other the further out they are: each pair has the wave
/// numbers that its own distance resolves. High ones add C cos(kΔr)/k, so the change from the common end K is
/// C [Ci(π|i−j|) − Ci(KΔr)].
void resolve_each_pair(const Medium& medium, const ContactPoints& points, double highest, Matrix& sum) {
  std::vector<double> wanted{0.0};
  for (std::size_t k = 1; k < points.count; ++k) {
    wanted.push_back(numeric::cosine_integral(std::numbers::pi * static_cast<double>(k)));
  }
  const auto strength = [&](double first, double second) {
    const double line = medium.softness / std::numbers::pi;
    return medium.contour == Contour::ball ? line / (std::numbers::pi * std::sqrt(first * second)) : line;
  };
  for (std::size_t i = 0; i < points.count; ++i) {
    const double here = lateral_distance(points, i);
    const auto row = static_cast<Index>(i);
    sum(row, row) -= strength(here, here) * std::log(std::cos(points.angle(i)));
    for (std::size_t j = 0; j < i; ++j) {
      const double there = lateral_distance(points, j);
      const auto column = static_cast<Index>(j);
      const double change = wanted[i - j] - numeric::cosine_integral(highest * (here - there));
      sum(row, column) += strength(here, there) * change;
      sum(column, row) = sum(row, column);
    }
  }
}

}  // namespace

double lateral_distance(const ContactPoints& points, std::size_t i) {
  return points.radius * std::sin(points.angle(i));
}

Residual::Residual(const Medium& medium, double cutoff, std::shared_ptr<const std::vector<SurfaceWaves>> waves)
    : medium_(medium),
      highest_kept_(cutoff / (medium.kernel.rayleigh_root * medium.shear_speed)),
      highest_moment_(8.0 * cutoff),
      waves_(std::move(waves)) {}

std::vector<double> Residual::compliance(const ContactPoints& points, const Poll& poll) const {
  const double highest = std::numbers::pi / (points.spacing * points.radius);
  ShapeProducts products(medium_, points, poll);
  for (const SurfaceWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_compliance);
  products.add_range(highest_kept_, highest, [this](double k) { return medium_.compliance(k); });
  Matrix& sum = products.sum();
  resolve_each_pair(medium_, points, highest, sum);
  return values(sum);
}

std::vector<double> Residual::second_moment(const ContactPoints& points, const Poll& poll) const {
  ShapeProducts products(medium_, points, poll);
  for (const SurfaceWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_second_moment);
  products.add_range(highest_kept_, highest_moment_, [this, moment = medium_.second_moment()](double k) {
    const double unit = medium_.shear_speed * k;
    return medium_.compliance(k) * moment / (unit * unit);
  });
  return values(products.sum());
}

double Residual::stable_step() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const SurfaceWaves& waves : *waves_) {
    double kept = 0.0;
    for (const double strength : waves.strength) kept += strength;
    smallest = std::min(smallest, 0.9 * waves.residual_compliance / kept);
  }
  return std::sqrt(smallest);
}

}  // namespace stoss::bodies::half_space
