#include "bodies/surface/plane_residual.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bodies/surface/residual.hpp"
#include "bodies/surface/wave_sums.hpp"
#include "numeric/symmetric_products.hpp"

namespace stoss::bodies {
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
        distance_(points.count),
        along_(Eigen::RowVectorXd::Zero(2 * points_)),
        across_(Eigen::RowVectorXd::Zero(2 * points_)),
        products_(2 * points.count, poll) {
    for (std::size_t i = 0; i < points.count; ++i) distance_[i] = lateral_distance(points, i);
  }

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
  for_pairs_beyond(points, highest, [&](std::size_t i, std::size_t j, double change) {
    const double rings = std::numbers::pi * std::sqrt(lateral_distance(points, i) * lateral_distance(points, j));
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
