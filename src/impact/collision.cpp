#include "impact/collision.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/contact_cache.hpp"
#include "contact/touch.hpp"
#include "impact/free_flight.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
Collision::Collision(const Contact& contact, const FixedResolution& resolution, const ContactGrid& grid, double speed,
                     const std::optional<State>& start, const Poll& poll, Pressures* pressures)
    : contact_(contact),
      ending_(ending(contact)),
      grid_(grid),
      speed_(speed),
      step_(resolution.step),
      modes_(mode_tables(contact, grid, resolution.step,
                         follows_at_once(contact, resolution.tail) ? Kicks::weaker : Kicks::whole)),
      pressures_(pressures),
      position_(grid.recess.size()),
      center_(contact.mass, resolution.step, speed),
      history_(resolution.step),
      lossy_(loses(contact)) {
  if (start) modes_.set(start->coordinate, start->momentum);
  // The same before and after an impact, so that it can be reversed.
  const double energy_speed = start ? std::sqrt(speed * speed + 2.0 * modes_.energy() / contact.mass) : speed;
  response_ = make_response(contact, resolution.tail, grid, energy_speed, step_, poll);
  if (start) response_->press(start->pressed);
  touch_ = response_->touch();
  center_.start(start ? contact_.extent + start->center : response_->start(speed_ * step_));
  if (pressures_ != nullptr) pressures_->begin(compression());
  respond();
  if (!response_->is_long_range() && center_.force() > 0.0) {
    throw InvalidInput::conflict("start", "the body already touches the wall", "move its center back");
  }
  center_.begin();
  modes_.begin();
  initial_velocity_ = velocity();
  initial_energy_ = translation() + modes_.energy() + response_->stored_energy();
  if (start) energy_before_ = modes_.energies();
}

void Collision::respond() {
  numeric::kernels::subtract_from(compression(), grid_.recess.data(), position_.size(), position_.data());
  modes_.add_displacement(position_);
  if (!history_.has_touched()) {
    foremost_before_ = foremost_;
    foremost_ = *std::max_element(position_.begin(), position_.end());
  }
  const std::vector<double>& force = response_->advance(position_);
  node_force_ = &force;
  const std::size_t extent = response_->extent();
  center_.load(std::accumulate(force.begin(), force.begin() + static_cast<std::ptrdiff_t>(extent), 0.0));
  modes_.load(force, extent);
  if (pressures_ != nullptr) pressures_->add(response_->spread(force), *response_, center_);
}

void Collision::advance() {
  const double force_before = center_.force();
  center_.advance();
  modes_.advance();
  respond();
  history_.add_force(0.5 * (force_before + center_.force()));
  record();
}

void Collision::record() {
  history_.add(center_.force() > response_->contact_threshold(), since_touch());
  if (!history_.in_contact()) return;
  if (history_.samples_energy()) modes_.accumulate_energy();
  history_.add_extent(compression() - touch_, half_width());
  reach_ = parted_ = -1.0;
}

double Collision::since_touch() const {
  // At a hard wall the foremost node has moved uniformly from its last position out of contact; it touches where the
  // foremost point of the whole surface does, which may still be to come.
  if (response_->is_long_range() || foremost_ <= foremost_before_) return 0.5;
  const double touching = touch_ - grid_.recess.front();
  return std::min(1.0, (foremost_ - touching) / (foremost_ - foremost_before_));
}

double Collision::half_width() const { return response_->half_width() * grid_.points.spacing * grid_.points.radius; }

bool Collision::over() {
  if (history_.in_contact() || velocity() >= 0.0) return false;
  const auto clear = [this] { return compression() + reach_ + response_->protrusion() < -response_->range(); };
  if (reach_ < 0.0 || (lossy_ && history_.steps() % ContactHistory::sampling == 0)) reach_ = modes_.reach();
  if (!clear()) return ending_.may_stay ? clears_waves() : has_parted();
  reach_ = modes_.reach();  // a soft wall has pushed on, below its threshold of contact
  return clear();
}

/// Without losses the flight of the modes can be seen ahead; the nodes that are still displaced swing back less.
bool Collision::has_parted() {
  constexpr long pause = 8;  // steps after the contact, in which the nodes swing back
  if (!ending_.foreseen) return false;
  if (parted_ < 0.0 && history_.steps_apart() >= pause) {
    const double range = response_->protrusion() + response_->range();
    parted_ = history_.time() + time_to_part(modes_.in_flight(mode_tables(contact_, grid_, 4.0 * step_, Kicks::whole)),
                                             grid_.recess, {compression(), velocity(), range});
  }
  return parted_ >= 0.0 && history_.time() >= parted_;
}

/// A surface that has given way does not come back: the body clears it if, as it recedes, it stays away from where the
/// waves will have the surface as long as they are known.
bool Collision::clears_waves() {
  constexpr int looks = 48;
  constexpr double pause = 0.05;  // share of the time, before it is looked at again
  const double now = history_.time(), left = ending_.known - now;
  if (now < next_look_) return false;
  next_look_ = (1.0 + pause) * now;
  const double place = compression() + reach_ + response_->protrusion() + response_->range();
  for (int look = 0; look <= looks; ++look) {
    const double share = static_cast<double>(look) / looks, later = left * share * share;
    if (place + velocity() * later + modes_.waves_later(later) >= 0.0) return false;
  }
  return true;
}

