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

/// Hard wall, radiating tail: the modes that are not kept have springs, masses and dashpots (ResidualMotion), and in a
/// time step u = W′f + h. The same contact problem as with the quasistatic tail, with W′ for W and x_dyn − h for x_dyn.
class RadiatingTail final : public HardContact {
 public:
  RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] double unresolved_energy() const override;
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] double stored_energy() const override { return residuals_.stored(); }

  /// A released node swings back through its rest position, but never as far as it was displaced.
  [[nodiscard]] double protrusion() const override { return largest_displacement(); }

 private:
  std::vector<double> contact_displacement_;  // W′f
  bool at_rest_ = true;                       // before anything has touched
  // ∫ f u̇ dt = ∫ f ẋ_dyn dt, as f = 0 where the two differ; by the trapezium rule in x_dyn, which is smooth.
  double work_ = 0.0;
};

}  // namespace stoss
