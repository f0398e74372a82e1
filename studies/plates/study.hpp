#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stoss/bodies/plate.hpp"
#include "stoss/material.hpp"
#include "stoss/restitution/curve.hpp"

/// Balls on elastic plates. Each function writes one table.
namespace study {

/// A ball and what it meets in units of the ball: R = E = ρ = 1.
struct Pair {
  double ball_poisson = 0.3;
  double poisson = 0.3;  ///< of the plate, as the others
  double young = 1.0;
  double density = 1.0;
  bool rigid = false;  ///< the ball keeps its mass and shape

  [[nodiscard]] double pressure_speed() const;  ///< c_p of the plate
};

[[nodiscard]] Pair pair_of(const stoss::Material& ball, const stoss::Material& plate);

/// To 10⁻³ of 1 − ε², of which an error of 10⁻⁶ is always small enough.
[[nodiscard]] std::vector<stoss::Restitution> on_plate(const Pair& pair, double thickness,
                                                       const std::vector<double>& speeds);
[[nodiscard]] std::vector<stoss::Restitution> on_block(const Pair& pair, const std::vector<double>& speeds);
[[nodiscard]] std::vector<stoss::Restitution> on_layers(const Pair& pair, const stoss::Plate& plate,
                                                        const std::vector<double>& speeds);

/// Zener's theory of thin plates: λ, ε and the contact time of it, R/c, by Runge and Kutta's rule.
struct Zener {
  double inelasticity, restitution, contact_time;
};
[[nodiscard]] Zener zener(const Pair& pair, double thickness, double speed);

/// What the plate moves by under the whole momentum of the ball, 1/(8√(Dρh)) times it, over its thickness.
[[nodiscard]] double deflection(const Pair& pair, double thickness, double speed, double restitution);

/// Speed at which a ball of that radius, m, or a block that it meets begins to yield, m/s, as text; empty where neither
/// has a yield strength.
[[nodiscard]] std::string yield_speed(const stoss::Material& ball, double radius, const stoss::Material& block);

[[nodiscard]] std::vector<double> series(double from, double to, int count);

void write_fast(const std::string& name);
void write_materials(const std::string& name);
void write_map(const std::string& name);
void write_block(const std::string& name);
void write_layers(const std::string& name);

}  // namespace study
