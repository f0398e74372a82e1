#include "impact/oblique/ring_slide.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/response.hpp"
#include "contact/touch.hpp"
#include "impact/oblique/ring_friction.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

VectorXd vector_of(const std::vector<double>& values) {
  return VectorXd::Map(values.data(), static_cast<Index>(values.size()));
}

/// Sets the limits along y and the outward slips of rings under the pressures of a step, as far as those of another
/// step with the same friction leave them.
/// @param least slip
void limits_of(const OutwardStep& step, const OutwardStep* outward, double friction, double least, VectorXd& limit,
               VectorXd& reach) {
  constexpr double rounding = 1e-9;
  limit = friction * step.force;
  reach.setConstant(least);
  if (outward == nullptr) return;
  for (Index i = 0; i < limit.size(); ++i) {
    if (!(outward->force(i) > 0.0)) continue;
    const double taken = std::abs(outward->friction(i)) / (friction * outward->force(i));
    if (taken >= 1.0 - rounding) {
      reach(i) = std::max(least, std::abs(outward->slip(i)));
    } else {
      limit(i) *= std::sqrt((1.0 - taken) * (1.0 + taken));
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
  const std::vector<double> compliance = residuals_.compliance();
  const auto rings = static_cast<Index>(grid.points.count);
  compliance_ = Eigen::MatrixXd::Map(compliance.data(), rings, rings);
}

AlongOutcome RingSlide::after(const std::vector<OutwardStep>& steps, const std::vector<OutwardStep>* outward,
                              double friction, const AlongOutcome& before, double sliding, const Poll& poll) const {
  // A ring that does not slide outward creeps by as little as this.
  constexpr double creep = 3e-3;
  const double least = creep * std::abs(sliding) * step_;
  const Index rings = compliance_.rows();
  KeptModes modes = modes_;
  Residuals residuals = residuals_;
  RingFriction law(compliance_);
  AlongOutcome now = before;
  double centre = 0.0;
  std::array<double, 2> turned{};
  VectorXd force = VectorXd::Zero(rings), place = force, limit = force, reach = force;
  std::vector<double> kept(static_cast<std::size_t>(rings)), moved = kept, forces = kept;
  const auto kick = [&] {
    const double half = 0.5 * step_;
    now.tangential -= half * force.sum() / frame_.mass;
    for (std::size_t k = 0; k < 2; ++k) {
      if (frame_.inertia[k] > 0.0) now.spin[k] -= half * force.dot(arm_[k]) / frame_.inertia[k];
    }
  };
  const auto advance = [&](const OutwardStep& step, const OutwardStep* slipping) {
    kick();
    centre += now.tangential * step_;
    for (std::size_t k = 0; k < 2; ++k) turned[k] += now.spin[k] * step_;
    modes.advance();
    std::fill(kept.begin(), kept.end(), 0.0);
    modes.add_displacement(kept);
    const VectorXd at =
        VectorXd::Map(kept.data(), rings).array() + centre + turned[0] * arm_[0].array() + turned[1] * arm_[1].array();
    const VectorXd rest = vector_of(residuals.predict());
    limits_of(step, slipping, friction, least, limit, reach);
    law.solve(ratio_ * step.give, at - rest - place, limit, reach, force);
    VectorXd::Map(moved.data(), rings) = rest + compliance_ * force;
    VectorXd::Map(forces.data(), rings) = force;
    place = at - VectorXd::Map(moved.data(), rings);
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
