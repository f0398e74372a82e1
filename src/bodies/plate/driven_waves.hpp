#pragma once

#include <array>
#include <vector>

#include "bodies/surface/pressed.hpp"

namespace stoss::bodies::plate {

/// Waves q̈ + ω²q = F of one wave number, all driven by one force that is a polygon in time, from rest.
///
/// With w = ∫F e^{iω(t−s)} ds, q = Im w/ω and q̇ = Re w. A step h of the force turns w by e^{iωh} and adds
/// h(α F₀ + β F₁), α = ∫₀¹ x e^{iωhx} dx and β = ∫₀¹ (1 − x) e^{iωhx} dx.
class DrivenWaves {
 public:
  explicit DrivenWaves(const Instants& instants) : instants_(instants) {}

  /// @param normal, radial what its coordinate moves the point by
  /// @param slow share in which it follows the force slowly, q = F/ω²
  void add(double omega, double normal, double radial, double slow);

  /// Adds how a force, at each step, moves the point by all of them.
  /// @param left receives what their slow shares leave out, if not null
  void move(const std::vector<double>& force, Motion& motion, Motion* left) const;

 private:
  /// Weights of Im w, of Re w, and of a slow force and its rate, along the normal and the radius.
  struct Weights {
    std::vector<double> normal, radial, normal_rate, radial_rate;
    std::array<double, 2> slow{};
  };
  static void add(Motion& motion, std::size_t output, const std::array<double, 4>& moved);
  [[nodiscard]] std::array<double, 4> sums(const Weights& weights, const std::vector<double>& real,
                                           const std::vector<double>& imaginary) const;

  const Instants& instants_;
  Weights fast_, left_;
  std::vector<double> turn_cos_, turn_sin_, stride_cos_, stride_sin_;
  std::vector<double> first_cos_, first_sin_, next_cos_, next_sin_;
};

}  // namespace stoss::bodies::plate
