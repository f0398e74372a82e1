#pragma once

#include "complementarity.hpp"
#include "wall_response.hpp"

namespace stoss {

/// Hard wall, quasistatic tail: u = W f, contact f ≥ 0, x_dyn − u ≤ 0.
class QuasistaticTail final : public WallResponse {
 public:
  QuasistaticTail(const Body& body, const ContactGrid& grid);
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

/// Hard wall, radiating tail: (K + s Z τs/(1+τs)) u = f with K = W⁻¹, by backward Euler (docs/numerics.md):
///
///   u = W′(f + r),   r = (Z′/Δt)(u_old + Δt w_old),   w = (τ w_old + u − u_old)/(τ + Δt),
///   W′ = (K + Z′/Δt)⁻¹,   Z′ = Zτ/(τ + Δt),   τ = π/(6 ω_c),
///
/// the same contact problem with W′ for W and x_dyn − W′r for x_dyn.
class RadiatingTail final : public WallResponse {
 public:
  RadiatingTail(const Body& body, const ContactGrid& grid, double step);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] std::size_t contact_nodes() const override { return contact_.extent(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double unresolved_energy() const override { return work_; }
  [[nodiscard]] double protrusion() const override;

 private:
  double step_;
  double relaxation_;            // τ
  std::vector<double> damping_;  // Z′/Δt
  Complementarity contact_;      // with W′
  std::vector<double> force_, old_force_;
  std::vector<double> position_;              // x_dyn
  std::vector<double> displacement_;          // u
  std::vector<double> inner_velocity_;        // w
  std::vector<double> memory_;                // r
  std::vector<double> free_;                  // W′r
  std::vector<double> contact_displacement_;  // W′f
  std::vector<double> gap_;                   // x_dyn − W′r
  // ∫ f u̇ dt = ∫ f ẋ_dyn dt, as f = 0 where the two differ; by the trapezium rule in x_dyn, which is smooth.
  double work_ = 0.0;
};

}  // namespace stoss
