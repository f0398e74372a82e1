#include "contact/quasistatic_tail.hpp"

#include <algorithm>
#include <cmath>

#include "contact/touch.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

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
  return residuals_.stored() + contact_.law_energy(force_);
}

double QuasistaticTail::protrusion() const { return lossy_ ? largest_displacement() : 0.0; }

}  // namespace stoss
