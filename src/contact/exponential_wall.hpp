#pragma once

#include <cmath>

#include "contact/response.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

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
  [[nodiscard]] bool acts_from_afar() const override { return true; }
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

}  // namespace stoss
