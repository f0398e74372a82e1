#pragma once

#include <array>

#include "prediction/touching.hpp"

namespace stoss::prediction {

/// What the computed channels take by themselves, as shares of the energy.
struct Computed {
  double restitution = 1.0;  ///< ε
  double ringing = 0.0, radiation = 0.0, material = 0.0;

  [[nodiscard]] double waves() const { return ringing + radiation; }
};

/// All channels in one motion.
struct Whole {
  double restitution = 0.0;
  std::array<double, 5> shares{};  ///< in the order of Channel
  double time = 0.0;               ///< contact, s
};

/// How waves answer to the force: radiation to its rate, or, in a thin plate, a velocity to the force itself.
enum class Waves { of_rate, of_force };

/// The motion that without models loses what the computed channels do, to which models are added.
class Motion {
 public:
  /// @param material_factor times the loss in the material
  Motion(const Computed& computed, Waves waves, double material_factor = 1.0);

  /// With models: ε is that of the motion times what the computed one has over its own without models, 1 but where
  /// nearly all is lost.
  [[nodiscard]] Whole with(const Touching& touching, double speed,
                           quasistatic::YieldLaw law = quasistatic::YieldLaw::finite_elements) const;

 private:
  Computed computed_;
  quasistatic::InelasticContact lossy_;
  double correction_ = 1.0;
};

}  // namespace stoss::prediction
