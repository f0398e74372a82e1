#pragma once

#include "contact/complementarity.hpp"
#include "contact/response.hpp"

namespace stoss {

/// Hard wall, quasistatic tail: u = W f, contact f ≥ 0, x_dyn − u ≤ 0.
class QuasistaticTail final : public ContactResponse {
 public:
  QuasistaticTail(const Contact& contact, const ContactGrid& grid, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] std::size_t contact_nodes() const override { return contact_.extent(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double stored_energy() const override;

 private:
  Complementarity contact_;
  std::vector<double> force_;
  std::vector<double> displacement_;
};

}  // namespace stoss
