#include "bodies/half_space/plane/residual.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bodies/half_space/residual.hpp"
#include "numeric/gauss_legendre.hpp"
#include "numeric/special_functions.hpp"

namespace stoss::bodies::half_space {
namespace {

using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Index;

/// Σ over wave numbers of R_11 c cᵀ, R_12 c sᵀ and R_22 s sᵀ with c = (cos ky | 0), s = (0 | sin ky), where the
/// components are in the order of a parity.
class PlaneProducts {
 public:
  PlaneProducts(Parity parity, const ContactPoints& points, const Poll& poll)
      : parity_(parity),
        poll_(poll),
        points_(static_cast<Index>(points.count)),
        distance_(points.count),
        sum_(Block::Zero(2 * points_, 2 * points_)),
        shape_(2 * block, 2 * points_),
        load_(2 * block, 2 * points_) {
    for (std::size_t i = 0; i < points.count; ++i) distance_[i] = lateral_distance(points, i);
    shape_.setZero();
  }

  void add(double wave_number, const Flexibility& response) {
    const bool even = parity_ == Parity::normal_even;
    const double first = even ? response.radial : response.tangential;
    const double second = even ? response.tangential : response.radial;
    const double mixed = even ? response.mixed : -response.mixed;
    const Index c = 2 * rows_, s = c + 1;
    for (Index i = 0; i < points_; ++i) {
      const double phase = wave_number * distance_[static_cast<std::size_t>(i)];
      shape_(c, i) = std::cos(phase);
      shape_(s, points_ + i) = std::sin(phase);
    }
    load_.row(c) = first * shape_.row(c) + mixed * shape_.row(s);
    load_.row(s) = mixed * shape_.row(c) + second * shape_.row(s);
    if (++rows_ == block) flush();
  }

  /// Adds ∫ response(k) dk, which is smooth over factors of 2.
  template <typename Response>
  void add_range(double begin, double end, Response response) {
    constexpr double phase = 16.0;  // by which a product of two shapes turns in a panel
    const auto& rule = numeric::gauss_legendre(16);
    const double widest = 0.5 * phase / distance_.back();
    for (double from = begin; from < end;) {
      const double to = std::min({end, 2.0 * from, from + widest});
      for (std::size_t i = 0; i < rule.node.size(); ++i) {
        const double k = 0.5 * (from + to) + 0.5 * (to - from) * rule.node[i];
        const double weight = 0.5 * (to - from) * rule.weight[i];
        const Flexibility at = response(k);
        add(k, {weight * at.radial, weight * at.mixed, weight * at.tangential});
      }
      from = to;
    }
  }

  [[nodiscard]] Block& sum() {
    flush();
    return sum_;
  }

 private:
  static constexpr Index block = 32;

  void flush() {
    if (poll_) poll_();
    sum_.noalias() += shape_.topRows(2 * rows_).transpose() * load_.topRows(2 * rows_);
    rows_ = 0;
  }

  Parity parity_;
  const Poll& poll_;
  Index points_;
  std::vector<double> distance_;
  Block sum_, shape_, load_;
  Index rows_ = 0;
};

std::vector<double> values_of(const Block& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

/// As for one direction (Residual): each pair of points has the wave numbers that its own distance resolves. High ones
/// add cos(kΔr)/πk to both directions by themselves; what they add to the mixed response, sin(kΔr)/πk, hardly changes.
void resolve_each_pair(const ContactPoints& points, double highest, Block& sum) {
  const auto count = static_cast<Index>(points.count);
  const auto add = [&](Index i, Index j, double change) {
    for (const Index component : {Index{0}, count}) {
      sum(component + i, component + j) += change / std::numbers::pi;
      if (i != j) sum(component + j, component + i) = sum(component + i, component + j);
    }
  };
  for (Index i = 0; i < count; ++i) {
    const auto node = static_cast<std::size_t>(i);
    const double here = lateral_distance(points, node);
    add(i, i, -std::log(std::cos(points.angle(node))));
    for (Index j = 0; j < i; ++j) {
      const double apart = here - lateral_distance(points, static_cast<std::size_t>(j));
      add(i, j,
          numeric::cosine_integral(std::numbers::pi * static_cast<double>(i - j)) -
              numeric::cosine_integral(highest * apart));
    }
  }
}

}  // namespace

PlaneResidual::PlaneResidual(const Medium& medium, double cutoff, std::shared_ptr<const std::vector<PlaneWaves>> waves)
    : medium_(medium),
      highest_kept_(cutoff / (medium.kernel.rayleigh_root * medium.shear_speed)),
      highest_moment_(8.0 * cutoff),
      waves_(std::move(waves)) {}

std::vector<double> PlaneResidual::compliance(Parity parity, const ContactPoints& points, const Poll& poll) const {
  const double highest = std::numbers::pi / (points.spacing * points.radius);
  PlaneProducts products(parity, points, poll);
  for (const PlaneWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_compliance);
  products.add_range(highest_kept_, highest, [this](double k) { return plane_compliance(medium_, k); });
  Block& sum = products.sum();
  resolve_each_pair(points, highest, sum);
  return values_of(sum);
}

std::vector<double> PlaneResidual::second_moment(Parity parity, const ContactPoints& points, const Poll& poll) const {
  PlaneProducts products(parity, points, poll);
  for (const PlaneWaves& waves : *waves_) products.add(waves.wave_number, waves.residual_second_moment);
  products.add_range(highest_kept_, highest_moment_, [this](double k) { return plane_second_moment(medium_, k); });
  return values_of(products.sum());
}

}  // namespace stoss::bodies::half_space
