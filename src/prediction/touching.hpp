#pragma once

#include <array>
#include <optional>

#include "stoss/encounter/relaxing.hpp"
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

  /// Speed of an impact that Hertz' theory compresses by a length, m.
  [[nodiscard]] double speed_of_compression(double length) const;

  /// The models at a speed; radiation and mobility are not set.
  [[nodiscard]] quasistatic::InelasticContact contact(double speed) const;
};

/// Speed at which the contact of one that yields is as wide as 0.2 R: finite strain takes some 4 % of ε² there, and
/// more above.
[[nodiscard]] double speed_of_impression(const Touching& touching);

/// |E(iω)| of a material in SI over the modulus that it has. @param frequency rad/s
[[nodiscard]] double stiffer(const Losses& its, double frequency);

/// @param frequency rad/s, at which materials that relax have their modulus; by itself that of each material
/// @throws InvalidInput unless a sphere with a material meets what a ball can
[[nodiscard]] Touching touching(const Encounter& encounter, std::optional<double> work_of_adhesion,
                                std::optional<double> frequency = {});

/// What the computed channels take by themselves, as shares of the energy.
struct Computed {
  double restitution = 1.0;  ///< ε
  double ringing = 0.0, radiation = 0.0;
  double time = 0.0;  ///< of contact, s

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

/// The computed impact with models: a model of how all losses go together.
///
/// A motion of elastic bodies has the waves, matched by one number to those of the computed impact; yield and adhesion
/// act in it, and take less from each other and from the waves than alone. Heat follows the elastic energy that the
/// contact stores at its deepest, which waves and yield lessen: of this the materials take the same share as in the
/// computed impact of what waves leave there. Adhesion asks for its work as the bodies part.
///
///   q = ε_c²/(1 − w_c),   ε² = (1 − w − y) q − a,   material (1 − w − y)(1 − q)
///
/// ε_c and w_c are computed, w, y and a of the motion. Without models ε is ε_c; the bodies stick where ε² is not above
/// 0, and a is then what is left. The time of contact is the computed one times what models make of that of the motion.
class WavyImpact {
 public:
  WavyImpact(const Computed& computed, Waves form);

  [[nodiscard]] PredictedImpact with(const Touching& touching, double speed,
                                     quasistatic::YieldLaw law = quasistatic::YieldLaw::finite_elements) const;

 private:
  Computed computed_;
  quasistatic::InelasticContact contact_;
  double returned_ = 1.0;  ///< q
  double time_ = 0.0;      ///< of the motion without models
};

}  // namespace stoss::prediction
