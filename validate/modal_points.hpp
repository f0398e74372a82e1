#pragma once

#include <optional>
#include <string>
#include <vector>

#include "points.hpp"

namespace validate {

/// A sphere that is given by its modes at a point, in units of itself, and what it meets.
struct ModalCase {
  double poisson = 0.0;
  double complete_to = 0.0;  ///< ω of its modes
  bool bends = true;         ///< whether their χ are given
  /// By how much its surface is flatter than that of a sphere of the same curvature near the point, H³r⁴. Nothing that
  /// is given tells it.
  double flatter = 0.0;
  /// How far what is given may be off, and is: c₀, and shares of ω and of φ.
  double compliance_error = 0.0, compliance_off = 0.0;
  double frequency_error = 0.0, frequency_off = 0.0;
  double displacement_error = 0.0, displacement_off = 0.0;
  std::string against;  ///< wall, sphere, half_space, plate, its like
  double size = 1.0;    ///< radius or thickness of what it meets
  double its_poisson = 0.0, its_young = 1.0, its_density = 1.0;
  double speed = 0.0;
};

/// What meets, with the body as it is given.
stoss::RefinableContact given(const ModalCase& its);

/// The same with the sphere itself, ground flatter near the point.
stoss::RefinableContact exact(const ModalCase& its);

/// An impact of such a body with reference values; their `error` is the uncertainty.
struct ModalPoint {
  ModalCase its;
  PerQuantity<std::optional<stoss::Estimate>> reference;
};

/// Those of validate/data/reference_modal.csv. @throws std::runtime_error as read_points
std::vector<ModalPoint> read_modal();

}  // namespace validate
