#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// What the waves of a half-space do to a contact that they have left: a memory of its forces, in place of the waves.
///
/// Kicks of n nodes at steps j move them, by way of oscillators of the shapes φ and of the contact's mass, by
///
///   u(k) = −Σ_{j<k} K(k − j) f(j),   K(l) = (Δt/m) Σ φ φᵀ sin(ω l Δt)/ω.
///
/// Waves that are long against the contact hardly vary across it. So all of their shapes are, to rounding, those of a
/// few, and of thousands of waves a few functions of time are left. It is the kick–rotate–kick of KeptModes otherwise.
class WaveMemory {
 public:
  /// Of no waves, where those of the contact along its surface cannot be remembered, or for no steps.
  /// @param steps the longest time that is remembered
  WaveMemory(const Contact& along, const ContactGrid& grid, double step, std::size_t steps, const Poll& poll);

  /// Makes these the forces of the kick that is due.
  void load(const std::vector<double>& force);

  /// Kicks, and moves on by one step.
  void advance();

  /// Adds the displacement of each node.
  void add_displacement(std::vector<double>& position) const;

  /// Energy of the waves, after half of the kick that is due.
  [[nodiscard]] double energy() const;

 private:
  /// What all contacts of a kind have in common.
  struct Response {
    std::size_t nodes = 0, shapes = 0, steps = 0;
    double weight = 0.0;                 // of energy
    std::vector<double> shape;           // shapes × nodes, orthonormal
    std::vector<double> sine, cosine;    // of each shape: kicked shapes × (moved shapes × steps)
    std::vector<double> cosine_at_once;  // shapes × shapes
  };
  static Response response(const Contact& along, const ContactGrid& grid, double step, std::size_t steps,
                           const Poll& poll);
  [[nodiscard]] double energy_after(double share) const;

  std::shared_ptr<const Response> response_;  // null: of no waves
  std::size_t step_ = 0;
  std::vector<double> kick_;              // that is due, on each shape
  std::vector<double> place_, velocity_;  // moved shapes × steps: what past kicks will do
  double energy_ = 0.0;                   // before the kick that is due
};

/// Whether a contact has waves that can be remembered: undamped ones of a half-space, each of one shape.
[[nodiscard]] bool remembers_waves(const Contact& along);

/// A contact without the waves that are remembered, and its grid: of its modes alone.
[[nodiscard]] std::pair<Contact, ContactGrid> without_remembered(Contact along, ContactGrid grid);

}  // namespace stoss
