#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "queue.hpp"

namespace gas {

/// ε of a collision at a speed of approach of two disks with a ratio of radii.
using Law = std::function<double(double speed, double ratio)>;

/// A disk of density 1 at its own time.
struct Disk {
  double x = 0.0, y = 0.0;  ///< in the box
  double u = 0.0, w = 0.0;  ///< velocity
  double radius = 1.0, mass = 0.0;
  double time = 0.0;  ///< at which it is at (x, y)
  std::size_t cell = 0;
  long changes = 0;  ///< of its velocity
};

/// Smooth hard disks in a periodic square that move freely between collisions, which follow a law of ε: from event to
/// event, by cells as large as the largest disk and a queue of the next event of each disk (B. D. Lubachevsky, J.
/// Comput. Phys. 94, 255, 1991).
class Gas {
 public:
  /// Disks on a square lattice, shuffled, with velocities of Maxwell's distribution and no momentum.
  /// @param packing     share of the area that they cover; the lattice has room for some 0.4
  /// @param temperature mean energy of a disk
  Gas(std::vector<double> radii, double packing, double temperature, std::uint64_t seed);

  /// Moves on until a time.
  void advance(double until, const Law& law);

  /// Multiplies all velocities, so that the energy is this.
  void scale_energy(double energy);

  [[nodiscard]] std::vector<Disk> disks() const;  ///< all at the time of the gas
  [[nodiscard]] double side() const { return side_; }
  [[nodiscard]] double time() const { return now_; }
  [[nodiscard]] double energy() const;
  [[nodiscard]] long collisions() const { return collisions_; }

  /// Σ impulse × distance of the centres over all collisions: PA = NT + virial/(2 time).
  [[nodiscard]] double virial() const { return virial_; }

 private:
  struct Event {
    std::size_t partner = 0;
    long changes = 0;   ///< of the partner when this was foreseen
    int direction = 0;  ///< of leaving the cell, 1 … 4; 0: meets the partner
  };

  void move(Disk& disk) const;
  void foresee(std::size_t i);
  void leave_cell(std::size_t i);
  void collide(std::size_t i, std::size_t j, const Law& law);
  [[nodiscard]] double nearest(double distance) const;

  std::vector<Disk> disks_;
  std::vector<Event> events_;
  EventQueue queue_;
  std::vector<std::vector<std::size_t>> cells_{};
  std::size_t across_ = 0;  ///< cells in a row
  double side_ = 0.0, width_ = 0.0, now_ = 0.0, virial_ = 0.0;
  long collisions_ = 0;
};

}  // namespace gas
