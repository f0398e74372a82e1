#include "contact/response.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/demands.hpp"
#include "contact/hard_contact.hpp"
#include "contact/yield/yielding_contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Share of the impact's energy that the potential may hold where the motion starts and ends.
constexpr double negligible_share = 1e-12;

/// e^x is refused above this; an impact resolved in time stays far below.
constexpr double max_exponent = 300.0;

/// The paper's wall on the nodes, of kept modes alone: V = V₀ Σ_i μ_i e^{αx_i}, f_i = ∂V/∂x_i, with μ_i the edge that
/// node i stands for.
class ExponentialResponse final : public ContactResponse {
 public:
  ExponentialResponse(const Contact& contact, const ContactGrid& grid, double speed);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return extent_; }
  [[nodiscard]] double half_width() const override;
  [[nodiscard]] bool overflows() const override;
  [[nodiscard]] double stored_energy() const override { return total_force_ / hardness_; }
  [[nodiscard]] double contact_threshold() const override { return threshold_; }
  [[nodiscard]] double range() const override { return range_; }
  [[nodiscard]] bool is_long_range() const override { return true; }
  [[nodiscard]] double touch() const override { return -std::log(strength_) / hardness_; }
  [[nodiscard]] double start(double /*stride*/) const override { return -range_; }

 private:
  double hardness_, strength_;
  double threshold_;
  double range_;
  double log_strength_;          // ln(α V₀)
  std::vector<double> measure_;  // μ_i
  std::vector<double> force_;
  double total_force_ = 0.0;
  std::size_t extent_ = 0;
};

ExponentialResponse::ExponentialResponse(const Contact& contact, const ContactGrid& grid, double speed)
    : hardness_(1.0 / contact.asperities),
      strength_(contact.strength),
      threshold_(force_that_counts(contact, speed)),
      log_strength_(std::log(hardness_) + std::log(strength_)),
      measure_(grid.measure),
      force_(grid.measure.size()) {
  const double edge = std::accumulate(measure_.begin(), measure_.end(), 0.0);
  const double energy = 0.5 * contact.mass * speed * speed;
  range_ = (std::log(strength_) + std::log(edge / (negligible_share * energy))) / hardness_;
}

const std::vector<double>& ExponentialResponse::advance(const std::vector<double>& position) {
  total_force_ = 0.0;
  extent_ = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double exponent = log_strength_ + hardness_ * position[i];
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
  if (contact.yield.yield > 0.0) return std::make_unique<YieldingContact>(contact, grid, speed, step, poll);
  if (tail == Tail::none) return std::make_unique<ExponentialResponse>(contact, grid, speed);
  if (tail == Tail::quasistatic) {
    return std::make_unique<QuasistaticTail>(contact, grid, speed, step, poll);
  }
  return std::make_unique<RadiatingTail>(contact, grid, speed, step, poll);
}

bool follows_at_once(const Contact& contact, Tail tail) {
  return tail == Tail::radiating && contact.yield.yield == 0.0 && longest_loss_time(contact) > 0.0;
}

}  // namespace stoss
