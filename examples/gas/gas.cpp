// Free flight, and at a collision along the line of the centres, with the relative velocity v of approach:
// impulse J = μ(1 + ε(v)) v, μ = m₁m₂/(m₁ + m₂).
#include "gas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

namespace gas {
namespace {

constexpr double pi = std::numbers::pi;

/// Uniform in 0 … 1, and two Gaussian numbers (Box and Muller), the same with every standard library.
double uniform(std::mt19937_64& random) { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; }

std::pair<double, double> gaussian(std::mt19937_64& random) {
  const double radius = std::sqrt(-2.0 * std::log(uniform(random))), angle = 2.0 * pi * uniform(random);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Gas::Gas(std::vector<double> radii, double packing, double temperature, std::uint64_t seed)
    : disks_(radii.size()), events_(radii.size()), queue_(radii.size()) {
  std::mt19937_64 random(seed);
  for (std::size_t i = radii.size(); i > 1; --i) std::swap(radii[i - 1], radii[random() % i]);
  double area = 0.0, mass = 0.0, u = 0.0, w = 0.0;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    Disk& disk = disks_[i];
    disk.radius = radii[i];
    disk.mass = pi * radii[i] * radii[i];
    const auto [first, second] = gaussian(random);
    disk.u = first / std::sqrt(disk.mass);
    disk.w = second / std::sqrt(disk.mass);
    area += disk.mass;
    mass += disk.mass;
    u += disk.mass * disk.u;
    w += disk.mass * disk.w;
  }
  for (Disk& disk : disks_) {
    disk.u -= u / mass;
    disk.w -= w / mass;
  }
  side_ = std::sqrt(area / packing);
  const double largest = *std::max_element(radii.begin(), radii.end());
  across_ = static_cast<std::size_t>(side_ / (2.0 * largest));
  if (across_ < 4) throw std::invalid_argument("gas: fewer than four cells across (take more disks)");
  width_ = side_ / static_cast<double>(across_);
  cells_.resize(across_ * across_);
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(radii.size()))));
  const double spacing = side_ / static_cast<double>(row);
  if (spacing < 2.0 * largest) throw std::invalid_argument("gas: disks overlap on the lattice (take a lower packing)");
  for (std::size_t i = 0; i < disks_.size(); ++i) {
    Disk& disk = disks_[i];
    disk.x = (static_cast<double>(i % row) + 0.5) * spacing;
    disk.y = (static_cast<double>(i / row) + 0.5) * spacing;
    const auto column = static_cast<std::size_t>(disk.x / width_), line = static_cast<std::size_t>(disk.y / width_);
    disk.cell = std::min(line, across_ - 1) * across_ + std::min(column, across_ - 1);
    cells_[disk.cell].push_back(i);
  }
  scale_energy(temperature * static_cast<double>(disks_.size()));
}

void Gas::scale_energy(double energy_wanted) {
  const double factor = std::sqrt(energy_wanted / energy());
  for (Disk& disk : disks_) {
    move(disk);
    disk.u *= factor;
    disk.w *= factor;
    ++disk.changes;
  }
  for (std::size_t i = 0; i < disks_.size(); ++i) foresee(i);
}

double Gas::energy() const {
  double sum = 0.0;
  for (const Disk& disk : disks_) sum += 0.5 * disk.mass * (disk.u * disk.u + disk.w * disk.w);
  return sum;
}

std::vector<Disk> Gas::disks() const {
  std::vector<Disk> all = disks_;
  for (Disk& disk : all) move(disk);
  return all;
}

void Gas::advance(double until, const Law& law) {
  while (queue_.time(queue_.first()) <= until) {
    const std::size_t i = queue_.first();
    const Event& event = events_[i];
    now_ = queue_.time(i);
    if (event.direction != 0) {
      leave_cell(i);
    } else if (disks_[event.partner].changes == event.changes) {
      collide(i, event.partner, law);
      continue;
    }
    foresee(i);  // in the new cell, or because the partner has met another
  }
  now_ = until;
}

void Gas::move(Disk& disk) const {
  disk.x += disk.u * (now_ - disk.time);
  disk.y += disk.w * (now_ - disk.time);
  disk.time = now_;
}

