#include "impact/oblique/coupled_collision.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/demands.hpp"
#include "contact/friction.hpp"
#include "contact/hard_contact.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/oblique/film.hpp"
#include "stoss/errors.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Local softness along y over that along the normal; of rings that is the same.
double softness_ratio(const Contact& contact, const std::vector<Contact>& along) {
  return along.size() == 1 ? 1.0 : touch(along.front()).softness / touch(contact).softness;
}

/// Of an impact with all the energy that there is.
double whole_speed(const ObliqueFrame& frame) { return std::sqrt(2.0 * frame.normal_energy / frame.mass); }

}  // namespace

CoupledCollision::CoupledCollision(const Contact& contact, const std::vector<Contact>& along,
                                   const FixedResolution& resolution, const ContactGrid& grid,
                                   const ObliqueFrame& frame, const Obliquity& obliquity,
                                   const std::optional<State>& start, const Poll& poll)
    : contact_(contact),
      obliquity_(obliquity),
      frame_(frame),
      step_(resolution.step),
      points_(grid.points),
      modes_(along, points_, resolution, poll),
      law_(edge_law(contact, grid, whole_speed(frame))),
      nodes_(modes_.compliance(poll), law_, obliquity.friction, softness_ratio(contact, along), poll),
      center_(contact.mass, step_, frame.speed),
      history_(step_),
      recess_(VectorXd::Map(grid.recess.data(), static_cast<Index>(points_.count))
                  .replicate(static_cast<Index>(along.size()), 1)),
      range_(law_.range(grid.recess)),
      touch_(touch_compression(contact, grid, edge_left(contact, grid, whole_speed(frame)))),
      threshold_(force_that_counts(contact, whole_speed(frame))),
      lossy_(loses(contact)),
      first_share_(loss_share(contact)),
      start_compression_(start ? contact_.extent + start->center
                         : contact.asperities > 0.0
                             ? -range_
                             : start_before(first_kick(contact), range_, touch_, frame_.speed * step_)),
      moved_x_(VectorXd::Zero(recess_.size())),
      moved_y_(moved_x_),
      force_(moved_x_),
      friction_(moved_x_),
      seen_(points_at_rest(contact, grid)) {
  if (along.size() == 2) along_.emplace(contact, points_, frame, step_, obliquity);
  if (start) {
    modes_.set(*start);
    energy_before_ = modes_.first_block().energies();
  }
  center_.start(start_compression_);
  respond();
  if (center_.force() > 0.0 && contact_.asperities == 0.0) {
    throw InvalidInput::conflict("start", "the body already touches the wall", "move its center back");
  }
  modes_.begin();
  start_energy_ = rigid_energy();
}

void CoupledCollision::respond() {
  const VectorXd old_x = x_, old_moved_x = moved_x_, old_moved_y = moved_y_;
  x_ = center_.compression() - recess_.array();
  y_ = VectorXd::Zero(recess_.size());
  if (along_) along_->place(y_);
  modes_.add_places(x_, y_);
  const auto last = recess_.size() - static_cast<Index>(points_.count);  // the foremost point of the last side
  foremost_before_ = foremost_;
  foremost_ = x_.maxCoeff();
  if (!begun_) {
    place_ = y_;
  } else {
    nodes_.follow(0.5 * (old_x(0) + old_x(last)), 0.5 * (x_(0) + x_(last)), step_);
  }
  force_before_ = force_;
  gap_before_ = begun_ ? nodes_.gap() : VectorXd(-x_);
  const VectorXd old_friction = friction_;
  place_before_ = place_;
  solve();
  if (begun_) {
    const VectorXd force = 0.5 * (force_before_ + force_), friction = 0.5 * (old_friction + friction_);
    work_ += force.dot(x_ - old_x) + friction.dot(moved_y_ - old_moved_y);
    edge_work_ += force.dot((x_ - old_x) - (moved_x_ - old_moved_x));
    heat_ += friction.dot(place_ - place_before_);
  }
  begun_ = true;
}

/// The forces, and what moves under them.
void CoupledCollision::solve() {
  moved_x_.setZero();
  moved_y_.setZero();
  modes_.add_free_displacement(moved_x_, moved_y_);
  nodes_.solve(x_ - moved_x_, y_ - moved_y_ - place_);
  force_ = nodes_.force();
  friction_ = nodes_.friction();
  moved_x_ += nodes_.moved_x();
  moved_y_ += nodes_.moved_y();
  place_ = y_ - moved_y_;
  modes_.load(force_, friction_, moved_x_, moved_y_);
  center_.load(force_.sum());
  if (along_) along_->load(friction_);
}

void CoupledCollision::advance() {
  const double force_before = center_.force();
  center_.advance();
  if (along_) along_->advance();
  modes_.advance();
  respond();
  history_.add_force(0.5 * (force_before + center_.force()));
  record();
}

void CoupledCollision::record() {
  // As Collision: the foremost point has moved uniformly from its last position out of contact.
  const double touching = touch_ - recess_(0), moved = foremost_ - foremost_before_;
  history_.add(center_.force() > threshold_, moved > 0.0 ? std::min(1.0, (foremost_ - touching) / moved) : 0.5);
  if (!history_.in_contact()) return;
  if (history_.samples_energy()) modes_.accumulate_energy();
  history_.add_extent(compression() - touch_, nodes_.half_width() * points_.spacing * points_.radius);
  reach_ = -1.0;
}

bool CoupledCollision::over() {
  if (history_.in_contact() || velocity() >= 0.0) return false;
  if (reach_ < 0.0 || (lossy_ && history_.steps() % ContactHistory::sampling == 0)) reach_ = modes_.reach();
  return compression() + reach_ + moved_x_.cwiseAbs().maxCoeff() < -range_;
}

