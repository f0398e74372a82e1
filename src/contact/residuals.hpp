#pragma once

#include <array>
#include <vector>

#include "contact/residual_motion.hpp"

namespace stoss {

/// The modes of all bodies that are not kept, part by part in series: one force, u = Σ u_k, u_k = W′_k f + h_k.
class Residuals {
 public:
  Residuals(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
            const Poll& poll);

  /// W′ = Σ W′_k
  [[nodiscard]] std::vector<double> compliance() const;

  /// Begins a step: h = Σ h_k, the displacement without force.
  const std::vector<double>& predict();

  /// Ends it with the force f, of which the first `count` may be other than 0, and the displacement u.
  void move(const std::vector<double>& displacement, const std::vector<double>& force, std::size_t count);

  /// What the material of the first and of the second body has taken.
  [[nodiscard]] std::array<double, 2> dissipated() const;

  /// Energy of the springs, in lossy bodies.
  [[nodiscard]] double stored() const;

 private:
  std::vector<ResidualMotion> parts_;
  std::vector<double> free_;           // of several parts
  std::vector<double> first_, second_;  // displacements
};

}  // namespace stoss