/// The same distance between the nearest images.
double Gas::nearest(double distance) const {
  if (distance > 0.5 * side_) return distance - side_;
  return distance < -0.5 * side_ ? distance + side_ : distance;
}

/// The next event of a disk: it leaves its cell, or meets a disk of this or a neighbouring cell.
void Gas::foresee(std::size_t i) {
  Disk& disk = disks_[i];
  move(disk);
  const std::size_t column = disk.cell % across_, line = disk.cell / across_;
  double soonest = std::numeric_limits<double>::infinity();
  Event event;
  const auto leaves = [&](double velocity, double place, std::size_t index, int forward) {
    if (velocity == 0.0) return;
    const double edge = static_cast<double>(velocity > 0.0 ? index + 1 : index) * width_;
    const double wait = std::max(0.0, (edge - place) / velocity);
    if (wait < soonest) {
      soonest = wait;
      event.direction = velocity > 0.0 ? forward : forward + 1;
    }
  };
  leaves(disk.u, disk.x, column, 1);
  leaves(disk.w, disk.y, line, 3);
  for (std::size_t k = 0; k < 9; ++k) {
    const std::size_t beside = (column + k % 3 + across_ - 1) % across_, above = (line + k / 3 + across_ - 1) % across_;
    for (const std::size_t j : cells_[above * across_ + beside]) {
      if (j == i) continue;
      const Disk& other = disks_[j];
      const double age = now_ - other.time;
      const double x = nearest(other.x + other.u * age - disk.x), y = nearest(other.y + other.w * age - disk.y);
      const double u = other.u - disk.u, w = other.w - disk.w;
      const double approach = -(x * u + y * w);
      if (approach <= 0.0) continue;
      // |r + vt| = R₁ + R₂; the root that is exact where the disks touch already.
      const double sum = disk.radius + other.radius, gap = x * x + y * y - sum * sum;
      const double discriminant = approach * approach - (u * u + w * w) * gap;
      if (discriminant < 0.0) continue;
      const double wait = std::max(0.0, gap / (approach + std::sqrt(discriminant)));
      if (wait < soonest) {
        soonest = wait;
        event = {j, other.changes, 0};
      }
    }
  }
  events_[i] = event;
  queue_.set(i, now_ + soonest);
}

void Gas::leave_cell(std::size_t i) {
  Disk& disk = disks_[i];
  move(disk);
  std::vector<std::size_t>& old = cells_[disk.cell];
  old.erase(std::find(old.begin(), old.end(), i));
  std::size_t column = disk.cell % across_, line = disk.cell / across_;
  // Exactly on the edge, at the other side of the box if it has left that.
  const auto cross = [this](std::size_t& index, double& place, bool forward) {
    index = (forward ? index + 1 : index + across_ - 1) % across_;
    place = static_cast<double>(forward ? index : index + 1) * width_;
  };
  const int direction = events_[i].direction;
  if (direction <= 2) {
    cross(column, disk.x, direction == 1);
  } else {
    cross(line, disk.y, direction == 3);
  }
  disk.cell = line * across_ + column;
  cells_[disk.cell].push_back(i);
}

void Gas::collide(std::size_t i, std::size_t j, const Law& law) {
  Disk &first = disks_[i], &second = disks_[j];
  move(first);
  move(second);
  double x = nearest(second.x - first.x), y = nearest(second.y - first.y);
  const double distance = std::hypot(x, y);
  x /= distance;
  y /= distance;
  const double speed = (first.u - second.u) * x + (first.w - second.w) * y;
  if (speed > 0.0) {
    const double reduced = first.mass * second.mass / (first.mass + second.mass);
    const double impulse = reduced * (1.0 + law(speed, second.radius / first.radius)) * speed;
    first.u -= impulse / first.mass * x;
    first.w -= impulse / first.mass * y;
    second.u += impulse / second.mass * x;
    second.w += impulse / second.mass * y;
    virial_ += impulse * distance;
  }
  ++first.changes;
  ++second.changes;
  ++collisions_;
  foresee(i);
  foresee(j);
}

}  // namespace gas
