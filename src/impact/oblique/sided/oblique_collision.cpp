#include "impact/oblique/sided/oblique_collision.hpp"

#include <cmath>
#include <utility>

#include "contact/hard_contact.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/oblique/film.hpp"
#include "stoss/errors.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

VectorXd on_both_sides(const std::vector<double>& values, std::size_t count) {
  const auto side = VectorXd::Map(values.data(), static_cast<Index>(count));
  VectorXd both(2 * side.size());
  both << side, side;
  return both;
}

}  // namespace

ObliqueCollision::ObliqueCollision(const Contact& contact, const std::vector<Contact>& along,
                                   const FixedResolution& resolution, const ContactGrid& grid,
                                   const ObliqueFrame& frame, const Obliquity& obliquity,
                                   const std::optional<State>& start, const Poll& poll)
    : contact_(contact),
      obliquity_(obliquity),
      frame_(frame),
      step_(resolution.step),
      points_(grid.points),
      even_(along[0], points_, resolution, poll),
      odd_(along[1], points_, resolution, poll),
      law_(edge_law(contact, grid, std::sqrt(2.0 * frame.normal_energy / frame.mass))),
      nodes_(sided_compliance(even_.residuals.compliance(poll), odd_.residuals.compliance(poll), points_.count), law_,
             obliquity.friction, touch(along[0]).softness / touch(contact).softness, poll),
      rigid_(contact, points_, step_, frame, obliquity),
      history_(step_),
      recess_(on_both_sides(grid.recess, points_.count)),
      range_(law_.range(grid.recess)),
      touch_(touch_compression(contact, grid)),
      lossy_(longest_loss_time(contact) > 0.0),
      first_share_(loss_share(contact)),
      moved_x_(VectorXd::Zero(recess_.size())),
      moved_y_(moved_x_),
      force_(moved_x_),
      rub_(moved_x_),
      seen_(points_at_rest(contact, grid)) {
  if (start) {
    even_.modes.set(start->coordinate, start->momentum);
    energy_before_ = even_.modes.energies();
  }
  rigid_.start(start ? contact_.extent + start->center
                     : start_before(first_kick(contact), range_, touch_, frame_.speed * step_));
  respond();
  if (rigid_.force() > 0.0) {
    throw InvalidInput::conflict("start", "the body already touches the wall", "move its center back");
  }
  even_.modes.begin();
  odd_.modes.begin();
}

void ObliqueCollision::respond() {
  const VectorXd old_x = x_, old_moved_x = moved_x_, old_moved_y = moved_y_;
  x_ = rigid_.compression() - recess_.array();
  y_ = rigid_.along();
  add_block(even_.place(), x_, y_);
  add_block(odd_.place(), y_, x_);
  const auto points = static_cast<Index>(points_.count);
  foremost_before_ = foremost_;
  foremost_ = x_.maxCoeff();
  if (!begun_) {
    place_ = y_;
  } else {
    nodes_.follow(0.5 * (old_x(0) + old_x(points)), 0.5 * (x_(0) + x_(points)), step_);
  }
  const VectorXd old_force = force_, old_rub = rub_;
  place_before_ = place_;
  answer();
  if (begun_) {
    const VectorXd force = 0.5 * (old_force + force_), rub = 0.5 * (old_rub + rub_);
    const double along = rub.dot(moved_y_ - old_moved_y);
    work_ += force.dot(x_ - old_x) + along;
    edge_work_ += force.dot((x_ - old_x) - (moved_x_ - old_moved_x));
    heat_ += rub.dot(place_ - place_before_);
  }
  begun_ = true;
}

/// The forces, and what moves under them.
void ObliqueCollision::answer() {
  VectorXd x = VectorXd::Zero(recess_.size()), y = x;
  add_block(even_.residuals.predict(), x, y);
  add_block(odd_.residuals.predict(), y, x);
  nodes_.solve(x_ - x, y_ - y - place_);
  force_ = nodes_.force();
  rub_ = nodes_.friction();
  moved_x_ = x + nodes_.moved_x();
  moved_y_ = y + nodes_.moved_y();
  place_ = y_ - moved_y_;
  to_block(force_, rub_, 1.0, even_.force);
  to_block(rub_, force_, 1.0, odd_.force);
  to_block(moved_x_, moved_y_, 0.5, even_.displacement);
  to_block(moved_y_, moved_x_, 0.5, odd_.displacement);
  for (ParityBlock* block : {&even_, &odd_}) {
    block->residuals.move(block->displacement, block->force, block->force.size());
    block->load();
  }
  rigid_.load(force_, rub_);
}

void ObliqueCollision::advance() {
  const double force_before = rigid_.force();
  rigid_.advance();
  even_.modes.advance();
  odd_.modes.advance();
  respond();
  history_.add_force(0.5 * (force_before + rigid_.force()));
  record();
}

