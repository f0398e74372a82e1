#include "bodies/surface/residual.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "numeric/cosine_integral.hpp"
#include "numeric/dense.hpp"
#include "numeric/quadrature.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {
namespace {

/// Calls visit(k, length, weight) for the wave numbers of a quadrature, whose weights are ½ length · weight, of what is
/// smooth over factors of 2, from 0 on altogether, but for products of two shapes at distances up to the farthest.
template <typename Visit>
void for_wave_numbers(double begin, double end, double farthest, const Visit& visit) {
  constexpr double phase = 16.0;  // by which a product of two shapes turns in a panel
  const auto& rule = numeric::gauss_legendre(16);
  const double widest = 0.5 * phase / farthest;
  for (double from = begin; from < end;) {
    const double to = std::min({end, from > 0.0 ? 2.0 * from : widest, from + widest});
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      visit(0.5 * (from + to) + 0.5 * (to - from) * rule.node[i], to - from, rule.weight[i]);
    }
    from = to;
  }
}

/// Points that are equally spaced in angle lie closer to each other the further out they are: each pair has the wave
/// numbers that its own distance resolves. High ones add C cos(kΔr)/k, so the change from the common end K is
/// C [Ci(π|i−j|) − Ci(KΔr)], of a point by itself −C ln cos α.
/// @param distance of each point from the axis
/// @param visit receives i, j ≤ i, and the bracket
template <typename Visit>
void for_pairs_beyond(const ContactPoints& points, const std::vector<double>& distance, double highest,
                      const Visit& visit) {
  std::vector<double> wanted{0.0};
  for (std::size_t k = 1; k < points.count; ++k) {
    wanted.push_back(numeric::cosine_integral(std::numbers::pi * static_cast<double>(k)));
  }
  for (std::size_t i = 0; i < points.count; ++i) {
    visit(i, i, -std::log(std::cos(points.angle(i))));
    for (std::size_t j = 0; j < i; ++j) {
      visit(i, j, wanted[i - j] - numeric::cosine_integral(highest * (distance[i] - distance[j])));
    }
  }
}

std::vector<double> lateral_distances(const ContactPoints& points) {
  std::vector<double> all(points.count);
  for (std::size_t i = 0; i < points.count; ++i) all[i] = lateral_distance(points, i);
  return all;
}

using Matrix = numeric::SymmetricProducts::Matrix;
using Eigen::Index;

/// Σ weight · s sᵀ over rows s of shapes.
class ShapeProducts {
 public:
  ShapeProducts(const MediumSurface& medium, const ContactPoints& points, const Poll& poll)
      : medium_(medium), distance_(lateral_distances(points)), products_(points.count, poll) {}

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
  const std::vector<double> distance = lateral_distances(points);
  const auto strength = [&](std::size_t i, std::size_t j) {
    const double line = medium.softness / std::numbers::pi;
    if (medium.contour == Contour::cylinder) return line;
    return line / (std::numbers::pi * std::sqrt(distance[i] * distance[j]));
  };
  for_pairs_beyond(points, distance, highest, [&](std::size_t i, std::size_t j, double change) {
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

namespace {

using Block = numeric::SymmetricProducts::Matrix;
using Eigen::Index;

/// Σ over wave numbers of R_11 c cᵀ, R_12 c sᵀ and R_22 s sᵀ with c = (cos ky | 0), s = (0 | sin ky), or J₀ and J₁ of
/// kr, where the components are in the order of a parity.
class PlaneProducts {
 public:
  PlaneProducts(const MediumSurface& medium, Parity parity, const ContactPoints& points, const Poll& poll)
      : medium_(medium),
        parity_(parity),
        points_(static_cast<Index>(points.count)),
        distance_(lateral_distances(points)),
        along_(Eigen::RowVectorXd::Zero(2 * points_)),
        across_(Eigen::RowVectorXd::Zero(2 * points_)),
        products_(2 * points.count, poll) {}

  void add(double wave_number, const Flexibility& response) {
    const bool even = parity_ == Parity::normal_even;
    const double first = even ? response.radial : response.tangential;
    const double second = even ? response.tangential : response.radial;
    const double mixed = even ? response.mixed : -response.mixed;
    for (Index i = 0; i < points_; ++i) {
      const double phase = wave_number * distance_[static_cast<std::size_t>(i)];
      along_(i) = medium_.shape(phase);
      across_(points_ + i) = medium_.slope(phase);
    }
    products_.start();
    products_.shape() = along_;
    products_.load() = first * along_ + mixed * across_;
    products_.start();
    products_.shape() = across_;
    products_.load() = mixed * along_ + second * across_;
  }

  /// Adds ∫ response(k) dk, which is smooth over factors of 2.
  template <typename Response>
  void add_range(double begin, double end, const Response& response) {
    for_wave_numbers(begin, end, distance_.back(), [&](double k, double length, double share) {
      const double weight = 0.5 * length * share;
      const Flexibility at = response(k);
      add(k, {weight * at.radial, weight * at.mixed, weight * at.tangential});
    });
  }

  [[nodiscard]] Block sum() { return products_.sum(); }

 private:
  const MediumSurface& medium_;
  Parity parity_;
  Index points_;
  std::vector<double> distance_;
  Eigen::RowVectorXd along_, across_;  // c and s
  numeric::SymmetricProducts products_;
};

std::vector<double> values_of(const Block& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

/// High wave numbers add C cos(kΔr)/k to both directions by themselves; what they add to the mixed response,
/// C sin(kΔr)/k, hardly changes.
void resolve_pairs_in_plane(const MediumSurface& medium, const ContactPoints& points, double highest, Block& sum) {
  const std::vector<double> distance = lateral_distances(points);
  for_pairs_beyond(points, distance, highest, [&](std::size_t i, std::size_t j, double change) {
    const double rings = std::numbers::pi * std::sqrt(distance[i] * distance[j]);
    const double spread = medium.contour == Contour::ball ? rings : 1.0;
    for (const std::size_t component : {std::size_t{0}, points.count}) {
      const auto row = static_cast<Index>(component + i), column = static_cast<Index>(component + j);
      sum(row, column) += medium.softness * change / std::numbers::pi / spread;
      sum(column, row) = sum(row, column);
    }
  });
}

}  // namespace

PlaneResidual::PlaneResidual(PlaneSurface surface, double cutoff, std::shared_ptr<const std::vector<PlaneWaves>> waves)
    : surface_(std::move(surface)), highest_moment_(8.0 * cutoff), waves_(std::move(waves)) {}

std::vector<double> PlaneResidual::compliance(Parity parity, const ContactPoints& points, const Poll& poll) const {
  const double highest = std::numbers::pi / (points.spacing * points.radius);
  PlaneProducts products(surface_.medium, parity, points, poll);
  for (const PlaneWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_compliance);
  products.add_range(surface_.highest_kept, highest, surface_.compliance);
  Block sum = products.sum();
  resolve_pairs_in_plane(surface_.medium, points, highest, sum);
  return values_of(sum);
}

std::vector<double> PlaneResidual::second_moment(Parity parity, const ContactPoints& points, const Poll& poll) const {
  PlaneProducts products(surface_.medium, parity, points, poll);
  for (const PlaneWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_second_moment);
  products.add_range(surface_.highest_kept, highest_moment_, surface_.second_moment);
  return values_of(products.sum());
}

}  // namespace stoss::bodies
