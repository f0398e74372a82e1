#pragma once

#include "contact/edge_contact.hpp"
#include "contact/residuals.hpp"
#include "contact/response.hpp"

namespace stoss {

/// Hard wall, quasistatic tail: u = W f, of a lossy material W f = u + η u̇ (ResidualMotion without masses), and the
/// edge law between f and u − x_dyn.
class QuasistaticTail final : public ContactResponse {
 public:
  QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] double half_width() const override { return contact_.half_width(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double stored_energy() const override;
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] double protrusion() const override;
  [[nodiscard]] double range() const override { return range_; }

 private:
  double step_;
  Residuals residuals_;
  EdgeContact contact_;
  double range_;
  std::vector<double> force_;
  std::vector<double> displacement_;
  // Of lossy bodies.
  bool lossy_;
  double first_share_;            // of the first body in what the edge law takes
  std::vector<double> position_;  // x_dyn
  std::vector<double> gap_;       // x_dyn − h
  std::vector<double> old_force_, old_displacement_;
  double edge_work_ = 0.0;  // ∫ f (ẋ_dyn − u̇) dt
};

}  // namespace stoss