void ObliqueCollision::record() {
  // As Collision: the foremost point has moved uniformly from its last position out of contact.
  const double touching = touch_ - recess_(0), moved = foremost_ - foremost_before_;
  history_.add(rigid_.force() > 0.0, moved > 0.0 ? std::min(1.0, (foremost_ - touching) / moved) : 0.5);
  if (!history_.in_contact()) return;
  if (history_.samples_energy()) {
    even_.modes.accumulate_energy();
    odd_.modes.accumulate_energy();
  }
  history_.add_extent(rigid_.compression() - touch_, nodes_.half_width() * points_.spacing * points_.radius);
  reach_ = -1.0;
}

double ObliqueCollision::reach() const {
  return even_.modes.reach(0, points_.count) + odd_.modes.reach(points_.count, 2 * points_.count);
}

bool ObliqueCollision::parts() const { return !history_.in_contact() && rigid_.velocity() < 0.0; }

bool ObliqueCollision::over() {
  if (!parts()) return false;
  if (reach_ < 0.0 || (lossy_ && history_.steps() % ContactHistory::sampling == 0)) reach_ = reach();
  return rigid_.compression() + reach_ + moved_x_.cwiseAbs().maxCoeff() < -range_;
}

double ObliqueCollision::steps_to_leave() const {
  const double vibration = even_.modes.energy() + odd_.modes.energy();
  if (rigid_.velocity() >= 0.0 || vibration < normal_motion()) return 0.0;
  return std::max(0.0, (rigid_.compression() + clearance()) / (-rigid_.velocity() * step_));
}

double ObliqueCollision::dissipated(int body) const {
  const double of_edge = body == 0 ? first_share_ : 1.0 - first_share_;
  return even_.dissipated(body) + odd_.dissipated(body) + (lossy_ ? of_edge * edge_work_ : 0.0);
}

ObliqueImpact ObliqueCollision::result(const Rest& rest) const {
  Impact normal;
  normal.speed = frame_.speed;
  normal.restitution = -rigid_.whole_velocity() / frame_.speed;
  normal.lost_fraction = 1.0 - normal.restitution * normal.restitution;
  history_.show(contact_, frame_.speed, rigid_.velocity(), normal);
  normal.final_state = {rigid_.compression() - contact_.extent, rigid_.velocity(), even_.modes.coordinate(),
                        even_.modes.momentum()};
  normal.max_force *= contact_.first->mass / whole_mass(*contact_.first);
  normal.energy.translation =
      0.5 * frame_.mass * rigid_.whole_velocity() * rigid_.whole_velocity() / frame_.normal_energy;
  rest.show(normal);

  ObliqueImpact result = frame_.joined(std::move(normal), obliquity_, outcome(), frame_.mass * rigid_.whole_velocity());
  show_ledger(result);
  return result;
}

AlongOutcome ObliqueCollision::outcome() const {
  AlongOutcome outcome = rigid_.outcome();
  for (int body = 0; body < 2; ++body) {
    outcome.vibration[static_cast<std::size_t>(body)] += even_.vibration(body) + odd_.vibration(body);
  }
  outcome.dissipated = dissipated(0) + dissipated(1);
  outcome.friction = heat_;
  outcome.stored = stored();
  // As RadiatingTail counts it, by what the modes that are kept do to the others.
  outcome.unresolved = work_ - outcome.stored - (lossy_ ? edge_work_ : 0.0);
  for (const ParityBlock* block : {&even_, &odd_}) {
    for (const double lost : block->residuals.dissipated()) outcome.unresolved -= lost;
  }
  return outcome;
}

void ObliqueCollision::show(const ObliqueImpactObserver& observer) {
  ObliqueSnapshot now = frame_.instant(history_.time(), obliquity_, rigid_.whole_velocity(), outcome(), 0.0);
  rigid_.show(contact_.extent, now);
  const auto count = static_cast<Index>(points_.count);
  for (Index k = 0; k < 2 * count; ++k) {
    ObliquePoint& point = seen_[static_cast<std::size_t>(k < count ? count + k : 2 * count - 1 - k)];
    point.pressure = force_(k);
    point.friction = rub_(k);
    point.slip = history_.steps() > 0 ? (place_(k) - place_before_(k)) / step_ : 0.0;
    point.grip = static_cast<Grip>(nodes_.sliding()[static_cast<std::size_t>(k)]);
  }
  show_points(seen_, whole_mass(*contact_.first), now);
  observer(now);
}

/// Of the motion along the normal, which has no ledger of its own, that of both.
void ObliqueCollision::show_ledger(ObliqueImpact& impact) const {
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
  for (const ParityBlock* block : {&even_, &odd_}) {
    const std::vector<double> after = block->modes.energies(), during = block->modes.accumulated_energy();
    for (std::size_t g = 0, k = 0; g < block->contact.groups.size(); ++g) {
      const ModeGroup& group = block->contact.groups[g];
      for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
        const double before = block == &even_ && !energy_before_.empty() ? energy_before_[k] : 0.0;
        ledger.modes.push_back({g < block->contact.first_groups ? 0 : 1, group.order, static_cast<int>(l),
                                group.omega[l], before / initial, after[k] / initial,
                                during[k] / (history_.samples() * initial)});
      }
    }
  }
  impact.normal.energy_error = impact.energy_error;
}

}  // namespace stoss
