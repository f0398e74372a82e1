#include "contact/quasistatic_tail.hpp"

#include <algorithm>
#include <cmath>

namespace stoss {

QuasistaticTail::QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, double step,
                                 const Poll& poll)
    : step_(step),
      residuals_(contact, grid, ResidualMotion::Inertia::none, step, poll),
      contact_(residuals_.compliance(), edge_law(contact, grid, speed), grid.recess.size(), poll),
      range_(contact_.range(grid.recess)),
      lossy_(longest_loss_time(contact) > 0.0),
      force_(grid.recess.size()),
      displacement_(grid.recess.size()),
      gap_(grid.recess.size()) {}

const std::vector<double>& QuasistaticTail::advance(const std::vector<double>& position) {
  if (!lossy_) {
    contact_.solve(position, force_, displacement_);
    return force_;
  }
  const std::vector<double>& free = residuals_.predict();
  for (std::size_t i = 0; i < position.size(); ++i) gap_[i] = position[i] - free[i];
  contact_.follow(foremost_, position.front(), step_);
  foremost_ = position.front();
  contact_.solve(gap_, force_, displacement_);
  for (std::size_t i = 0; i < position.size(); ++i) displacement_[i] += free[i];
  residuals_.move(displacement_, force_, contact_.extent());
  return force_;
}

double QuasistaticTail::stored_energy() const {
  if (!lossy_) return contact_.energy(force_, displacement_);
  return residuals_.stored() + contact_.law_energy(force_);
}

double QuasistaticTail::protrusion() const {
  if (!lossy_) return 0.0;
  double largest = 0.0;
  for (const double displacement : displacement_) largest = std::max(largest, std::abs(displacement));
  return largest;
}

}  // namespace stoss
