#include "contact/radiating_tail.hpp"

#include <algorithm>
#include <cmath>

namespace stoss {

RadiatingTail::RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step,
                             const Poll& poll)
    : residuals_(contact, grid, ResidualMotion::Inertia::radiating, step, poll),
      contact_(residuals_.compliance(), edge_law(contact, grid, speed), grid.recess.size(), poll),
      range_(contact_.range(grid.recess)),
      position_(grid.recess.size()),
      displacement_(grid.recess.size()),
      force_(grid.recess.size()),
      old_force_(grid.recess.size()),
      contact_displacement_(grid.recess.size()),
      gap_(grid.recess.size()) {}

const std::vector<double>& RadiatingTail::advance(const std::vector<double>& position) {
  const std::size_t nodes = position.size();
  const std::vector<double>& free = residuals_.predict();
  for (std::size_t i = 0; i < nodes; ++i) gap_[i] = position[i] - free[i];
  old_force_.swap(force_);
  contact_.solve(gap_, force_, contact_displacement_);
  for (std::size_t i = 0; i < nodes; ++i) {
    displacement_[i] = free[i] + contact_displacement_[i];
    work_ += 0.5 * (old_force_[i] + force_[i]) * (position[i] - position_[i]);
  }
  residuals_.move(displacement_, force_, contact_.extent());
  position_ = position;
  return force_;
}

double RadiatingTail::unresolved_energy() const {
  const auto [first, second] = residuals_.dissipated();
  return work_ - first - second;
}

double RadiatingTail::protrusion() const {
  // A released node swings back through its rest position, but never as far as it was displaced.
  double largest = 0.0;
  for (const double displacement : displacement_) largest = std::max(largest, std::abs(displacement));
  return largest;
}

}  // namespace stoss
