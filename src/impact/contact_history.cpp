#include "impact/contact_history.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {
namespace {

/// Share of the impulse before the beginning and after the end of impulse_time.
constexpr double tail_of_impulse = 0.01;

/// Period of the highest modes that are kept, in which their sum swings about a force that jumps; at most the
/// time in which a wave runs through the shorter body.
double ripple_time(const Contact& contact) {
  return std::min(2.0 * std::numbers::pi / contact.cutoff, time_scale(contact));
}

/// The force between flat ends, which jumps: no sum of modes follows a jump, and swings about it by 9 % of it at any
/// cutoff (Gibbs). Two means over one period of the swing, one after the other, leave 0.5 % of it.
class FlatForce {
 public:
  /// @param impulse after each step since the first force
  FlatForce(const std::vector<double>& impulse, double step, double ripple_time);

  /// Greatest of the means.
  [[nodiscard]] double greatest() const { return greatest_; }

  /// Step of the last force of more than 2 % of the greatest: below, ends may touch, and only the modes swing.
  [[nodiscard]] long last() const { return last_; }

  /// Separate periods of such forces.
  [[nodiscard]] int contacts() const { return contacts_; }

 private:
  double greatest_ = 0.0;
  long last_ = 0;
  int contacts_ = 0;
};

FlatForce::FlatForce(const std::vector<double>& impulse, double step, double ripple_time) {
  constexpr double faint = 0.02, half = 0.5;
  const long count = static_cast<long>(impulse.size()), span = std::max(1L, std::lround(ripple_time / step));
  // Sums of the impulses before each step: their second difference is the mean of means.
  std::vector<double> sum(static_cast<std::size_t>(count + span + 1), 0.0);
  for (long k = 0; k < count + span; ++k) {
    sum[static_cast<std::size_t>(k + 1)] =
        sum[static_cast<std::size_t>(k)] + impulse[static_cast<std::size_t>(std::min(k, count - 1))];
  }
  const auto before = [&sum](long k) { return k < 0 ? 0.0 : sum[static_cast<std::size_t>(k)]; };
  const double unit = 1.0 / (static_cast<double>(span) * static_cast<double>(span) * step);
  std::vector<double> mean(static_cast<std::size_t>(count));
  for (long k = 0; k < count; ++k) {
    mean[static_cast<std::size_t>(k)] = unit * (before(k + span) - 2.0 * before(k) + before(k - span));
  }
  const auto at = [&mean](long k) { return k < 0 ? 0.0 : mean[static_cast<std::size_t>(k)]; };
  for (const double each : mean) greatest_ = std::max(greatest_, each);
  for (long k = 0; k < count; ++k) {
    if (at(k) >= faint * greatest_ && (k == 0 || at(k - 1) < faint * greatest_)) ++contacts_;
  }
  const auto pushes = [&](long k) {
    return k == 0 || impulse[static_cast<std::size_t>(k)] > impulse[static_cast<std::size_t>(k - 1)];
  };
  last_ = count - 1;
  while (last_ > 0 && !(pushes(last_) && at(last_) >= faint * greatest_)) --last_;
  // A force that falls slowly goes on to its end. Ends that part have no force any more. Of ends that touch on, modes
  // swing about none, and a force that falls at once has ended where half of it is left in the mean.
  while (last_ + 1 < count && pushes(last_ + 1)) ++last_;
  bool parted = true;
  for (long k = last_ + 1; k < std::min(count, last_ + span); ++k) parted = parted && !pushes(k);
  if (parted) return;
  while (last_ > 0 && !(pushes(last_) && at(last_) >= half * at(last_ - 2 * span))) --last_;
}

/// When rough faces touch, which feel each other at any distance: while the force exceeds a thousandth of its maximum.
struct Touching {
  double time = 0.0;  ///< from the first to the last, steps
  int contacts = 0;
};

/// @param impulse after each step since the first force @param greatest force times the step
Touching touching(const std::vector<double>& impulse, double greatest) {
  constexpr double share = 1e-3;
  Touching made;
  double first = 0.0, before = 0.0;
  const double least = share * greatest;
  for (std::size_t k = 0; k < impulse.size(); ++k) {
    const double force = impulse[k] - (k == 0 ? 0.0 : impulse[k - 1]);
    if ((before > least) != (force > least)) {
      const double at = static_cast<double>(k) - (force - least) / (force - before);
      if (force > least && made.contacts++ == 0) first = at;
      if (force <= least) made.time = at - first;
    }
    before = force;
  }
  return made;
}

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

void ContactHistory::fill(const Contact& contact, double velocity_before, double velocity_after, Impact& impact) const {
  impact.contact_time = contacts_ > 0 ? last_contact_ - first_contact_ : 0.0;
  impact.contacts = contacts_;
  impact.impulse_time = impulse_time();
  impact.max_force = force_peak_.value(0.0) / contact.first->mass;
  impact.max_compression = compression_peak_.value(0.0);
  impact.max_half_width = half_width_peak_.value(0.0);
  if (has_single_point(contact) && contact.asperities == 0.0 && impulse_ > 0.0) {
    const FlatForce force(impulse_history_, step_, ripple_time(contact));
    const double last = (static_cast<double>(first_step_ + force.last()) - 0.5) * step_;
    impact.contact_time = last - first_contact_;
    impact.contacts = force.contacts();
    impact.max_force = force.greatest() / contact.first->mass;
  }
  if (contact.asperities > 0.0) {
    const Touching its = touching(impulse_history_, force_peak_.value(0.0) * step_);
    impact.contact_time = its.time * step_;
    impact.contacts = its.contacts;
  }
  const double momentum_change = contact.mass * (velocity_before - velocity_after);
  impact.momentum_error = std::abs(impulse_ - momentum_change) / (contact.mass * std::abs(velocity_before));
  impact.steps = steps_;
}

}  // namespace stoss
