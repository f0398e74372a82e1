#pragma once

#include "contact/hard_contact.hpp"

namespace stoss {

/// Hard wall, quasistatic tail: u = W f, of a lossy material W f = u + η u̇ (ResidualMotion without masses), and the
/// edge law between f and u − x_dyn.
class QuasistaticTail final : public HardContact {
 public:
  QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] double stored_energy() const override;
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] double protrusion() const override;

 private:
  std::vector<double> old_displacement_;  // of lossy bodies
};

}  // namespace stoss
