#include "contact/radiating_tail.hpp"

#include <algorithm>
#include <cmath>

#include "contact/touch.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

RadiatingTail::RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step,
                             const Poll& poll)
    : HardContact(contact, grid, ResidualMotion::Inertia::all, speed, step, poll),
      contact_displacement_(grid.recess.size()) {}

const std::vector<double>& RadiatingTail::advance(const std::vector<double>& position) {
  const std::size_t nodes = position.size();
  const std::vector<double>& free = residuals_.predict();
  for (std::size_t i = 0; i < nodes; ++i) gap_[i] = position[i] - free[i];
  old_force_.swap(force_);
  contact_.follow(position_.front(), position.front(), step_);
  contact_.solve(gap_, force_, contact_displacement_);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double before = displacement_[i], moved = position[i] - position_[i];
    displacement_[i] = free[i] + contact_displacement_[i];
    edge_work_ += 0.5 * (old_force_[i] + force_[i]) * (moved - (displacement_[i] - before));
    work_ += 0.5 * (old_force_[i] + force_[i]) * moved;
  }
  residuals_.move(displacement_, force_, contact_.extent());
  position_ = position;
  return force_;
}

std::array<double, 2> RadiatingTail::dissipated_energy() const {
  if (!lossy_) return {};
  const auto [first, second] = residuals_.dissipated();
  return {first + first_share_ * edge_work_, second + (1.0 - first_share_) * edge_work_};
}

double RadiatingTail::unresolved_energy() const {
  const auto [first, second] = dissipated_energy();
  return work_ - first - second - stored_energy();
}

}  // namespace stoss
