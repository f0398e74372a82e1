#pragma once

#include "complementarity.hpp"
#include "wall_response.hpp"

namespace stoss {

/// Hard wall, radiating tail. The nodes' displacement u answers the force f with the dynamic stiffness
///
///   K + [(s²M)⁻¹ + (G + sZ)⁻¹]⁻¹,   K = W⁻¹,   M = K V K,   G = γ ω_c Z,   γ = 8/π − π/2:
///
/// springs K and, beside them, masses M behind links of a spring G and a dashpot Z. Its compliance is W − s²V + O(s⁴)
/// at low frequency, as that of the modes above the cutoff, and 1/(sZ) − (2/π) ω_c/(s²Z) at high frequency, as that of
/// plane waves less the kept modes. With y, w, a the masses' displacement, velocity and acceleration and z = u − y, by
/// the trapezium rule for the masses and backward Euler for the links (docs/numerics.md):
///
///   f = K u + D (u − ũ),   D = (¼Δt² M⁻¹ + B⁻¹)⁻¹,   B = G + Z/Δt,
///   ũ = y + Δt w + ¼Δt² a + z/(1 + γ ω_c Δt),        all of the step before,
///   u = W′ f + W′D ũ,   W′ = (K + D)⁻¹,   z = B⁻¹ D (u − ũ) + z_old/(1 + γ ω_c Δt),
///
/// the same contact problem as with the quasistatic tail, with W′ for W and x_dyn − W′D ũ for x_dyn.
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
  struct Matrices {
    std::vector<double> compliance;  // W′
    std::vector<double> memory;      // D W′, the transpose of W′D
    std::vector<double> drag;        // D
    std::vector<double> link;        // B⁻¹
  };
  static Matrices discretize(const Body& body, const ContactGrid& grid, double step);
  RadiatingTail(Matrices matrices, double cutoff, double step);

  double step_;
  double fading_;            // 1/(1 + γ ω_c Δt)
  Complementarity contact_;  // with W′
  std::vector<double> memory_, drag_, link_;
  std::vector<double> position_;      // x_dyn
  std::vector<double> displacement_;  // u
  std::vector<double> mass_displacement_, mass_velocity_, mass_acceleration_;
  std::vector<double> stretch_;  // z
  std::vector<double> force_, old_force_;
  std::vector<double> free_rest_;             // ũ; then u − ũ
  std::vector<double> free_;                  // W′D ũ
  std::vector<double> contact_displacement_;  // W′f
  std::vector<double> gap_;                   // x_dyn − W′D ũ
  std::vector<double> branch_force_;          // D (u − ũ)
  // ∫ f u̇ dt = ∫ f ẋ_dyn dt, as f = 0 where the two differ; by the trapezium rule in x_dyn, which is smooth.
  double work_ = 0.0;
};

}  // namespace stoss
