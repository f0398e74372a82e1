#include "impact/oblique/rings/ring_slide.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/response.hpp"
#include "contact/touch.hpp"
#include "impact/oblique/rings/ring_friction.hpp"

namespace stoss {

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

RingSlide::RingSlide(const Contact& contact, const Contact& along, double speed, const FixedResolution& resolution,
                     const Poll& poll)
    : RingSlide(contact, along, speed, resolution,
                contact_grid(along, contact_grid(contact, resolution.half_width, resolution.nodes).points), poll) {}

RingSlide::RingSlide(const Contact& contact, const Contact& along, double speed, const FixedResolution& resolution,
                     const ContactGrid& grid, const Poll& poll)
    : frame_(contact, speed, {}),
      step_(resolution.step),
      ratio_(touch(along).softness / touch(contact).softness),
      modes_(along, grid, step_, follows_at_once(along, resolution.tail) ? Kicks::weaker : Kicks::whole),
      residuals_(along, grid, ResidualMotion::Inertia::all, step_, poll) {
  const auto arms_of = arms(contact, grid.points);
  for (std::size_t k = 0; k < arm_.size(); ++k) arm_[k] = vector_of(arms_of[k]);
  const std::vector<double> compliance = residuals_.compliance(poll);
  const auto rings = static_cast<Index>(grid.points.count);
  compliance_ = Eigen::MatrixXd::Map(compliance.data(), rings, rings);
}

AlongOutcome RingSlide::after(const std::vector<OutwardStep>& steps, const std::vector<OutwardStep>* outward,
                              double friction, const AlongOutcome& before, double sliding, const Poll& poll) const {
  // A ring that does not slide outward creeps by as little as this.
  constexpr double creep = 3e-3;
  const double least = creep * std::abs(sliding) * step_;
  const Index count = compliance_.rows();
  KeptModes modes = modes_;
  Residuals residuals = residuals_;
  RingFriction law(compliance_);
  AlongOutcome now = before;
  double centre = 0.0;
  std::array<double, 2> turned{};
  VectorXd force = VectorXd::Zero(count), place = force;
  RingLimits rings{force, force, force, force};
  std::vector<double> kept(static_cast<std::size_t>(count)), moved = kept, forces = kept;
  const auto kick = [&] {
    const double half = 0.5 * step_;
    now.tangential -= half * force.sum() / frame_.mass_along;
    for (std::size_t k = 0; k < 2; ++k) {
      if (frame_.inertia[k] > 0.0) now.spin[k] -= half * force.dot(arm_[k]) / frame_.inertia[k];
    }
  };
  const auto advance = [&](const OutwardStep& step, const OutwardStep* rough) {
    kick();
    centre += now.tangential * step_;
    for (std::size_t k = 0; k < 2; ++k) turned[k] += now.spin[k] * step_;
    modes.advance();
    std::fill(kept.begin(), kept.end(), 0.0);
    modes.add_displacement(kept);
    const VectorXd at =
        VectorXd::Map(kept.data(), count).array() + centre + turned[0] * arm_[0].array() + turned[1] * arm_[1].array();
    const VectorXd rest = vector_of(residuals.predict());
    set_limits(step, rough, friction, least, rings);
    law.solve(ratio_ * step.give, at - rest - place, rings, force);
    VectorXd::Map(moved.data(), count) = rest + compliance_ * force;
    VectorXd::Map(forces.data(), count) = force;
    place = at - VectorXd::Map(moved.data(), count);
    residuals.move(moved, forces, forces.size());
    modes.load(forces, forces.size());
    kick();
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (poll) poll();
    advance(steps[k], outward != nullptr && k < outward->size() ? &(*outward)[k] : nullptr);
  }
  return now;
}

}  // namespace stoss
