#pragma once

#include <cstddef>
#include <vector>

#include "numeric/kernels.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// How a lossy contact kicks its modes.
enum class Kicks {
  whole,
  weaker  ///< by as much as the modes follow the force at once in addition (numeric::StableKicks)
};

/// The kept modes of a contact as driven oscillators of one mass, advanced by kick and exact free motion: a = √ω Q,
/// b = Q̇/√ω. They rotate, and those of a lossy body decay besides, at γ = ηω²/2.
///
/// Between two steps b is the velocity before the kick that is due, whose two halves end one step and begin the next.
/// All that is read out (energies, momenta) is synchronous with the coordinates: half of that kick is applied.
class KeptModes {
 public:
  KeptModes(const Contact& contact, const ContactGrid& grid, double step, Kicks kicks = Kicks::whole);

  /// Sets Q and P, in the order of the contact's groups. @throws InvalidInput for another number of modes
  void set(const std::vector<double>& coordinate, const std::vector<double>& momentum);

  /// Makes f_i on the first `count` nodes the force of the kick that is due.
  void load(const std::vector<double>& force, std::size_t count);

  /// Takes half of the kick that is due out of the velocities: for the very first step, which has only the other half.
  void begin();

  /// Kicks, and moves freely by one step.
  void advance();

  /// The same modes now, with no force due, in steps four times as long. Of bodies that lose nothing.
  [[nodiscard]] KeptModes in_flight() const;

  [[nodiscard]] double step() const { return step_; }

  /// Adds the displacement towards the wall of each node.
  void add_displacement(std::vector<double>& position);

  /// Adds each mode's energy to a running sum.
  void accumulate_energy();

  /// Energy of all kept modes, Σ ½m(Q̇² + ω²Q²).
  [[nodiscard]] double energy() const;

  /// Energy ∫ m 2γ Q̇² dt that the modes of some groups have lost to their material so far, by the trapezium rule in
  /// velocities between those before and after a kick: the jumps between these would lose energy of their own.
  [[nodiscard]] double dissipated(std::size_t begin, std::size_t end) const;

  /// Upper bound of the displacement of any node in free vibration, but for waves that run away.
  [[nodiscard]] double reach() const { return reach(0, nodes_); }

  /// The same of its acceleration, Σ ω² |A|.
  [[nodiscard]] double greatest_acceleration() const;

  /// The same of the nodes begin … end − 1, where those of other directions follow.
  [[nodiscard]] double reach(std::size_t begin, std::size_t end) const;

  /// Displacement of the first node by waves that run away, some time later in free motion.
  [[nodiscard]] double waves_later(double time) const;

  [[nodiscard]] std::vector<double> coordinate() const;
  [[nodiscard]] std::vector<double> momentum() const;
  [[nodiscard]] std::vector<double> energies() const;            ///< of each mode
  [[nodiscard]] std::vector<double> accumulated_energy() const;  ///< of each mode

 private:
  template <typename Value>
  [[nodiscard]] std::vector<double> collect(Value value) const;
  [[nodiscard]] numeric::kernels::Oscillators view();
  [[nodiscard]] std::size_t blocks() const { return begin_.size() - 1; }
  [[nodiscard]] std::size_t position(std::size_t group, std::size_t index) const;  // in the arrays over modes
  [[nodiscard]] double velocity(std::size_t group, std::size_t k) const;
  template <typename Weight>
  [[nodiscard]] double sum_of_amplitudes(std::size_t begin, std::size_t end, Weight weight) const;
  void place_rows(const Contact& contact);
  void damp(const Contact& contact, Kicks kicks);
  [[nodiscard]] double half_power(std::size_t group) const;

  double mass_;
  double step_;
  std::size_t count_ = 0;
  std::size_t nodes_;
  std::size_t lasting_groups_;      // of bounded bodies
  std::vector<std::size_t> size_;   // modes of each group
  std::vector<std::size_t> begin_;  // of each block of groups in the arrays over modes, and the end
  std::vector<double> omega_, a_, b_, cosine_, sine_, upper_, lower_;
  std::vector<double> energy_sum_;
  std::vector<double> velocity_cosine_;  // what a free step leaves of b, if any mode is damped; else empty
  std::vector<double> rate_;             // 2γωΔt of each mode: m Q̇² 2γΔt = m rate b²
  std::vector<double> due_;              // as kernels::advance_damped has it
  std::vector<double> lost_;             // of each group in units of the mass, all but half of the present power
  std::vector<double> amplitude_of_;     // of each group: Q of its body over that of the contact, √(mass/modal mass)
  std::vector<double> push_;             // velocity kick of a full step per unit amplitude; as kernels::advance has it
  std::vector<double> edge_;             // Σ C Q, then Σ S Q, over each group
  struct Rows {
    std::size_t upper, lower;
  };
  std::vector<Rows> shapes_of_;  // each group
  struct Run {
    std::size_t at, row, count;
  };
  std::vector<Run> runs_;               // neighbours in push and edge that are neighbours in the rows too
  std::vector<double> shapes_;          // shapes × nodes
  std::vector<double> shapes_by_node_;  // nodes × shapes, padded to whole vectors
  std::vector<double> amplitude_;       // of each shape in the motion; force on it
  std::vector<double> moved_;           // displacement of the nodes
};

}  // namespace stoss
