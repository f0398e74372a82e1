#pragma once

#include <optional>

#include "stoss/encounter/relaxing.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/quasistatic/point_hertz.hpp"

namespace stoss::prediction {

/// What two round bodies are to the models, in SI.
struct Touching {
  quasistatic::PointPair pair;           ///< 1/m, 1/Pa
  double mass = 0.0;                     ///< reduced, kg
  std::optional<double> yield_strength;  ///< of the weaker one, Pa, and
  std::optional<double> yield_speed;     ///< from which on it yields, m/s
  double work_of_adhesion = 0.0;         ///< J/m²

  /// (m/k)^{2/5} v^{−1/5} of an impact, s, with the force k δ^{3/2}.
  [[nodiscard]] double time(double speed) const;

  /// a/R of Hertz' contact at its deepest.
  [[nodiscard]] double radius_ratio(double speed) const;

  /// (Rw²/(E*²z₀³))^{1/3}, D. Tabor's number with the range z₀ = 0.3 nm of surface forces: above 5 adhesion is as
  /// Johnson, Kendall and Roberts have it, below 0.1 as Derjaguin, Muller and Toporov, who have no jump and no loss.
  [[nodiscard]] double tabor_number() const;

  /// Speed of an impact that Hertz' theory compresses by a length, m.
  [[nodiscard]] double speed_of_compression(double length) const;

  /// Energy that adhesion takes as the bodies part, J: adhesion_energy of what is left of their curvature where a body
  /// has yielded down to a compression, m.
  [[nodiscard]] double adhesion(double compression) const;
};

/// The least share of Johnson's, Kendall's and Roberts' work that jumping into contact and out of it takes: that of a
/// static contact under the forces of Lennard and Jones, by the finite differences of studies/adhesion up to a Tabor
/// number of 3, and beyond as it grows there. 0 below 0.7, where nothing jumps.
[[nodiscard]] double least_work_of_jumps(double tabor_number);

/// Speed at which the contact of one that yields is as wide as 0.2 R: finite strain takes some 4 % of ε² there, and
/// more above.
[[nodiscard]] double speed_of_impression(const Touching& touching);

/// |E(iω)| of a material in SI over the modulus that it has. @param frequency rad/s
[[nodiscard]] double stiffer(const Losses& its, double frequency);

/// @param frequency rad/s, at which materials that relax have their modulus; by itself that of each material
/// @throws InvalidInput unless a sphere with a material meets what a ball can
[[nodiscard]] Touching touching(const Encounter& encounter, std::optional<double> work_of_adhesion,
                                std::optional<double> frequency = {});

}  // namespace stoss::prediction