VectorXd CoupledCollision::give() const {
  VectorXd give(force_.size());
  for (Index i = 0; i < give.size(); ++i) {
    give(i) = edge_compliance_along(1.0, nodes_.gap()(i), gap_before_(i), force_(i), force_before_(i));
  }
  return give;
}

double CoupledCollision::dissipated(int body) const {
  const double of_edge = body == 0 ? first_share_ : 1.0 - first_share_;
  return modes_.dissipated(body) + (lossy_ ? of_edge * edge_work_ : 0.0);
}

double CoupledCollision::whole_velocity() const {
  const double share = contact_.mass / frame_.mass;
  return share == 1.0 ? velocity() : frame_.speed - share * (frame_.speed - velocity());
}

double CoupledCollision::rigid_energy() const { return center_.energy() + (along_ ? along_->energy() : 0.0); }

ObliqueImpact CoupledCollision::result(const Rest& rest) const {
  Impact normal;
  normal.speed = frame_.speed;
  normal.restitution = -whole_velocity() / frame_.speed;
  normal.lost_fraction = 1.0 - normal.restitution * normal.restitution;
  history_.fill(contact_, frame_.speed, velocity(), normal);
  const KeptModes& even = modes_.first_block();
  normal.final_state = {compression() - contact_.extent, velocity(), even.coordinate(), even.momentum(), 0.0};
  normal.max_force *= contact_.first->mass / whole_mass(*contact_.first);
  normal.energy.translation = 0.5 * frame_.mass * whole_velocity() * whole_velocity() / frame_.normal_energy;
  rest.apply(normal);

  ObliqueImpact result = frame_.joined(std::move(normal), obliquity_, outcome(), frame_.mass * whole_velocity());
  show_ledger(result);
  return result;
}

AlongOutcome CoupledCollision::outcome() const {
  AlongOutcome outcome = along_ ? along_->outcome() : ObliqueFrame::unchanged(obliquity_);
  for (int body = 0; body < 2; ++body) outcome.vibration[static_cast<std::size_t>(body)] = modes_.vibration(body);
  outcome.dissipated = dissipated(0) + dissipated(1);
  outcome.friction = heat_;
  outcome.stored = modes_.stored();
  // As RadiatingTail counts it, by what the modes that are kept do to the others.
  outcome.unresolved = work_ - outcome.stored - (lossy_ ? edge_work_ : 0.0) - modes_.dissipated_above_cutoff();
  if (contact_.mass == frame_.mass) return outcome;
  // What the whole of a body loses of its energy more than its part is vibration of it.
  const auto energy = [this](double velocity, const AlongOutcome& along) {
    double sum =
        0.5 * frame_.mass * velocity * velocity + 0.5 * frame_.mass_along * along.tangential * along.tangential;
    for (std::size_t k = 0; k < 2; ++k) sum += 0.5 * frame_.inertia[k] * along.spin[k] * along.spin[k];
    return sum;
  };
  const double lost = energy(frame_.speed, ObliqueFrame::unchanged(obliquity_)) - energy(whole_velocity(), outcome);
  outcome.vibration[contact_.first->part.size < 1.0 ? 0 : 1] += lost - (start_energy_ - rigid_energy());
  return outcome;
}

void CoupledCollision::show(const ObliqueImpactObserver& observer) {
  ObliqueSnapshot now = frame_.instant(history_.time(), obliquity_, whole_velocity(), outcome(), 0.0);
  const double part = contact_.mass / frame_.mass, free = start_compression_ + frame_.speed * now.time;
  now.center = (part == 1.0 ? compression() : free - part * (free - compression())) - contact_.extent;
  const AlongMotion along = along_->motion(now.time);
  now.shift = along.shift;
  now.angle = along.angle[0];
  now.second_angle = along.angle[1];
  const auto count = static_cast<Index>(points_.count);
  for (Index k = 0; k < 2 * count; ++k) {
    ObliquePoint& point = seen_[static_cast<std::size_t>(k < count ? count + k : 2 * count - 1 - k)];
    point.pressure = force_(k);
    point.friction = friction_(k);
    point.slip = history_.steps() > 0 ? slip()(k) / step_ : 0.0;
    point.grip = static_cast<Grip>(nodes_.sliding()[static_cast<std::size_t>(k)]);
  }
  show_points(seen_, whole_mass(*contact_.first), now);
  observer(now);
}

/// Of the motion along the normal, which has no ledger of its own, that of both.
void CoupledCollision::show_ledger(ObliqueImpact& impact) const {
  const ObliqueLedger& energy = impact.energy;
  EnergyLedger& ledger = impact.normal.energy;
  const double initial = frame_.initial_energy(obliquity_);
  ledger.translation = energy.translation;
  ledger.vibration = energy.vibration + energy.second_vibration;
  ledger.dissipated = energy.dissipated;
  ledger.unresolved = energy.unresolved;
  ledger.stored = energy.stored;
  const double relaxing = lossy_ ? energy.stored : 0.0, unresolved = unresolved_share(contact_);
  ledger.lost_to_first =
      energy.vibration + dissipated(0) / initial + first_share_ * relaxing + unresolved * energy.unresolved;
  ledger.lost_to_second = energy.second_vibration + dissipated(1) / initial + (1.0 - first_share_) * relaxing +
                          (1.0 - unresolved) * energy.unresolved;
  ledger.modes = modes_.ledger(energy_before_, history_.samples(), initial);
  impact.normal.energy_error = impact.energy_error;
}

}  // namespace stoss
