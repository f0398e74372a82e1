#include "impact/flat_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stoss {

double ripple_time(const Contact& contact) {
  return std::min(2.0 * std::numbers::pi / contact.cutoff, time_scale(contact));
}

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

}  // namespace stoss
