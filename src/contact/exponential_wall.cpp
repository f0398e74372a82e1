#include "contact/exponential_wall.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Share of the impact's energy that the potential may hold where the motion starts and ends.
constexpr double negligible_share = 1e-12;

/// e^x is refused above this; an impact resolved in time stays far below.
constexpr double max_exponent = 300.0;

double lowest_frequency(const Contact& contact) {
  double lowest = contact.cutoff;
  for (const ModeGroup& group : contact.groups) {
    for (const double omega : group.omega) lowest = std::min(lowest, omega);
  }
  return lowest;
}

}  // namespace

ExponentialResponse::ExponentialResponse(const ExponentialWall& wall, const Contact& contact, const ContactGrid& grid,
                                         double speed)
    : wall_(wall),
      threshold_(1e-3 * contact.mass * speed * std::min(lowest_frequency(contact), wall.hardness * speed)),
      log_strength_(std::log(wall.hardness) + std::log(wall.strength)),
      measure_(grid.measure),
      force_(grid.measure.size()) {
  const double edge = std::accumulate(measure_.begin(), measure_.end(), 0.0);
  const double energy = 0.5 * contact.mass * speed * speed;
  range_ = (std::log(wall.strength) + std::log(edge / (negligible_share * energy))) / wall.hardness;
}

const std::vector<double>& ExponentialResponse::advance(const std::vector<double>& position) {
  total_force_ = 0.0;
  extent_ = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double exponent = log_strength_ + wall_.hardness * position[i];
    if (!(exponent < max_exponent)) {
      throw NotConverged("exponential wall: penetrated beyond any physical force", "step", "use a smaller step");
    }
    force_[i] = measure_[i] * std::exp(exponent);
    total_force_ += force_[i];
    if (force_[i] > 0.0) extent_ = i + 1;
  }
  return force_;
}

double ExponentialResponse::half_width() const {
  const double noticeable = 1e-3 * *std::max_element(force_.begin(), force_.end());
  std::size_t count = extent_;
  while (count > 0 && force_[count - 1] < noticeable) --count;
  return static_cast<double>(count);
}

bool ExponentialResponse::overflows() const {
  return total_force_ > threshold_ && force_.back() > 1e-10 * total_force_;
}

}  // namespace stoss
