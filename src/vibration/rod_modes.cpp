// Collisions of vibrating rods by `impact`. In units of the left rod, with the speed scaled to v̂: lengths times λ/L,
// momenta times λ/(mc), λ = v̂c/v.
#include "vibration/rod_vibrations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "impact/free_flight.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double scaled_speed = 1e-3;

/// A body with its modes in four groups: of a pair they fill the eight lanes in which groups move side by side.
Body in_four_groups(Body body) {
  constexpr std::size_t parts = 4;
  const ModeGroup all = std::move(body.groups.front());
  body.groups.clear();
  for (std::size_t part = 0; part < parts; ++part) {
    ModeGroup group;
    group.order = all.order;
    for (std::size_t l = part; l < all.omega.size(); l += parts) {
      group.omega.push_back(all.omega[l]);
      group.upper.push_back(all.upper[l]);
      group.lower.push_back(all.lower[l]);
      group.index.push_back(static_cast<int>(l));
    }
    body.groups.push_back(std::move(group));
  }
  return body;
}

}  // namespace

RodModes::RodModes(const std::vector<Rod>& rods, const RodChainOptions& options)
    : resolution_(options.resolution), poll_(options.poll) {
  double shortest = RodMeasures(rods.front()).transit;
  for (const Rod& rod : rods) shortest = std::min(shortest, RodMeasures(rod).transit);
  const double highest = (options.modes + 0.5) * std::numbers::pi / shortest;
  for (const Rod& rod : rods) {
    Vibration vibration{RodMeasures(rod), nullptr};
    vibration.body =
        std::make_shared<const Body>(in_four_groups(stoss::rod(rod, highest * vibration.measures.transit)));
    for (const ModeGroup& group : vibration.body->groups) {
      for (std::size_t k = 0; k < group.omega.size(); ++k) {
        vibration.number.push_back(group.index[k] + 1);
        vibration.omega.push_back(group.omega[k] / vibration.measures.transit);
      }
    }
    vibration.coordinate.resize(vibration.omega.size());
    vibration.momentum.resize(vibration.omega.size());
    rods_.push_back(std::move(vibration));
  }
  for (std::size_t k = 0; k < rods_.size(); ++k) {
    contacts_.push_back(contact(rods_[k].body, rods_[(k + 1) % rods_.size()].body));
  }
}

void RodModes::set(std::size_t rod, int l, double coordinate, double momentum) {
  Vibration& vibration = rods_[rod];
  const auto at = std::find(vibration.number.begin(), vibration.number.end(), l) - vibration.number.begin();
  vibration.coordinate[static_cast<std::size_t>(at)] = coordinate;
  vibration.momentum[static_cast<std::size_t>(at)] = momentum;
}

void RodModes::age(std::size_t rod, double time, double kept) {
  Vibration& vibration = rods_[rod];
  const double amplitude = std::sqrt(kept), mass = vibration.measures.mass;
  // All modes are back after twice the transit time.
  const double rest = std::remainder(time, 2.0 * vibration.measures.transit);
  for (std::size_t k = 0; k < vibration.omega.size(); ++k) {
    const double omega = vibration.omega[k], inertia = mass * omega;
    const double cosine = amplitude * std::cos(omega * rest), sine = amplitude * std::sin(omega * rest);
    const double coordinate = vibration.coordinate[k], momentum = vibration.momentum[k];
    vibration.coordinate[k] = coordinate * cosine + momentum * sine / inertia;
    vibration.momentum[k] = momentum * cosine - coordinate * sine * inertia;
  }
}

double RodModes::energy(std::size_t rod) const {
  const Vibration& vibration = rods_[rod];
  const double mass = vibration.measures.mass;
  double sum = 0.0;
  for (std::size_t k = 0; k < vibration.omega.size(); ++k) {
    const double momentum = vibration.momentum[k], restoring = mass * vibration.omega[k] * vibration.coordinate[k];
    sum += 0.5 * (momentum * momentum + restoring * restoring) / mass;
  }
  return sum;
}

Impact RodModes::collision(const Contact& pair, const State* touching) const {
  // Where strong vibrations let slow rods touch many times, the usual steps may lose too much energy.
  constexpr int attempts = 4;
  constexpr double finer = 0.25;
  ImpactOptions options;
  options.resolution = resolution_;
  options.poll = poll_;
  if (touching != nullptr) options.start = free_motion(pair, *touching, -time_before_touch(pair, *touching));
  double step = fixed_resolution(pair, scaled_speed, resolution_).step;
  for (int attempt = 1;; ++attempt) {
    options.resolution.step = step;
    try {
      return stoss::impact(pair, scaled_speed, options);
    } catch (const NotConverged&) {
      if (attempt == attempts) throw;
    }
    step *= finer;
  }
}

RodMeeting RodModes::meet(std::size_t left, std::size_t right, double speed) {
  const Contact& pair = contacts_[left];
  const RodMeasures& unit = rods_[left].measures;
  const double scale = scaled_speed * unit.speed / speed;
  const double length = scale / unit.length, momentum = scale / (unit.mass * unit.speed);
  const auto towards = [](bool of_left, int l) { return of_left && l % 2 == 0 ? 1.0 : -1.0; };

  State state{-pair.extent, scaled_speed, {}, {}};
  bool vibrate = false;
  for (const bool of_left : {true, false}) {
    const Vibration& rod = rods_[of_left ? left : right];
    for (std::size_t k = 0; k < rod.omega.size(); ++k) {
      const double sign = towards(of_left, rod.number[k]);
      state.coordinate.push_back(sign * length * rod.coordinate[k]);
      state.momentum.push_back(sign * momentum * rod.momentum[k]);
      vibrate = vibrate || state.coordinate.back() != 0.0 || state.momentum.back() != 0.0;
    }
  }
  const Impact impact = collision(pair, vibrate ? &state : nullptr);
  const State& after = impact.final_state;
  state = free_motion(pair, after, -(after.center + pair.extent) / after.velocity);

  // Kicks miss the instants at which contacts begin and end, and so some 1e-5 of the energy: what holds more of it,
  // translation or vibration, makes up for it.
  const double mass = unit.mass * rods_[right].measures.mass / (unit.mass + rods_[right].measures.mass);
  const double initial = 0.5 * mass * speed * speed + energy(left) + energy(right);
  const double translation = impact.energy.translation, vibration = impact.energy.vibration;
  const double missing = impact.energy_error + impact.energy.stored;
  double restitution = impact.restitution, amplitude = 1.0;
  if (translation > vibration) {
    restitution *= std::sqrt(1.0 + missing / translation);
  } else {
    amplitude = std::sqrt(1.0 + missing / vibration);
  }
  std::size_t at = 0;
  for (const bool of_left : {true, false}) {
    Vibration& rod = rods_[of_left ? left : right];
    for (std::size_t k = 0; k < rod.omega.size(); ++k, ++at) {
      const double sign = amplitude * towards(of_left, rod.number[k]);
      rod.coordinate[k] = sign * state.coordinate[at] / length;
      rod.momentum[k] = sign * state.momentum[at] / momentum;
    }
  }
  return {restitution, impact.energy.unresolved * initial};
}

void RodModes::reverse(std::size_t rod) {
  for (double& each : rods_[rod].momentum) each = -each;
}

}  // namespace stoss
