#include "row/meeting.hpp"

#include <algorithm>
#include <numeric>

#include "contact/hard_contact.hpp"
#include "contact/rest.hpp"
#include "contact/touch.hpp"
#include "row/flight.hpp"

namespace stoss {

Meeting::Meeting(const Contact& contact, const FixedResolution& resolution, double speed, const Poll& poll)
    : contact_(contact),
      grid_(contact_grid(contact, resolution.half_width, resolution.nodes)),
      response_(make_response(contact, resolution.tail, grid_, speed, resolution.step, poll)),
      position_(grid_.recess.size()),
      on_second_(grid_.recess.size()),
      first_kick_(stoss::first_kick(contact)) {
  if (contact.second != nullptr) of_second_ = units_of(contact, 1);
}

ContactPoints Meeting::points(int number) const {
  return number == 0 ? grid_.points : seen_by(grid_.points, of_second_);
}

void Meeting::begin(double gap) {
  start_ = (response_->is_long_range() ? -response_->range() : response_->touch()) - gap;
}

double Meeting::approach(const RowSolid& one, Face face, const RowSolid* other) const {
  const double apart = other == nullptr ? one.position() : one.position() - other->position();
  return (face == Face::right ? apart : -apart) / one.units().length;
}

void Meeting::respond(RowSolid& one, Face face, RowSolid* other) {
  compression_ = start_ + approach(one, face, other);
  for (std::size_t i = 0; i < position_.size(); ++i) {
    position_[i] = compression_ - grid_.recess[i] + one.displacement(face, i);
    if (other != nullptr) position_[i] += other->displacement(opposite(face), i) * of_second_.length;
  }
  const std::vector<double>& force = response_->advance(position_);
  const std::size_t extent = response_->extent();
  force_ = std::accumulate(force.begin(), force.begin() + static_cast<std::ptrdiff_t>(extent), 0.0);
  one.load(face, force, extent, force_);
  if (other == nullptr) return;
  for (std::size_t i = 0; i < force.size(); ++i) on_second_[i] = force[i] / of_second_.force;
  other->load(opposite(face), on_second_, extent, force_ / of_second_.force);
}

void Meeting::record(double time, double step) {
  impulse += 0.5 * (before_ + force_) * step;
  before_ = force_;
  greatest_force = std::max(greatest_force, force_);
  greatest_compression = std::max(greatest_compression, compression());
  if (pushes()) {
    greatest_width = std::max(greatest_width, response_->half_width());
    if (first_touch < 0.0) first_touch = time;
    if (!pushed_) ++touches;
    last_touch = time;
  }
  pushed_ = pushes();
}

double Meeting::closing(const RowSolid& one, Face face, const RowSolid* other) const {
  const double apart = one.velocity() - (other == nullptr ? 0.0 : other->velocity());
  return (face == Face::right ? apart : -apart) * one.units().time / one.units().length;
}

bool Meeting::is_still() const {
  constexpr double small = 1e-4;
  return force_ == 0.0 && before_ == 0.0 && stoss::is_still(*response_, small * greatest_compression);
}

void Meeting::rest(double time) { stoss::rest(*response_, time); }

long Meeting::steps_apart(const RowSolid& one, Face face, const RowSolid* other, double step) const {
  const double compression = start_ + approach(one, face, other), stride = step * closing(one, face, other);
  const bool rigid = one.reach(face) == 0.0 && (other == nullptr || other->reach(opposite(face)) == 0.0);
  if (rigid && stride == 0.0 && compression <= response_->touch()) return never;  // they are as they were
  const double range = std::max(response_->range(), 0.0) + response_->protrusion();
  const double place = compression + range + grid_.recess.front();
  return stoss::steps_apart({one, face, other, of_second_.length, grid_.recess, place, stride});
}

bool Meeting::is_clear(const RowSolid& one, Face face, const RowSolid* other) const {
  if (pushes()) return false;
  const double relative = closing(one, face, other);
  if (relative > 0.0) return false;
  const double reach = one.reach(face) + (other == nullptr ? 0.0 : other->reach(opposite(face)) * of_second_.length) +
                       response_->protrusion();
  if (relative == 0.0) return compression_ + reach <= response_->touch();  // they are as they were
  return compression_ + reach < -std::max(response_->range(), 0.0);
}

double Meeting::strain() const {
  constexpr double share = 0.2;
  if (has_single_point(contact_)) return 0.0;
  const double width = greatest_width * grid_.points.spacing * grid_.points.radius;
  const Touch met = touch(contact_);
  const double first = contact_.first->softness / met.softness;  // its share of the compression
  return share * width * met.curvature * std::max(first, 1.0 - first);
}

double Meeting::dissipated() const {
  const auto [first, second] = response_->dissipated_energy();
  return first + second;
}

double Meeting::yielded() const {
  const auto [first, second] = response_->flow_energy();
  return first + second;
}

}  // namespace stoss
