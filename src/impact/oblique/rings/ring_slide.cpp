#include "impact/oblique/rings/ring_slide.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double end_of_table = 4.0;
constexpr int per_unit = 64;
constexpr std::size_t entries = static_cast<std::size_t>(end_of_table) * per_unit + 1;

std::array<double, entries> tabulated() {
  constexpr int directions = 512;
  std::array<double, entries> table{};
  for (std::size_t k = 1; k < entries; ++k) {
    const double x = static_cast<double>(k) / per_unit;
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
      const double c = std::cos((i + 0.5) * std::numbers::pi / directions);
      sum += (x + c) / std::sqrt(1.0 + 2.0 * x * c + x * x);
    }
    table[k] = sum / directions;
  }
  return table;
}

}  // namespace

RingMean ring_mean(double x) {
  static const std::array<double, entries> table = tabulated();
  const double size = std::abs(x), sign = x < 0.0 ? -1.0 : 1.0;
  if (size >= end_of_table) {
    // 1 − 1/4x² − 3/64x⁴ − …
    const double square = 1.0 / (size * size);
    return {sign * (1.0 - square * (0.25 + square * (3.0 / 64.0 + square * 5.0 / 256.0))),
            square / size * (0.5 + square * (3.0 / 16.0 + square * 15.0 / 128.0))};
  }
  const double at = size * per_unit;
  const std::size_t k = std::min(static_cast<std::size_t>(at), entries - 2);
  const double slope = table[k + 1] - table[k];
  return {sign * (table[k] + (at - static_cast<double>(k)) * slope), per_unit * slope};
}

RingMean ring_law(const RingLimits& rings, Index i, double ratio) {
  const RingMean held = ring_mean(ratio);
  const double share = rings.share(i), slower = rings.free(i) > 0.0 ? rings.reach(i) / rings.free(i) : 0.0;
  if (share == 1.0 && slower <= 1.0) return held;
  const RingMean loose = ring_mean(ratio * slower);
  if (std::abs(loose.value) > share * std::abs(held.value)) return {loose.value, slower * loose.slope};
  return {share * held.value, share * held.slope};
}

RingFriction::RingFriction(Eigen::MatrixXd compliance)
    : compliance_(std::move(compliance)), ratio_(VectorXd::Zero(compliance_.rows())) {}

/// Fills what is left of the equations, over R + |free|. @return its largest value
double RingFriction::miss(const RingLimits& rings, const VectorXd& ratio) {
  for (Index i = 0; i < touching_; ++i) {
    const RingMean mean = ring_law(rings, i, ratio(i));
    friction_(i) = rings.limit(i) * mean.value;
    slope_(i) = rings.limit(i) * mean.slope;
  }
  left_.noalias() = -compliance_.topLeftCorner(touching_, touching_) * friction_;
  left_.array() += start_.array() - rings.reach.head(touching_).array() * ratio.head(touching_).array() -
                   give_.array() * friction_.array();
  return left_.cwiseAbs().maxCoeff();
}

void RingFriction::solve(const VectorXd& give, const VectorXd& free, const RingLimits& rings, VectorXd& force) {
  constexpr int most = 60, halvings = 12;
  constexpr double tolerance = 1e-7, least = 1e-12;
  touching_ = force.size();
  while (touching_ > 0 && !(rings.limit(touching_ - 1) > 0.0)) --touching_;
  ratio_.tail(force.size() - touching_).setZero();
  if (touching_ == 0) {
    force.setZero();
    return;
  }
  give_ = give.head(touching_);
  start_ = free.head(touching_) + give_.cwiseProduct(force.head(touching_));
  friction_.resize(touching_), slope_.resize(touching_);
  const double scale = start_.cwiseAbs().maxCoeff() + rings.reach.head(touching_).maxCoeff();
  double size = miss(rings, ratio_);
  for (int round = 0; round < most && size > tolerance * scale; ++round) {
    // In the change of friction the matrix is symmetric.
    matrix_ = compliance_.topLeftCorner(touching_, touching_);
    for (Index i = 0; i < touching_; ++i) {
      slope_(i) = std::max(slope_(i), least * rings.limit(i)) + std::numeric_limits<double>::min();
      matrix_(i, i) += give_(i) + rings.reach(i) / slope_(i);
    }
    Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factored(matrix_);
    step_ = factored.solve(left_).cwiseQuotient(slope_);
    double share = 1.0;
    for (int k = 0; k < halvings; ++k, share *= 0.5) {
      trial_ = ratio_;
      trial_.head(touching_) += share * step_;
      const double now = miss(rings, trial_);
      if (now < size || k + 1 == halvings) {
        size = now;
        break;
      }
    }
    ratio_ = trial_;
  }
  force.head(touching_) = friction_;
  force.tail(force.size() - touching_).setZero();
}

using Eigen::Index;
using Eigen::VectorXd;

namespace {

VectorXd vector_of(const std::vector<double>& values) {
  return VectorXd::Map(values.data(), static_cast<Index>(values.size()));
}

/// Sets what rings under the pressures of a step may do, as far as those of the same step with friction outward leave
/// them.
/// @param least slip outward
void set_limits(const OutwardStep& step, const OutwardStep* rough, double friction, double least, RingLimits& rings) {
  constexpr double rounding = 1e-9;
  rings.limit = friction * step.force;
  rings.share.setOnes();
  rings.reach.setConstant(least);
  rings.free.setZero();
  if (rough == nullptr) return;
  for (Index i = 0; i < rings.limit.size(); ++i) {
    if (!(rough->force(i) > 0.0)) continue;
    const double taken = std::abs(rough->friction(i)) / (friction * rough->force(i));
    if (taken >= 1.0 - rounding) {
      rings.reach(i) = std::max(least, std::abs(rough->slip(i)));
    } else {
      rings.share(i) = std::sqrt((1.0 - taken) * (1.0 + taken));
      rings.free(i) = std::max(least, std::abs(step.slip(i)));
    }
  }
}

}  // namespace

AlongOutcome slide_on_rings(const TangentialResponse& response, const ObliqueFrame& frame,
                            const std::vector<OutwardStep>& steps, const std::vector<OutwardStep>* outward,
                            const Obliquity& before, const Poll& poll) {
  // A ring that does not slide outward creeps by as little as this.
  constexpr double creep = 3e-3;
  const double least =
      creep * std::abs(frame.sliding(before.tangential, before.spin, before.second_spin)) * response.step;
  const auto count = static_cast<Index>(response.arm[0].size());
  TangentialImpact motion(response, frame, before);
  RingFriction law(Eigen::MatrixXd::Map(response.compliance.data(), count, count));
  VectorXd force = VectorXd::Zero(count);
  RingLimits rings{force, force, force, force};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (poll) poll();
    const OutwardStep* rough = outward != nullptr && k < outward->size() ? &(*outward)[k] : nullptr;
    set_limits(steps[k], rough, before.friction, least, rings);
    motion.advance(steps[k].give.data(), response.arm[0].size(),
                   [&](const auto& give, const auto& free, auto& friction) {
                     law.solve(vector_of(give), vector_of(free), rings, force);
                     VectorXd::Map(friction.data(), count) = force;
                   });
  }
  return motion.outcome();
}

}  // namespace stoss