Slowing Collision::slowing() const {
  // Of Hertz' contact, whose energy is 2/5 of force times compression, δ = a²·curvature.
  const double width = half_width(), pressed = width * width * touch(contact_).curvature;
  const double remaining = (translation() + 0.4 * center_.force() * pressed) / initial_energy_;
  return {history_.time(), velocity(), remaining, history_.in_contact()};
}

Snapshot Collision::snapshot() const {
  Snapshot now;
  now.time = history_.time();
  now.center = compression() - contact_.extent;
  now.velocity = velocity();
  now.force = center_.force() / contact_.first->mass;
  now.translation = translation() / initial_energy_;
  now.vibration = modes_.energy() / initial_energy_;
  now.stored = response_->stored_energy() / initial_energy_;
  const auto [first, second] = dissipated();
  now.dissipated = (first + second) / initial_energy_;
  const auto [flow, second_flow] = response_->flow_energy();
  now.yielded = (flow + second_flow) / initial_energy_;
  now.unresolved = response_->unresolved_energy() / initial_energy_;
  now.contact_half_width = history_.in_contact() ? half_width() : 0.0;
  return now;
}

std::array<double, 2> Collision::dissipated() const {
  std::array<double, 2> lost = response_->dissipated_energy();
  lost[0] += modes_.dissipated(0, contact_.first_groups);
  lost[1] += modes_.dissipated(contact_.first_groups, contact_.groups.size());
  return lost;
}

State Collision::state() const {
  return {compression() - contact_.extent, velocity(), modes_.coordinate(), modes_.momentum(), response_->pressed()};
}

std::vector<double> Collision::node_force() const {
  std::vector<double> shares(node_force_->size());
  for (std::size_t i = 0; i < response_->extent(); ++i) shares[i] = (*node_force_)[i] / contact_.first->mass;
  return shares;
}

std::array<std::vector<double>, 2> Collision::crept_force() const {
  std::array<std::vector<double>, 2> both;
  for (std::size_t body = 0; body < both.size(); ++body) {
    both[body] = response_->crept_force(body);
    for (double& each : both[body]) each /= contact_.first->mass;
    if (both[body].empty()) both[body] = node_force();
  }
  return both;
}

Impact Collision::result() const {
  Impact impact;
  impact.speed = speed_;
  impact.restitution = -velocity() / initial_velocity_;
  impact.lost_fraction = 1.0 - impact.restitution * impact.restitution;
  history_.fill(contact_, initial_velocity_, velocity(), impact);
  const KeptModes rings = modes_.ringing();
  impact.final_state = {compression() - contact_.extent, velocity(), rings.coordinate(), rings.momentum(),
                        response_->pressed()};

  EnergyLedger& ledger = impact.energy;
  ledger.translation = translation() / initial_energy_;
  ledger.unresolved = response_->unresolved_energy() / initial_energy_;
  ledger.stored = response_->stored_energy() / initial_energy_;
  const std::vector<double> after = modes_.energies(), ringing = lossy_ ? rings.energies() : after;
  const std::vector<double> during = modes_.accumulated_energy();
  const double samples = history_.samples();
  ledger.modes.reserve(after.size());
  for (std::size_t g = 0, k = 0; g < contact_.groups.size(); ++g) {
    const ModeGroup& group = contact_.groups[g];
    const bool of_first = g < contact_.first_groups;
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      const double before = energy_before_.empty() ? 0.0 : energy_before_[k] / initial_energy_;
      const double share = ringing[k] / initial_energy_, held = after[k] / initial_energy_ - share;
      ledger.modes.push_back({of_first ? 0 : 1, group.order, index, group.omega[l], before, share,
                              during[k] / (samples * initial_energy_)});
      ledger.vibration += share, ledger.dissipated += held;
      (of_first ? ledger.lost_to_first : ledger.lost_to_second) += share + held;
    }
  }
  const auto [first, second] = dissipated();
  const auto [relaxing, relaxing_second] = response_->relaxing_energy();
  const auto becomes_heat = [](const Body* of) { return of != nullptr && !of->relaxation.terms.empty() ? 1.0 : 0.0; };
  const double held =
      becomes_heat(contact_.first.get()) * relaxing + becomes_heat(contact_.second.get()) * relaxing_second;
  ledger.dissipated += (first + second + held) / initial_energy_;
  ledger.stored -= held / initial_energy_;
  ledger.lost_to_first += (first + relaxing) / initial_energy_;
  ledger.lost_to_second += (second + relaxing_second) / initial_energy_;
  const auto [flow, second_flow] = response_->flow_energy();
  ledger.yielded = (flow + second_flow) / initial_energy_;
  ledger.lost_to_first += flow / initial_energy_;
  ledger.lost_to_second += second_flow / initial_energy_;
  impact.dent = response_->dent();
  const double share = unresolved_share(contact_);
  ledger.lost_to_first += share * ledger.unresolved;
  ledger.lost_to_second += (1.0 - share) * ledger.unresolved;
  impact.energy_error = 1.0 - ledger.translation - ledger.vibration - ledger.dissipated - ledger.yielded -
                        ledger.unresolved - ledger.stored;
  return impact;
}

}  // namespace stoss
