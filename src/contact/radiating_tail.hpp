#pragma once

#include "contact/edge_contact.hpp"
#include "contact/response.hpp"

namespace stoss {

/// Hard wall, radiating tail. The nodes' displacement u answers the force f with the dynamic stiffness
///
///   K + [(s²M)⁻¹ + (G + sZ)⁻¹]⁻¹,   K = W⁻¹,   M = K V K,   G = γ ω_c Z,   γ = 8/π − π/2:
///
/// springs K and, beside them, masses M behind links of a spring G and a dashpot Z. Its compliance is W − s²V + O(s⁴)
/// at low frequency, as that of the modes above the cutoff, and 1/(sZ) − (2/π) ω_c/(s²Z) at high frequency, as that of
/// plane waves less the kept modes. V is of low rank on the nodes, V = Y Yᵀ, so the masses move in few unit-mass
/// coordinates η = Rᵀ (u − z), R = K Y, with z the stretch of the links. By the trapezium rule for the masses and
/// backward Euler for the links (docs/numerics.md, section 3):
///
///   f = K u + R η̈,   η̈ = S⁻¹ (Rᵀu − r),   S = ¼Δt² + Rᵀ B⁻¹ R,   B = G + Z/Δt,
///   r = η + Δt η̇ + ¼Δt² η̈ + Rᵀz/(1 + γ ω_c Δt),        all of the step before,
///   u = W′ (f + R S⁻¹ r),   W′ = (K + R S⁻¹ Rᵀ)⁻¹ = W − Y T Yᵀ,   W′R S⁻¹ = Y T,   T = (S + YᵀR)⁻¹,
///
/// the same contact problem as with the quasistatic tail, with W′ for W and x_dyn − W′R S⁻¹ r for x_dyn.
class RadiatingTail final : public ContactResponse {
 public:
  RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] double half_width() const override { return contact_.half_width(); }
  [[nodiscard]] bool overflows() const override { return contact_.extent() == force_.size(); }
  [[nodiscard]] double unresolved_energy() const override { return work_; }
  [[nodiscard]] double range() const override { return range_; }
  [[nodiscard]] double protrusion() const override;

 private:
  struct Matrices {
    std::vector<double> compliance;     // W′
    std::vector<double> participation;  // R, nodes × masses
    std::vector<double> mobility;       // S⁻¹, masses × masses
    std::vector<double> memory;         // T Yᵀ, masses × nodes
    std::size_t masses = 0;
  };
  static Matrices discretize(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll);
  RadiatingTail(Matrices matrices, EdgeLaw law, const ContactGrid& grid, double cutoff, double step, const Poll& poll);

  double step_;
  double fading_;        // 1/(1 + γ ω_c Δt)
  EdgeContact contact_;  // with W′
  double range_;
  std::vector<double> participation_, mobility_, memory_;
  // On the nodes.
  std::vector<double> position_;      // x_dyn
  std::vector<double> displacement_;  // u
  std::vector<double> force_, old_force_;
  std::vector<double> free_;                  // W′R S⁻¹ r
  std::vector<double> contact_displacement_;  // W′f
  std::vector<double> gap_;                   // x_dyn − W′R S⁻¹ r
  // Of the masses.
  std::vector<double> mass_displacement_, mass_velocity_, mass_acceleration_;  // η, η̇, η̈
  std::vector<double> stretch_;                                                // Rᵀz
  std::vector<double> rest_;                                                   // r; then Rᵀu − r
  std::vector<double> moved_;                                                  // Rᵀu
  // ∫ f u̇ dt = ∫ f ẋ_dyn dt, as f = 0 where the two differ; by the trapezium rule in x_dyn, which is smooth.
  double work_ = 0.0;
};

}  // namespace stoss
