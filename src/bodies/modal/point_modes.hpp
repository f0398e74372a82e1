#pragma once

#include <vector>

#include "stoss/bodies/modal_body.hpp"

namespace stoss::bodies::modal {

/// A kept mode in units of the body, with the mass of the body as its own.
struct KeptMode {
  double omega;
  double displacement;     ///< φ
  double bend;             ///< χ
  double tangential;       ///< ψ
  double tangential_bend;  ///< χ_t
};

/// A body as its contact sees it, in units own_length = c = ρ = 1.
struct PointModes {
  double mass;            ///< m
  double constant;        ///< c₀
  double constant_along;  ///< c_t, or 0
  std::vector<KeptMode> kept;
};

/// Those up to a cutoff in these units.
[[nodiscard]] PointModes point_modes(const ModalBody& body, double cutoff);

/// Throws InvalidInput as `modal_body`.
void require_body(const ModalBody& body);

}  // namespace stoss::bodies::modal
