#include "contact/quasistatic_tail.hpp"

namespace stoss {

QuasistaticTail::QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, const Poll& poll)
    : contact_(residual_compliance(contact, grid, poll), edge_law(contact, grid, speed), grid.recess.size(), poll),
      range_(contact_.range(grid.recess)),
      force_(grid.recess.size()),
      displacement_(grid.recess.size()) {}

const std::vector<double>& QuasistaticTail::advance(const std::vector<double>& position) {
  contact_.solve(position, force_, displacement_);
  return force_;
}

}  // namespace stoss
