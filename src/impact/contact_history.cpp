#include "impact/contact_history.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "impact/flat_force.hpp"

namespace stoss {
namespace {

/// Share of the impulse before the beginning and after the end of impulse_time.
constexpr double tail_of_impulse = 0.01;

}  // namespace

void ContactHistory::add_force(double mean_force) {
  impulse_ += mean_force * step_;
  force_peak_.add(mean_force);
  if (impulse_ <= 0.0) return;
  if (impulse_history_.empty()) first_step_ = steps_ + 1;
  impulse_history_.push_back(impulse_);
}

void ContactHistory::add(bool touching, double since_touch) {
  ++steps_;
  if (touching) {
    // A contact ends, on average, half a step after it is noticed last.
    if (!in_contact_ && contacts_++ == 0) first_contact_ = time() - since_touch * step_;
    last_contact_ = time() + 0.5 * step_;
    last_step_ = steps_;
    ++contact_steps_;
  }
  in_contact_ = touching;
}

void ContactHistory::add_extent(double compression, double half_width) {
  compression_peak_.add(compression);
  half_width_peak_.add(half_width);
}

double ContactHistory::samples() const {
  return static_cast<double>(std::max((contact_steps_ + sampling - 1) / sampling, 1L));
}

double ContactHistory::impulse_time() const {
  const auto reached = [this](double share) {
    const double wanted = share * impulse_;
    const auto after = std::lower_bound(impulse_history_.begin(), impulse_history_.end(), wanted);
    const double before = after == impulse_history_.begin() ? 0.0 : *(after - 1);
    return static_cast<double>(after - impulse_history_.begin()) + (wanted - before) / (*after - before);
  };
  return impulse_ > 0.0 ? (reached(1.0 - tail_of_impulse) - reached(tail_of_impulse)) * step_ : 0.0;
}

void ContactHistory::show(const Contact& contact, double velocity_before, double velocity_after, Impact& impact) const {
  impact.contact_time = contacts_ > 0 ? last_contact_ - first_contact_ : 0.0;
  impact.contacts = contacts_;
  impact.impulse_time = impulse_time();
  impact.max_force = force_peak_.value(0.0) / contact.first->mass;
  impact.max_compression = compression_peak_.value(0.0);
  impact.max_half_width = half_width_peak_.value(0.0);
  if (has_single_point(contact) && std::holds_alternative<HardWall>(contact.wall) && impulse_ > 0.0) {
    const FlatForce force(impulse_history_, step_, ripple_time(contact));
    const double last = (static_cast<double>(first_step_ + force.last()) - 0.5) * step_;
    impact.contact_time = last - first_contact_;
    impact.contacts = force.contacts();
    impact.max_force = force.greatest() / contact.first->mass;
  }
  const double momentum_change = contact.mass * (velocity_before - velocity_after);
  impact.momentum_error = std::abs(impulse_ - momentum_change) / (contact.mass * std::abs(velocity_before));
  impact.steps = steps_;
}

}  // namespace stoss
