#include "restitution/neglected_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact/along.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/recommended.hpp"
#include "restitution/lasting.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Whether no motion tells the one from the other.
bool are_equal(const Contact& contact, double dundurs) {
  if (contact.second == nullptr) return false;
  const Body &one = *contact.first, &other = *contact.second;
  return one.scale.length == other.scale.length && one.scale.speed == other.scale.speed &&
         one.scale.mass == other.scale.mass && one.softness == other.softness && one.loss_time == other.loss_time &&
         one.relaxation == other.relaxation && dundurs == 0.0;
}

/// Cutoff for some 120 steps in contact, on the ladder of those of a contact.
double coarse_cutoff(const RefinableContact& contact, const Contact& probe, double speed) {
  constexpr double periods = 60.0;
  constexpr int lowest = -16, highest = 6;
  const double wanted = periods / expected_duration(probe, speed);
  const int octaves = static_cast<int>(std::lround(2.0 * std::log2(wanted / contact.cutoff(0))));
  const int level = std::clamp(2 * octaves, lowest, highest);
  const bool second = probe.second != nullptr && is_known_at_a_point(*probe.second);
  if (!is_known_at_a_point(*probe.first) && !second) return contact.cutoff(level);
  return contact.cutoff(std::min(level, contact.levels(speed, duration_margin, {}, Directions::oblique).highest));
}

Resolution coarse_resolution(const Contact& contact, double speed) {
  constexpr int rings = 16;
  constexpr double room = 1.1;  // that no friction needs more
  Resolution resolution;
  resolution.step = std::min(0.5 / contact.cutoff, contact.stable_step);
  resolution.half_width = std::min(room * initial_half_width(contact, speed), greatest_half_width(contact));
  resolution.nodes = std::max(rings, nyquist_nodes(contact, *resolution.half_width) + 1);
  return resolution;
}

}  // namespace

NeglectedCoupling::NeglectedCoupling(const RefinableContact& contact, double speed, Poll poll)
    : refinable_(contact), speed_(speed), poll_(std::move(poll)) {}

/// Makes the contacts, and the impact without friction.
void NeglectedCoupling::prepare() {
  prepared_ = true;
  const Contact& probe = refinable_.at(0, poll_);
  dundurs_ = mixing({contact_outward(probe, poll_)});
  if (are_equal(probe, dundurs_)) return;
  if (probe.yield.yield > 0.0) {  // its law has one direction
    contact_ = &probe, impacts_[0.0] = std::nullopt;
    return;
  }
  double stretch = probe.unbounded ? refinable_.stretch(speed_) : 1.0;
  const double cutoff = coarse_cutoff(refinable_, probe, speed_);
  contact_ = &probe;
  try {
    impacts_[0.0] =
        retry_until_contact_ends(refinable_, cutoff, speed_, stretch, poll_, [this](const Contact& resolved) {
          contact_ = &resolved;
          outward_ = contact_outward(resolved, poll_);
          return outward_impact(resolved, *outward_, speed_, 0.0, coarse_resolution(resolved, speed_), poll_);
        });
  } catch (const NotConverged&) {
    impacts_[0.0] = std::nullopt;
    return;
  }
  const FixedResolution& resolution = impacts_[0.0]->resolution;
  const ContactPoints points = contact_grid(*contact_, resolution.half_width, resolution.nodes).points;
  response_.emplace(*contact_, contacts_along(*contact_, poll_).front(), points, resolution, 0, poll_);
}

const std::optional<OutwardImpact>& NeglectedCoupling::outward(double friction) {
  const auto known = impacts_.find(friction);
  if (known != impacts_.end()) return known->second;
  std::optional<OutwardImpact>& impact = impacts_[friction];
  const FixedResolution& resolution = impacts_[0.0]->resolution;
  try {
    OutwardImpact made =
        outward_impact(*contact_, *outward_, speed_, friction, static_cast<Resolution>(resolution), poll_);
    if (made.resolution.half_width == resolution.half_width) impact = std::move(made);
  } catch (const NotConverged&) {  // Coulomb's law is ill-posed there, perhaps
  }
  return impact;
}

Coupling NeglectedCoupling::unknown() const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {dundurs_, none, none, none, none, none, none};
}

Coupling NeglectedCoupling::at(const Obliquity& obliquity) {
  const double friction = obliquity.friction;
  if (friction == 0.0) return {};
  if (!prepared_) prepare();
  if (contact_ == nullptr) return {};
  if (!impacts_[0.0]) return unknown();
  const OutwardImpact& smooth = *impacts_[0.0];
  const std::optional<OutwardImpact>& rough = outward(friction);
  if (!rough) return unknown();
  Coupling change;
  change.dundurs = dundurs_;
  change.restitution = rough->impact.restitution - smooth.impact.restitution;
  const ObliqueFrame frame(*contact_, speed_, {});
  const double sliding = frame.sliding(obliquity.tangential, obliquity.spin, obliquity.second_spin);
  if (sliding == 0.0) return change;
  const auto after = [&](const std::vector<OutwardStep>* outward, double momentum) {
    return frame.settled(slide_on_rings(*response_, frame, smooth.steps, outward, obliquity, poll_), friction,
                         momentum);
  };
  const AlongOutcome alone = after(nullptr, smooth.momentum), coupled = after(&rough->steps, smooth.momentum);
  change.tangential_after = coupled.tangential - alone.tangential;
  change.spin_after = coupled.spin[0] - alone.spin[0];
  change.second_spin_after = coupled.spin[1] - alone.spin[1];
  change.sliding_after = frame.sliding(change.tangential_after, change.spin_after, change.second_spin_after);
  change.tangential_restitution = -change.sliding_after / sliding;
  return change;
}

}  // namespace stoss
