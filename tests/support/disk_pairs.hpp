#pragma once

#include <cmath>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/restitution/ladder.hpp"
#include "support/print.hpp"

namespace stoss::test {

inline double wave_speed(const Disk& disk) { return std::sqrt(disk.young / disk.density); }

/// The own units of a disk: length R, time R/c, mass ρR².
struct DiskUnits {
  explicit DiskUnits(const Disk& disk)
      : length(disk.radius), time(length / wave_speed(disk)), mass(disk.density * length * length) {}
  double length, time, mass;
};

/// Second bodies for a disk with R = E = ρ = 1: sizes, moduli, densities and Poisson's ratios all differ.
inline const std::vector<Disk> other_disks{{0.2, 0.5, 2.0, 3.0}, {-0.5, 3.0, 0.5, 0.2}, {0.9, 0.3, 1.0, 2.0}};

inline Contact pair_of(const Disk& first, const Disk& second, double cutoff) {
  return contact(disk(first), disk(second), cutoff);
}

/// The pair with its second disk called the first, at the same frequency in its units.
inline Contact swapped_pair(const Disk& first, const Disk& second, double cutoff) {
  return pair_of(second, first, cutoff * DiskUnits(second).time / DiskUnits(first).time);
}

}  // namespace stoss::test
