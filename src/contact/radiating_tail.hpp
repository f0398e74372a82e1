#pragma once

#include "contact/edge_contact.hpp"
#include "contact/residuals.hpp"
#include "contact/response.hpp"

namespace stoss {

/// Hard wall, radiating tail: the modes that are not kept have springs, masses and dashpots (ResidualMotion), and in a
/// time step u = W′f + h. The same contact problem as with the quasistatic tail, with W′ for W and x_dyn − h for x_dyn.
class RadiatingTail final : public ContactResponse {
 public:
  RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] double half_width() const override { return contact_.half_width(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double unresolved_energy() const override;
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] double stored_energy() const override { return residuals_.stored(); }
  [[nodiscard]] double range() const override { return range_; }
  [[nodiscard]] double protrusion() const override;

 private:
  double step_;
  Residuals residuals_;
  EdgeContact contact_;  // with W′
  double range_;
  std::vector<double> position_;      // x_dyn
  std::vector<double> displacement_;  // u
  std::vector<double> force_, old_force_;
  std::vector<double> contact_displacement_;  // W′f
  std::vector<double> gap_;                   // x_dyn − h
  // ∫ f u̇ dt = ∫ f ẋ_dyn dt, as f = 0 where the two differ; by the trapezium rule in x_dyn, which is smooth.
  double work_ = 0.0;
  bool lossy_;
  double edge_work_ = 0.0;  // of a lossy contact: ∫ f (ẋ_dyn − u̇) dt, what the edge law takes
  double first_share_;      // of the first body in that
};

}  // namespace stoss
