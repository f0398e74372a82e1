#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/mode_tables.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// The kept modes of a contact as driven oscillators of one mass, advanced by kick and exact free motion: a = √ω Q,
/// b = Q̇/√ω. They rotate; those of a lossy body are sums of a decaying rotation and of decays (LossyOscillator).
///
/// Between two steps b is the velocity before the kick that is due, whose two halves end one step and begin the next.
/// All that is read out (energies, momenta) is synchronous with the coordinates: half of that kick is applied.
class KeptModes {
 public:
  explicit KeptModes(std::shared_ptr<const ModeTables> tables);
  KeptModes(const Contact& contact, const ContactGrid& grid, double step, Kicks kicks = Kicks::whole);

  /// Sets Q and P, in the order of the contact's groups. @throws InvalidInput for another number of modes
  void set(const std::vector<double>& coordinate, const std::vector<double>& momentum);

  /// Makes f_i on the first `count` nodes the force of the kick that is due.
  void load(const std::vector<double>& force, std::size_t count);

  /// Takes half of the kick that is due out of the velocities: for the very first step, which has only the other half.
  void begin();

  /// Kicks, and moves freely by one step.
  void advance();

  /// The same modes now, with no force due, in steps of another length. Of bodies that lose nothing.
  [[nodiscard]] KeptModes in_flight(std::shared_ptr<const ModeTables> steps) const;

  /// Moves freely by any time at once, with no force due.
  void fly(double time);

  [[nodiscard]] double step() const { return tables_->step; }
  [[nodiscard]] std::size_t count() const { return tables_->count; }

  /// Adds the displacement towards the wall of each node.
  void add_displacement(std::vector<double>& position);

  /// Adds each mode's energy to a running sum, of bodies that relax that of its decaying rotation alone.
  void accumulate_energy();

  /// Energy of all kept modes, Σ ½m(Q̇² + ω²Q²), of bodies that relax that of their springs.
  [[nodiscard]] double energy() const;

  /// Energy that the modes of some groups have lost to their material so far: ∫ 2γ Q̇² dt or, of modes that relax,
  /// the work of the kicks less their energy; both in velocities between those before and after a kick, as the jumps
  /// between these would lose energy of their own.
  [[nodiscard]] double dissipated(std::size_t begin, std::size_t end) const;

  /// Upper bound of the displacement of any node in free vibration, but for waves that run away.
  [[nodiscard]] double reach() const { return reach(0, tables_->nodes); }

  /// The same of its acceleration, Σ ω² |A|.
  [[nodiscard]] double greatest_acceleration() const;

  /// The same of the nodes begin … end − 1, where those of other directions follow.
  [[nodiscard]] double reach(std::size_t begin, std::size_t end) const;

  /// Displacement of the first node by waves that run away, some time later in free motion.
  [[nodiscard]] double waves_later(double time) const;

  /// The same without what materials that relax still hold: what swings on by itself.
  [[nodiscard]] KeptModes ringing() const;

  [[nodiscard]] std::vector<double> coordinate() const;
  [[nodiscard]] std::vector<double> momentum() const;
  [[nodiscard]] std::vector<double> energies() const;            ///< of each mode
  [[nodiscard]] std::vector<double> accumulated_energy() const;  ///< of each mode

 private:
  template <typename Value>
  [[nodiscard]] std::vector<double> collect(Value value) const;
  [[nodiscard]] numeric::kernels::Oscillators view();
  [[nodiscard]] double kick(std::size_t group, std::size_t k) const;  // that is due, of b
  [[nodiscard]] double displacement(std::size_t group, std::size_t index) const;
  [[nodiscard]] double displacement_later(std::size_t group, std::size_t index, double time) const;
  [[nodiscard]] double velocity(std::size_t group, std::size_t index) const;
  [[nodiscard]] double velocity_before(std::size_t group, std::size_t index) const;  // the kick
  [[nodiscard]] double energy_of(std::size_t group, std::size_t index) const;
  template <typename Weight>
  [[nodiscard]] double sum_of_amplitudes(std::size_t begin, std::size_t end, Weight weight) const;
  void rotate(std::size_t group, std::size_t index, double time);
  // Of bodies that lose energy.
  void fade(std::size_t group, double time);
  void begin_lossy(std::size_t group);
  void advance_lossy();
  [[nodiscard]] double energy_of_lossy(std::size_t group, std::size_t index) const;
  [[nodiscard]] double lossy_displacement_later(std::size_t group, std::size_t index, double time) const;
  [[nodiscard]] double lost_now(std::size_t group) const;
  [[nodiscard]] double work_due(std::size_t group, double share) const;  // of the kick that is due
  void advance_relaxing(std::size_t block);
  void advance_common(std::size_t group);
  [[nodiscard]] double decaying(std::size_t group, std::size_t index, std::size_t number) const;

  std::shared_ptr<const ModeTables> tables_;
  std::vector<double> a_, b_, energy_sum_;
  std::vector<double> decays_;  // what a lacks of the displacement, of bodies that relax
  struct Push {
    double upper = 0.0, lower = 0.0;
  };
  std::vector<std::vector<Push>> common_;  // of each group: kicks that are left in each decay of all its modes
  std::vector<double> lost_;               // by each group, in units of the mass, but for what the present step adds
  std::vector<double> push_;       // velocity kick of a full step per unit amplitude; as kernels::advance has it
  std::vector<double> edge_;       // Σ C Q, then Σ S Q, over each group
  std::vector<double> amplitude_;  // of each shape in the motion; force on it
  std::vector<double> moved_;      // displacement of the nodes
};

}  // namespace stoss
