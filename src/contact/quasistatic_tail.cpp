#include "contact/quasistatic_tail.hpp"

namespace stoss {

QuasistaticTail::QuasistaticTail(const Contact& contact, const ContactGrid& grid, const Poll& poll)
    : contact_(residual_compliance(contact, grid, poll), grid.recess.size(), poll),
      force_(grid.recess.size()),
      displacement_(grid.recess.size()) {}

const std::vector<double>& QuasistaticTail::advance(const std::vector<double>& position) {
  contact_.solve(position, force_, displacement_);
  return force_;
}

double QuasistaticTail::stored_energy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < extent(); ++i) energy += 0.5 * force_[i] * displacement_[i];
  return energy;
}

}  // namespace stoss
