#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/residual/residual_part.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// How the modes of a ResidualPart move. The nodes' displacement u answers the force f with the dynamic stiffness
///
///   K/J(s) + [(s²M)⁻¹ + (G + sZ)⁻¹]⁻¹,   K = W⁻¹,   M = K V K,   G = γ ω_c Z,   γ = 8/π − π/2:
///
/// springs K that creep by J(s) in a lossy material, 1 without losses, and, parallel to them, masses M behind links of
/// a spring G and a dashpot Z. Its compliance is J W − s²J²V + O(s⁴) at low frequency, as that of the modes above the
/// cutoff ω_c, and without losses 1/(sZ) − (2/π) ω_c/(s²Z) at high frequency, as that of plane waves less the kept
/// modes. V is of low rank on the nodes, V = Y Yᵀ, so the masses move in few unit-mass coordinates ξ = Rᵀ (u − z), R =
/// K Y, with z the stretch of the links. By the trapezium rule for the masses, backward Euler for the links
/// (docs/developer/numerics.md, section 3) and u = θ d + w of the springs, with d their elastic strain and w what they
/// remember (CreepMemory, docs/theory/loss.md):
///
///   f = K d + R ξ̈ = K (u − w)/θ + R ξ̈,
///   ξ̈ = S⁻¹ (Rᵀu − r),   S = ¼Δt² + Rᵀ B⁻¹ R,   B = G + Z/Δt,
///   r = ξ + Δt ξ̇ + ¼Δt² ξ̈ + Rᵀz/(1 + γ ω_c Δt)   of the step before,
///   u = W′f + h,   W′ = θW − θY T θYᵀ,   T = (S + θYᵀR)⁻¹,   h = w + θY T (r − Rᵀw).
class ResidualMotion {
 public:
  /// Which of the modes that are not kept carry mass.
  enum class Inertia {
    none,  ///< none: u answers the force by itself, u = J W f
    all,   ///< all; and while nothing is lost, what the kicks leave out of the kept modes is in W
  };

  ResidualMotion(ResidualPart part, const Contact& contact, const ContactGrid& grid, Inertia inertia, double step,
                 const Poll& poll);

  /// W′, nodes × nodes.
  [[nodiscard]] const std::vector<double>& compliance() const { return matrices_->compliance; }

  /// Begins a step: h, the displacement without force.
  const std::vector<double>& predict();

  /// Ends it with the displacement u and the force f.
  void move(const std::vector<double>& displacement, const std::vector<double>& force);

  /// Whether the springs hold nothing but what creeps back: their elastic strain is below a limit.
  [[nodiscard]] bool is_still(const std::vector<double>& displacement, double negligible) const;

  /// Goes on for some time with no force, from where it is still; what has crept fades.
  void rest(double time);

  /// Of a lossy material: K u, the force that would displace the springs at once as they are.
  [[nodiscard]] std::vector<double> crept_force() const { return stress_.crept(); }

  /// What the material has taken so far, the work on its springs less what they hold.
  [[nodiscard]] double dissipated() const { return lossy_ ? work_ - stored() : 0.0; }

  /// Energy of the springs of a lossy contact; 0 of others.
  [[nodiscard]] double stored() const { return strain_.energy(stress_); }

 private:
  struct Matrices {
    std::vector<double> compliance;     // W′
    std::vector<double> participation;  // R, nodes × masses
    std::vector<double> mobility;       // S⁻¹, masses × masses
    std::vector<double> memory;         // θ T Yᵀ, masses × nodes
    std::vector<double> reaction;       // Rᵀ, masses × nodes; of a lossy material
    std::size_t masses = 0;
  };
  static Matrices discretize(const ResidualPart& part, const Contact& contact, const ContactGrid& grid, double step,
                             const Poll& poll);
  static Matrices massless(ResidualPart& part, double step);
  static double share_of(const Creep& creep, double step) { return CreepMemory(creep, step, 0).share(); }
  [[nodiscard]] numeric::kernels::Masses view();
  void lose(const std::vector<double>& displacement, const std::vector<double>& force);

  std::size_t nodes_;
  double step_;
  double fading_;                             // 1/(1 + γ ω_c Δt)
  std::shared_ptr<const Matrices> matrices_;  // shared by copies
  std::vector<double> free_;                  // h
  // Of the masses.
  std::vector<double> mass_displacement_, mass_velocity_, mass_acceleration_;  // ξ, ξ̇, ξ̈
  std::vector<double> stretch_;                                                // Rᵀz
  std::vector<double> rest_;                                                   // r; then Rᵀu − r
  std::vector<double> moved_;                                                  // Rᵀu
  // Of a lossy material.
  bool lossy_;
  CreepMemory strain_, mass_strain_, stress_;  // of u, Rᵀu and K u
  std::vector<double> drive_;                  // r − Rᵀw
  std::vector<double> displacement_;           // u of the step before
  std::vector<double> spring_force_, before_;  // K d, now and in the step before
  std::vector<double> reaction_;               // R ξ̈
  double work_ = 0.0;                          // on the springs
};

}  // namespace stoss
