#include "prediction/motion.hpp"

#include <algorithm>
#include <cmath>

namespace stoss::prediction {
namespace {

using quasistatic::InelasticContact;
using quasistatic::InelasticImpact;

/// Losses follow these numbers like powers between 0 and 1: their ratio to what is asked for leads to it.
double improved(double number, double asked, double got) {
  constexpr double most_change = 4.0, largest = 1e3, least = 1e-300;
  return std::min(number * std::clamp(asked / std::max(got, least), 1.0 / most_change, most_change), largest);
}

InelasticContact calibrated(double material, double waves, Waves form) {
  constexpr double accuracy = 1e-8, rounding = 1e-10;
  constexpr int most_rounds = 60;
  InelasticContact made;
  double& wave_number = form == Waves::of_force ? made.mobility : made.radiation;
  made.loss_time = material / 3.46;  // first orders
  wave_number = waves / 3.0;
  for (int i = 0; i < most_rounds; ++i) {
    const InelasticImpact got = inelastic_impact(made);
    const double miss = std::max(std::abs(got.material - material), std::abs(got.waves - waves));
    if (miss <= accuracy * (material + waves) + rounding) break;
    if (material > 0.0) made.loss_time = improved(made.loss_time, material, got.material);
    if (waves > 0.0) wave_number = improved(wave_number, waves, got.waves);
  }
  return made;
}

}  // namespace

Motion::Motion(const Computed& computed, Waves waves, double material_factor)
    : computed_(computed),
      lossy_(calibrated(std::max(computed.material, 0.0), std::max(computed.waves(), 0.0), waves)) {
  const double alone = inelastic_impact(lossy_).restitution;
  correction_ = alone > 0.0 ? computed.restitution / alone : 0.0;
  lossy_.loss_time *= material_factor;
}

Whole Motion::with(const Touching& touching, double speed, quasistatic::YieldLaw law) const {
  InelasticContact all = touching.contact(speed);
  all.yield_law = law;
  all.loss_time = lossy_.loss_time, all.radiation = lossy_.radiation, all.mobility = lossy_.mobility;
  InelasticImpact together = inelastic_impact(all);
  Whole made;
  made.time = together.contact_time * touching.time(speed);
  // Of bodies that stick, adhesion has what they would have left with.
  const bool sticks = together.sticks;
  if (sticks) {
    all.adhesion = 0.0;
    together = inelastic_impact(all);
  }
  const double left = std::min(together.restitution * correction_, 1.0);
  const double lost = 1.0 - together.restitution * together.restitution;
  const double factor = lost > 0.0 ? (1.0 - left * left) / lost : 0.0;
  const double ringing = computed_.waves() > 0.0 ? computed_.ringing / computed_.waves() : 0.0;
  made.restitution = sticks ? 0.0 : left;
  made.shares = {together.waves * ringing * factor, together.waves * (1.0 - ringing) * factor,
                 std::max(together.material, 0.0) * factor, std::max(together.yield, 0.0) * factor,
                 sticks ? left * left : together.adhesion * factor};
  return made;
}

}  // namespace stoss::prediction
