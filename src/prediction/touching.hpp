#pragma once

#include <array>
#include <optional>

#include "stoss/prediction/prediction.hpp"
#include "stoss/quasistatic/inelastic_impact.hpp"
#include "stoss/quasistatic/point_hertz.hpp"

namespace stoss::prediction {

/// What two round bodies are to the models, in SI.
struct Touching {
  quasistatic::PointPair pair;        ///< 1/m, 1/Pa
  double mass = 0.0;                  ///< reduced, kg
  std::optional<double> yield_speed;  ///< of the weaker one, m/s
  double work_of_adhesion = 0.0;      ///< J/m²
  bool sheet = false;                 ///< the second answers as a plate, by a velocity that follows the force

  /// T of an impact, s: inelastic_impact.hpp.
  [[nodiscard]] double time(double speed) const;

  /// a/R of Hertz' contact at its deepest.
  [[nodiscard]] double radius_ratio(double speed) const;

  /// (Rw²/(E*²z₀³))^{1/3}, D. Tabor's number with the range z₀ = 0.3 nm of surface forces: above 5 adhesion is as
  /// Johnson, Kendall and Roberts have it, below 0.1 as Derjaguin, Muller and Toporov, who have no jump and no loss.
  [[nodiscard]] double tabor_number() const;

  /// The models at a speed; loss time, radiation and mobility are not set.
  [[nodiscard]] quasistatic::InelasticContact contact(double speed) const;
};

/// Speed at which the contact of one that yields is as wide as 0.2 R: finite strain takes some 4 % of ε² there, and
/// more above.
[[nodiscard]] double speed_of_impression(const Touching& touching);

/// @throws InvalidInput unless a sphere with a material meets what a ball can
[[nodiscard]] Touching touching(const Encounter& encounter, std::optional<double> work_of_adhesion);

/// What the computed channels take by themselves, as shares of the energy.
struct Computed {
  double restitution = 1.0;  ///< ε
  double ringing = 0.0, radiation = 0.0, material = 0.0;

  [[nodiscard]] double waves() const { return ringing + radiation; }
};

/// All channels in one motion.
struct PredictedImpact {
  double restitution = 0.0;
  std::array<double, 5> shares{};  ///< in the order of Channel
  double time = 0.0;               ///< contact, s
};

/// How waves answer to the force: radiation to its rate, or, in a thin plate, a velocity to the force itself.
enum class Waves { of_rate, of_force };

/// The motion that without models loses what the computed channels do, to which models are added.
class CalibratedImpact {
 public:
  /// @param material_factor times the loss in the material
  CalibratedImpact(const Computed& computed, Waves waves, double material_factor = 1.0);

  /// With models: ε is that of the motion times what the computed one has over its own without models, 1 but where
  /// nearly all is lost.
  [[nodiscard]] PredictedImpact with(const Touching& touching, double speed,
                                     quasistatic::YieldLaw law = quasistatic::YieldLaw::finite_elements) const;

 private:
  Computed computed_;
  quasistatic::InelasticContact lossy_;
  double correction_ = 1.0;
};

}  // namespace stoss::prediction
