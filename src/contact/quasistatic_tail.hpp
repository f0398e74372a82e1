#pragma once

#include "contact/edge_contact.hpp"
#include "contact/response.hpp"

namespace stoss {

/// Hard wall, quasistatic tail: u = W f, and the edge law between f and u − x_dyn.
class QuasistaticTail final : public ContactResponse {
 public:
  QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] double half_width() const override { return contact_.half_width(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double stored_energy() const override { return contact_.energy(force_, displacement_); }
  [[nodiscard]] double range() const override { return range_; }

 private:
  EdgeContact contact_;
  double range_;
  std::vector<double> force_;
  std::vector<double> displacement_;
};

}  // namespace stoss
