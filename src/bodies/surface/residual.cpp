#include "bodies/surface/residual.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "bodies/surface/wave_sums.hpp"
#include "numeric/symmetric_products.hpp"

namespace stoss::bodies {
namespace {

using Matrix = numeric::SymmetricProducts::Matrix;
using Eigen::Index;

/// Σ weight · s sᵀ over rows s of shapes.
class ShapeProducts {
 public:
  ShapeProducts(const MediumSurface& medium, const ContactPoints& points, const Poll& poll)
      : medium_(medium), distance_(points.count), products_(points.count, poll) {
    for (std::size_t i = 0; i < points.count; ++i) distance_[i] = lateral_distance(points, i);
  }

  void add(double wave_number, double weight) {
    products_.start();
    auto shape = products_.shape();
    for (std::size_t i = 0; i < distance_.size(); ++i) {
      shape(static_cast<Index>(i)) = medium_.shape(wave_number * distance_[i]);
    }
    products_.load() = weight * shape;
  }

  /// Adds ∫ weight(k) s sᵀ dk, for a weight that is smooth over factors of 2.
  template <typename Weight>
  void add_range(double begin, double end, const Weight& weight) {
    for_wave_numbers(begin, end, distance_.back(),
                     [&](double k, double length, double share) { add(k, weight(k) * 0.5 * length * share); });
  }

  [[nodiscard]] Matrix sum() { return products_.sum(); }

 private:
  const MediumSurface& medium_;
  std::vector<double> distance_;
  numeric::SymmetricProducts products_;
};

std::vector<double> values(const Matrix& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

void resolve_each_pair(const MediumSurface& medium, const ContactPoints& points, double highest, Matrix& sum) {
  const auto strength = [&](std::size_t i, std::size_t j) {
    const double line = medium.softness / std::numbers::pi;
    if (medium.contour == Contour::cylinder) return line;
    return line / (std::numbers::pi * std::sqrt(lateral_distance(points, i) * lateral_distance(points, j)));
  };
  for_pairs_beyond(points, highest, [&](std::size_t i, std::size_t j, double change) {
    const auto row = static_cast<Index>(i), column = static_cast<Index>(j);
    sum(row, column) += strength(i, j) * change;
    sum(column, row) = sum(row, column);
  });
}

}  // namespace

double lateral_distance(const ContactPoints& points, std::size_t i) {
  return points.radius * std::sin(points.angle(i));
}

WaveResidual::WaveResidual(MediumSurface medium, double cutoff, double highest_kept,
                           std::shared_ptr<const std::vector<SurfaceWaves>> waves)
    : medium_(std::move(medium)),
      highest_kept_(highest_kept),
      highest_moment_(8.0 * cutoff),
      waves_(std::move(waves)) {}

std::vector<double> WaveResidual::compliance(const ContactPoints& points, const Poll& poll) const {
  const double highest = std::numbers::pi / (points.spacing * points.radius);
  ShapeProducts products(medium_, points, poll);
  for (const SurfaceWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_compliance);
  products.add_range(highest_kept_, highest, medium_.compliance);
  Matrix sum = products.sum();
  resolve_each_pair(medium_, points, highest, sum);
  return values(sum);
}

std::vector<double> WaveResidual::second_moment(const ContactPoints& points, const Poll& poll) const {
  ShapeProducts products(medium_, points, poll);
  for (const SurfaceWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_second_moment);
  products.add_range(highest_kept_, highest_moment_, medium_.second_moment);
  return values(products.sum());
}

double WaveResidual::stable_step() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const SurfaceWaves& waves : *waves_) {
    double kept = 0.0;
    for (const double strength : waves.strength) kept += strength;
    smallest = std::min(smallest, 0.9 * waves.residual_compliance / kept);
  }
  return std::sqrt(smallest);
}

}  // namespace stoss::bodies
