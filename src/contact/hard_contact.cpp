#include "contact/hard_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "contact/demands.hpp"
#include "contact/touch.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
double first_kick(const Contact& contact) {
  constexpr double jump = 0.5;
  constexpr double kink = 0.7886751345948129;  // (3 + √3)/6
  constexpr double bend = 0.9018628666552377;
  if (has_single_point(contact)) return jump;
  return touch(contact).circle ? bend : kink;
}

double start_before(double kick, double range, double touch, double stride) {
  const double phase = 1.0 - kick;  // of the touch, after a kick
  const double steps = std::max(0.0, std::ceil((range + touch) / stride - phase));
  return touch - (steps + phase) * stride;
}

namespace {

std::shared_ptr<const SetUp> set_up(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia,
                                    double step, const Poll& poll) {
  if (contact.cache != nullptr) return contact.cache->of(contact, grid, inertia, step, poll);
  return std::make_shared<const SetUp>(make_set_up(contact, grid, inertia, step, poll));
}

}  // namespace

HardContact::HardContact(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double speed,
                         double step, const Poll& poll)
    : HardContact(contact, grid, *set_up(contact, grid, inertia, step, poll), speed, step, poll) {}

HardContact::HardContact(const Contact& contact, const ContactGrid& grid, const SetUp& made, double speed, double step,
                         const Poll& poll)
    : step_(step),
      residuals_(made.residuals),
      contact_(made.compliance, edge_law(contact, grid, speed), poll),
      lossy_(loses(contact)),
      rough_(contact_.is_rough()),
      first_share_(loss_share(contact)),
      position_(grid.recess.size()),
      gap_(grid.recess.size()),
      displacement_(grid.recess.size()),
      force_(grid.recess.size()),
      old_force_(grid.recess.size()),
      range_(contact_.range(grid.recess)),
      touch_(touch_compression(contact, grid, edge_left(contact, grid, speed))),
      first_kick_(first_kick(contact)),
      threshold_(force_that_counts(contact, speed)) {}

double HardContact::start(double stride) const {
  return rough_ ? -range_ : start_before(first_kick_, range_, touch_, stride);  // no phase is better: it is smooth
}

double HardContact::gap(std::size_t node) const {
  return node < contact_.extent() ? contact_.gap(node) : displacement_[node] - position_[node];
}

std::array<double, 2> HardContact::relaxing_energy() const {
  return lossy_ ? residuals_.stored() : std::array<double, 2>{};
}

double HardContact::largest_displacement() const {
  double largest = 0.0;
  for (const double displacement : displacement_) largest = std::max(largest, std::abs(displacement));
  return largest;
}

QuasistaticTail::QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, double step,
                                 const Poll& poll)
    : HardContact(contact, grid, ResidualMotion::Inertia::none, speed, step, poll),
      old_displacement_(grid.recess.size()) {}

const std::vector<double>& QuasistaticTail::advance(const std::vector<double>& position) {
  if (!lossy_) {
    contact_.solve(position, force_, displacement_);
    position_ = position;
    return force_;
  }
  const std::vector<double>& free = residuals_.predict();
  for (std::size_t i = 0; i < position.size(); ++i) gap_[i] = position[i] - free[i];
  old_force_.swap(force_);
  old_displacement_.swap(displacement_);
  contact_.follow(position_.front(), position.front(), step_);
  contact_.solve(gap_, force_, displacement_);
  for (std::size_t i = 0; i < position.size(); ++i) {
    displacement_[i] += free[i];
    const double opened = position[i] - position_[i] - (displacement_[i] - old_displacement_[i]);
    edge_work_ += 0.5 * (old_force_[i] + force_[i]) * opened;
  }
  residuals_.move(displacement_, force_, contact_.extent());
  position_ = position;
  return force_;
}

std::array<double, 2> QuasistaticTail::dissipated_energy() const {
  if (!lossy_) return {};
  const auto [first, second] = residuals_.dissipated();
  const double edge = edge_work_ - contact_.law_energy(force_);
  return {first + first_share_ * edge, second + (1.0 - first_share_) * edge};
}

double QuasistaticTail::stored_energy() const {
  if (!lossy_) return contact_.energy(force_, displacement_);
  const auto [first, second] = residuals_.stored();
  return first + second + contact_.law_energy(force_);
}

double QuasistaticTail::protrusion() const { return lossy_ ? largest_displacement() : 0.0; }

namespace kernels = numeric::kernels;

RadiatingTail::RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step,
                             const Poll& poll)
    : HardContact(contact, grid, ResidualMotion::Inertia::all, speed, step, poll),
      contact_displacement_(grid.recess.size()) {}

const std::vector<double>& RadiatingTail::advance(const std::vector<double>& position) {
  const std::size_t nodes = position.size();
  if (at_rest_ && contact_.is_clear(position)) {
    position_ = position;
    return force_;
  }
  at_rest_ = false;
  const std::vector<double>& free = residuals_.predict();
  kernels::subtract(position.data(), free.data(), nodes, gap_.data());
  old_force_.swap(force_);
  const std::size_t extent_before = contact_.extent();
  contact_.follow(position_.front(), position.front(), step_);
  contact_.solve(gap_, force_, contact_displacement_);
  const std::size_t pushed = std::max(extent_before, contact_.extent());
  double work = work_;
  for (std::size_t i = 0; i < pushed; ++i) work += 0.5 * (old_force_[i] + force_[i]) * (position[i] - position_[i]);
  work_ = work;
  for (std::size_t i = 0; lossy_ && i < pushed; ++i) {
    const double opened = position[i] - position_[i] - (free[i] + contact_displacement_[i] - displacement_[i]);
    edge_work_ += 0.5 * (old_force_[i] + force_[i]) * opened;
  }
  kernels::add(free.data(), contact_displacement_.data(), nodes, displacement_.data());
  residuals_.move(displacement_, force_, contact_.extent());
  position_ = position;
  return force_;
}

bool RadiatingTail::is_still(double negligible) const {
  return at_rest_ || (contact_.extent() == 0 && residuals_.is_still(displacement_, negligible));
}

/// Without losses it is as if nothing had touched.
void RadiatingTail::rest(double time) {
  if (at_rest_) return;
  residuals_.rest(time);
  at_rest_ = !lossy_;
  if (at_rest_) std::fill(displacement_.begin(), displacement_.end(), 0.0);
}

std::array<double, 2> RadiatingTail::dissipated_energy() const {
  if (!lossy_) return {};
  const auto [first, second] = residuals_.dissipated();
  const double edge = edge_work_ - held_by_asperities();
  return {first + first_share_ * edge, second + (1.0 - first_share_) * edge};
}

double RadiatingTail::held_by_asperities() const { return rough_ ? contact_.law_energy(force_) : 0.0; }

double RadiatingTail::stored_energy() const {
  const auto [first, second] = residuals_.stored();
  return first + second + held_by_asperities();
}

double RadiatingTail::unresolved_energy() const {
  const auto [first, second] = dissipated_energy();
  return work_ - first - second - stored_energy();
}

}  // namespace stoss
