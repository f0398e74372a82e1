#pragma once

#include <vector>

#include "half_space.hpp"
#include "newton.hpp"

namespace yield_study {

/// What an indenter is at: depth, force, radius of contact.
struct Reading {
  double depth, force, radius;
  int nodes;  ///< in contact
  int iterations;
};

/// Pushes a rigid paraboloid z = r²/2R − depth without friction into a half-space at small strain.
class Indentation {
 public:
  Indentation(HalfSpace half_space, double radius_of_curvature);
  Indentation(const Indentation&) = delete;
  Indentation& operator=(const Indentation&) = delete;

  /// Goes to this depth in one step, or in as many as it takes to find equilibrium.
  /// @throws std::runtime_error where no equilibrium is found
  Reading go(double depth);

  [[nodiscard]] Energies energies() const { return half_space_.body.energies(); }
  [[nodiscard]] const Body& body() const { return half_space_.body; }
  /// (r, uz) of the surface.
  [[nodiscard]] std::vector<Eigen::Vector2d> surface() const;

 private:
  [[nodiscard]] double target(std::size_t node, double depth) const;
  [[nodiscard]] int unknown(std::size_t node) const;
  bool update_contact(double depth);
  Reading go(double depth, int halvings);
  [[nodiscard]] int attempt(double depth);
  [[nodiscard]] Reading reading(double depth, int iterations) const;

  HalfSpace half_space_;
  double curvature_radius_, depth_ = 0.0;
  Newton newton_;
  Eigen::VectorXd unknowns_, none_;
  std::vector<char> touching_;  ///< by unknown
  std::size_t candidates_;      ///< nodes of the surface that may touch: all but the last
};

}  // namespace yield_study
