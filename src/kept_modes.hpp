#pragma once

#include <cstddef>
#include <vector>

#include "kernels.hpp"
#include "stoss/body.hpp"

namespace stoss {

/// The kept modes of a body as driven oscillators, advanced by kick and exact rotation: a = ωQ, b = Q̇.
///
/// Between two steps b is the velocity before the kick that is due, whose two halves end one step and begin the next.
/// All that is read out (energies, momenta) is synchronous with the coordinates: half of that kick is applied.
class KeptModes {
 public:
  KeptModes(const Body& body, double step);

  /// Sets Q and P, in the order of the body's groups. @throws InvalidInput for another number of modes
  void set(const std::vector<double>& coordinate, const std::vector<double>& momentum);

  /// Makes f_i on the first `count` nodes the force of the kick that is due.
  void load(const ContactGrid& grid, const std::vector<double>& force, std::size_t count);

  /// Takes half of the kick that is due out of the velocities: for the very first step, which has only the other half.
  void begin();

  /// Kicks and rotates by one step.
  void advance();

  /// Adds the displacement towards the wall of each node of the grid.
  void add_displacement(const ContactGrid& grid, std::vector<double>& position) const;

  /// Adds each mode's energy to a running sum.
  void accumulate_energy();

  /// Σ ½m(Q̇² + ω²Q²).
  [[nodiscard]] double energy() const;

  /// Upper bound of the displacement of any node in free vibration.
  [[nodiscard]] double reach(const ContactGrid& grid) const;

  [[nodiscard]] std::vector<double> coordinate() const;
  [[nodiscard]] std::vector<double> momentum() const;
  [[nodiscard]] std::vector<double> energies() const;            ///< of each mode
  [[nodiscard]] std::vector<double> accumulated_energy() const;  ///< of each mode

 private:
  template <typename Value>
  [[nodiscard]] std::vector<double> collect(Value value) const;
  [[nodiscard]] kernels::Oscillators view();
  [[nodiscard]] double velocity(std::size_t group, std::size_t k) const;

  double mass_;
  double step_;
  std::size_t count_ = 0;
  std::vector<std::size_t> begin_;  // of each group in the padded arrays, and the end
  std::vector<std::size_t> size_;   // of each group without padding
  std::vector<double> omega_, a_, b_, cosine_, sine_, radial_, tangential_, radial_per_omega_, tangential_per_omega_;
  std::vector<double> energy_sum_;
  std::vector<kernels::EdgeAmplitude> push_;  // velocity kick of a full step per unit amplitude
  std::vector<kernels::EdgeAmplitude> edge_;  // Σ C Q, Σ S Q
};

}  // namespace stoss
