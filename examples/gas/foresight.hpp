#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas.hpp"

/// The next event of a particle, for gas.cpp.
namespace gas {

/// It leaves its cell, or meets a particle of this or a neighbouring cell.
template <std::size_t D>
void Gas<D>::foresee(std::size_t i) {
  Particle<D>& its = particles_[i];
  move(its);
  const Cell cell = cell_of(its.cell);
  double soonest = std::numeric_limits<double>::infinity();
  Event event;
  for (std::size_t k = 0; k < D; ++k) {
    const double velocity = its.velocity[k];
    if (velocity == 0.0) continue;
    const double edge = static_cast<double>(velocity > 0.0 ? cell[k] + 1 : cell[k]) * width_;
    const double wait = std::max(0.0, (edge - its.place[k]) / velocity);
    if (wait < soonest) {
      soonest = wait;
      event.leaves = true;
      event.forward = velocity > 0.0;
      event.axis = k;
    }
  }
  constexpr std::size_t around = D == 2 ? 9 : 27;
  for (std::size_t beside = 0; beside < around; ++beside) {
    Cell near;
    for (std::size_t k = 0, digits = beside; k < D; ++k, digits /= 3) {
      near[k] = (cell[k] + digits % 3 + across_ - 1) % across_;
    }
    for (const std::size_t j : cells_[number_of(near)]) {
      if (j == i) continue;
      const Particle<D>& other = particles_[j];
      const double age = now_ - other.time;
      Vector<D> place, velocity;
      for (std::size_t k = 0; k < D; ++k) {
        place[k] = nearest(other.place[k] + other.velocity[k] * age - its.place[k]);
        velocity[k] = other.velocity[k] - its.velocity[k];
      }
      const double approach = -dot(place, velocity);
      if (approach <= 0.0) continue;
      // |r + vt| = R₁ + R₂; the root that is exact where the particles touch already.
      const double sum = its.radius + other.radius, gap = dot(place, place) - sum * sum;
      const double discriminant = approach * approach - dot(velocity, velocity) * gap;
      if (discriminant < 0.0) continue;
      const double wait = std::max(0.0, gap / (approach + std::sqrt(discriminant)));
      if (wait < soonest) {
        soonest = wait;
        event = {j, other.changes, false, false, 0};
      }
    }
  }
  events_[i] = event;
  queue_.set(i, now_ + soonest);
}

template <std::size_t D>
void Gas<D>::leave_cell(std::size_t i) {
  Particle<D>& its = particles_[i];
  move(its);
  std::vector<std::size_t>& old = cells_[its.cell];
  old.erase(std::find(old.begin(), old.end(), i));
  // Exactly on the edge, at the other side of the box if it has left that.
  const auto [axis, forward] = std::pair(events_[i].axis, events_[i].forward);
  Cell cell = cell_of(its.cell);
  cell[axis] = (forward ? cell[axis] + 1 : cell[axis] + across_ - 1) % across_;
  its.place[axis] = static_cast<double>(forward ? cell[axis] : cell[axis] + 1) * width_;
  its.cell = number_of(cell);
  cells_[its.cell].push_back(i);
}

}  // namespace gas
