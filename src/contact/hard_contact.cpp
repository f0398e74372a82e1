#include "contact/hard_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "contact/touch.hpp"

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
  if (contact.set_ups != nullptr) return contact.set_ups->of(contact, grid, inertia, step, poll);
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
      lossy_(longest_loss_time(contact) > 0.0),
      first_share_(loss_share(contact)),
      position_(grid.recess.size()),
      gap_(grid.recess.size()),
      displacement_(grid.recess.size()),
      force_(grid.recess.size()),
      old_force_(grid.recess.size()),
      range_(contact_.range(grid.recess)),
      touch_(touch_compression(contact, grid)),
      first_kick_(first_kick(contact)) {}

double HardContact::start(double stride) const { return start_before(first_kick_, range_, touch_, stride); }

double HardContact::gap(std::size_t node) const {
  return node < contact_.extent() ? contact_.gap(node) : displacement_[node] - position_[node];
}

double HardContact::largest_displacement() const {
  double largest = 0.0;
  for (const double displacement : displacement_) largest = std::max(largest, std::abs(displacement));
  return largest;
}

}  // namespace stoss
