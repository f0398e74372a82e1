#pragma once

#include <vector>

#include "contact/edge/edge_contact.hpp"
#include "contact/residual/residuals.hpp"
#include "contact/response.hpp"

namespace stoss {

/// A contact that no point passes, by the edge law, whatever the tail of the modes that are not kept.
class HardContact : public ContactResponse {
 public:
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] double gap(std::size_t node) const override;
  [[nodiscard]] double half_width() const override { return contact_.half_width(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double range() const override { return range_; }
  [[nodiscard]] double touch() const override { return touch_; }

  /// With the touch at the best phase within a step.
  [[nodiscard]] double start(double stride) const override;

 protected:
  HardContact(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double speed,
              double step, const Poll& poll);

  /// Largest displacement of a node.
  [[nodiscard]] double largest_displacement() const;

  double step_;
  Residuals residuals_;
  EdgeContact contact_;
  bool lossy_;
  double first_share_;                // of the first body in what the edge law takes
  std::vector<double> position_;      // x_dyn
  std::vector<double> gap_;           // x_dyn − h
  std::vector<double> displacement_;  // u
  std::vector<double> force_, old_force_;
  double edge_work_ = 0.0;  // of lossy bodies: ∫ f (ẋ_dyn − u̇) dt, what the edge law takes

 private:
  double range_, touch_, first_kick_;
};

}  // namespace stoss
