#include "gas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include "foresight.hpp"

namespace gas {
namespace {

constexpr double pi = std::numbers::pi;

/// Uniform in 0 … 1, and two Gaussian numbers (Box and Muller), the same with every standard library.
double uniform(std::mt19937_64& random) { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; }

std::pair<double, double> gaussian(std::mt19937_64& random) {
  const double radius = std::sqrt(-2.0 * std::log(uniform(random))), angle = 2.0 * pi * uniform(random);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

template <std::size_t D>
Particle<D> particle_of(double radius, std::mt19937_64& random) {
  Particle<D> its;
  its.radius = radius;
  its.mass = D == 2 ? pi * radius * radius : 4.0 / 3.0 * pi * radius * radius * radius;
  its.inertia = (D == 2 ? 0.5 : 0.4) * its.mass * radius * radius;
  for (std::size_t k = 0; k < D; k += 2) {
    const auto [first, second] = gaussian(random);
    its.velocity[k] = first / std::sqrt(its.mass);
    if (k + 1 < D) its.velocity[k + 1] = second / std::sqrt(its.mass);
  }
  return its;
}

}  // namespace

template <std::size_t D>
Gas<D>::Gas(std::vector<double> radii, double packing, double temperature, std::uint64_t seed)
    : particles_(radii.size()), events_(radii.size()), queue_(radii.size()) {
  std::mt19937_64 random(seed);
  for (std::size_t i = radii.size(); i > 1; --i) std::swap(radii[i - 1], radii[random() % i]);
  double mass = 0.0;
  Vector<D> momentum{};
  for (std::size_t i = 0; i < radii.size(); ++i) {
    Particle<D>& its = particles_[i];
    its = particle_of<D>(radii[i], random);
    mass += its.mass;
    add(momentum, its.mass, its.velocity);
  }
  for (Particle<D>& its : particles_) {
    for (std::size_t k = 0; k < D; ++k) its.velocity[k] -= momentum[k] / mass;
  }
  // The density is 1.
  side_ = D == 2 ? std::sqrt(mass / packing) : std::cbrt(mass / packing);
  place_on_lattice();
  scale_energy(0.5 * static_cast<double>(D) * temperature * static_cast<double>(particles_.size()));
}

template <std::size_t D>
void Gas<D>::place_on_lattice() {
  double largest = 0.0;
  for (const Particle<D>& its : particles_) largest = std::max(largest, its.radius);
  across_ = static_cast<std::size_t>(side_ / (2.0 * largest));
  if (across_ < 4) throw std::invalid_argument("gas: fewer than four cells across (take more particles)");
  width_ = side_ / static_cast<double>(across_);
  std::size_t row = 1, cells = across_;
  for (std::size_t k = 1; k < D; ++k) cells *= across_;
  cells_.resize(cells);
  while (std::pow(static_cast<double>(row), D) < static_cast<double>(particles_.size())) ++row;
  const double spacing = side_ / static_cast<double>(row);
  if (spacing < 2.0 * largest) {
    throw std::invalid_argument("gas: particles overlap on the lattice (take a lower packing)");
  }
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle<D>& its = particles_[i];
    Cell cell{};
    std::size_t left = i;
    for (std::size_t k = 0; k < D; ++k, left /= row) {
      its.place[k] = (static_cast<double>(left % row) + 0.5) * spacing;
      cell[k] = std::min(static_cast<std::size_t>(its.place[k] / width_), across_ - 1);
    }
    its.cell = number_of(cell);
    cells_[its.cell].push_back(i);
  }
}

template <std::size_t D>
typename Gas<D>::Cell Gas<D>::cell_of(std::size_t number) const {
  Cell cell;
  for (std::size_t& each : cell) {
    each = number % across_;
    number /= across_;
  }
  return cell;
}

template <std::size_t D>
std::size_t Gas<D>::number_of(const Cell& cell) const {
  std::size_t number = 0;
  for (std::size_t k = D; k > 0; --k) number = number * across_ + cell[k - 1];
  return number;
}

template <std::size_t D>
void Gas<D>::scale_energy(double energy_wanted) {
  const double factor = std::sqrt(energy_wanted / energy());
  for (Particle<D>& its : particles_) {
    move(its);
    for (double& each : its.velocity) each *= factor;
    for (double& each : its.spin) each *= factor;
    ++its.changes;
  }
  for (std::size_t i = 0; i < particles_.size(); ++i) foresee(i);
}

template <std::size_t D>
double Gas<D>::translation() const {
  double sum = 0.0;
  for (const Particle<D>& its : particles_) sum += its.translation();
  return sum;
}

template <std::size_t D>
double Gas<D>::rotation() const {
  double sum = 0.0;
  for (const Particle<D>& its : particles_) sum += its.rotation();
  return sum;
}

template <std::size_t D>
std::vector<Particle<D>> Gas<D>::particles() const {
  std::vector<Particle<D>> all = particles_;
  for (Particle<D>& its : all) move(its);
  return all;
}

template <std::size_t D>
void Gas<D>::advance(double until, const Rule& rule) {
  while (queue_.time(queue_.first()) <= until) {
    const std::size_t i = queue_.first();
    const Event& event = events_[i];
    now_ = queue_.time(i);
    if (event.leaves) {
      leave_cell(i);
    } else if (particles_[event.partner].changes == event.changes) {
      meet(i, event.partner, rule);
      continue;
    }
    foresee(i);  // in the new cell, or because the partner has met another
  }
  now_ = until;
}

template <std::size_t D>
void Gas<D>::move(Particle<D>& its) const {
  add(its.place, now_ - its.time, its.velocity);
  its.time = now_;
}

/// The same distance between the nearest images.
template <std::size_t D>
double Gas<D>::nearest(double distance) const {
  if (distance > 0.5 * side_) return distance - side_;
  return distance < -0.5 * side_ ? distance + side_ : distance;
}

template <std::size_t D>
void Gas<D>::meet(std::size_t i, std::size_t j, const Rule& rule) {
  Particle<D>&first = particles_[i], &second = particles_[j];
  move(first);
  move(second);
  Vector<D> normal;
  for (std::size_t k = 0; k < D; ++k) normal[k] = nearest(second.place[k] - first.place[k]);
  const double distance = length(normal);
  for (double& each : normal) each /= distance;
  virial_ += collide(first, second, normal, rule) * distance;
  ++first.changes;
  ++second.changes;
  ++collisions_;
  foresee(i);
  foresee(j);
}

template class Gas<2>;
template class Gas<3>;

}  // namespace gas
