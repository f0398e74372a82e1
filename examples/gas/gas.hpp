#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision.hpp"
#include "queue.hpp"

namespace gas {

/// Hard round particles in a periodic box, disks in a square or spheres in a cube, that move freely between collisions,
/// which follow a rule: from event to event, by cells as large as the largest particle and a queue of the next event
/// of each (B. D. Lubachevsky, J. Comput. Phys. 94, 255, 1991).
template <std::size_t D>
class Gas {
 public:
  /// Particles on a lattice, shuffled, with velocities of Maxwell's distribution, no momentum and no spin.
  /// @param packing     share of the box that they fill; the lattice has room for some 0.4, of spheres 0.2
  /// @param temperature mean energy of a particle, over D/2
  Gas(std::vector<double> radii, double packing, double temperature, std::uint64_t seed);

  /// Moves on until a time.
  void advance(double until, const Rule& rule);

  /// Multiplies all velocities and spins, so that the energy is this.
  void scale_energy(double energy);

  [[nodiscard]] std::vector<Particle<D>> particles() const;  ///< all at the time of the gas
  [[nodiscard]] double side() const { return side_; }
  [[nodiscard]] double time() const { return now_; }
  [[nodiscard]] double energy() const { return translation() + rotation(); }
  [[nodiscard]] double translation() const;
  [[nodiscard]] double rotation() const;
  /// Energies over half of the degrees of freedom.
  [[nodiscard]] double temperature() const { return translation() / (0.5 * degrees(D)); }
  [[nodiscard]] double temperature_of_rotation() const { return rotation() / (0.5 * degrees(D == 2 ? 1 : 3)); }

  [[nodiscard]] std::size_t size() const { return particles_.size(); }
  [[nodiscard]] long collisions() const { return collisions_; }

  /// Σ impulse × distance of the centres over all collisions: pressure × volume = NT + virial/(D time).
  [[nodiscard]] double virial() const { return virial_; }

 private:
  struct Event {
    std::size_t partner = 0;
    long changes = 0;      ///< of the partner when this was foreseen
    bool leaves = false;   ///< the cell, rather than meet the partner
    bool forward = false;  ///< along `axis`
    std::size_t axis = 0;
  };
  using Cell = std::array<std::size_t, D>;

  void place_on_lattice();
  void move(Particle<D>& particle) const;
  void foresee(std::size_t i);
  void leave_cell(std::size_t i);
  void meet(std::size_t i, std::size_t j, const Rule& rule);
  [[nodiscard]] double nearest(double distance) const;
  [[nodiscard]] double degrees(std::size_t each) const { return static_cast<double>(each * particles_.size()); }
  [[nodiscard]] Cell cell_of(std::size_t number) const;
  [[nodiscard]] std::size_t number_of(const Cell& cell) const;

  std::vector<Particle<D>> particles_;
  std::vector<Event> events_;
  EventQueue queue_;
  std::vector<std::vector<std::size_t>> cells_{};
  std::size_t across_ = 0;  ///< cells in a row
  double side_ = 0.0, width_ = 0.0, now_ = 0.0, virial_ = 0.0;
  long collisions_ = 0;
};

}  // namespace gas
