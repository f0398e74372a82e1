#include "contact/response.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/hard_contact.hpp"
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

/// The paper's wall on the nodes: V = V₀ Σ_i μ_i e^{αx_i}, f_i = ∂V/∂x_i, with μ_i the edge that node i stands for.
class ExponentialResponse final : public ContactResponse {
 public:
  ExponentialResponse(const ExponentialWall& wall, const Contact& contact, const ContactGrid& grid, double speed);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return extent_; }
  [[nodiscard]] double half_width() const override;
  [[nodiscard]] bool overflows() const override;
  [[nodiscard]] double stored_energy() const override { return total_force_ / wall_.hardness; }
  [[nodiscard]] double contact_threshold() const override { return threshold_; }
  [[nodiscard]] double range() const override { return range_; }
  [[nodiscard]] bool is_long_range() const override { return true; }
  [[nodiscard]] double touch() const override { return -std::log(wall_.strength) / wall_.hardness; }
  [[nodiscard]] double start(double /*stride*/) const override { return -range_; }

 private:
  ExponentialWall wall_;
  double threshold_;
  double range_;
  double log_strength_;          // ln(α V₀)
  std::vector<double> measure_;  // μ_i
  std::vector<double> force_;
  double total_force_ = 0.0;
  std::size_t extent_ = 0;
};

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

}  // namespace

std::unique_ptr<ContactResponse> make_response(const Contact& contact, Tail tail, const ContactGrid& grid, double speed,
                                               double step, const Poll& poll) {
  if (const auto* soft = std::get_if<ExponentialWall>(&contact.wall)) {
    return std::make_unique<ExponentialResponse>(*soft, contact, grid, speed);
  }
  if (tail == Tail::quasistatic) {
    return std::make_unique<QuasistaticTail>(contact, grid, speed, step, poll);
  }
  return std::make_unique<RadiatingTail>(contact, grid, speed, step, poll);
}

bool follows_at_once(const Contact& contact, Tail tail) {
  const bool hard = std::holds_alternative<HardWall>(contact.wall);
  return hard && tail == Tail::radiating && longest_loss_time(contact) > 0.0;
}

}  // namespace stoss
