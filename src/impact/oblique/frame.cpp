#include "impact/oblique/frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"
#include "contact/along.hpp"
#include "contact/unit_ratios.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// By how much bodies turn while they touch, with the mean of the spins before and after.
void note_turning(const ObliqueFrame& frame, ObliqueImpact& impact, const Impact& normal) {
  const auto angle = [time = normal.contact_time](double before, double after) {
    return 0.5 * (std::abs(before) + std::abs(after)) * time;
  };
  const auto [first, second] = frame.radius;
  const double of_centers =
      second > 0.0 ? angle(impact.before.tangential, impact.tangential_after) / (first + second) : 0.0;
  const std::array angles{std::max(of_centers, angle(impact.before.spin, impact.spin_after)),
                          std::max(of_centers, angle(impact.before.second_spin, impact.second_spin_after))};
  impact.turned = std::max(angles[0], angles[1]);
  impact.beyond_small_turn = std::max(first * angles[0], second * angles[1]) > normal.max_half_width;
}

}  // namespace

ObliqueFrame::ObliqueFrame(const Contact& contact, double speed_towards, const ImpactOptions& options)
    : speed(speed_towards),
      mass(contact.whole_mass),
      mass_along(stoss::mass_along(contact)),
      normal_energy(0.5 * mass * speed * speed),
      part_of_second(contact.second != nullptr && (is_unbounded(*contact.second) || contact.second->part.size < 1.0)) {
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr) break;
    const UnitRatios units = units_of(contact, number);
    const auto k = static_cast<std::size_t>(number);
    radius[k] = body->extent * units.length;
    const double part = body->part.size * body->part.size;
    inertia[k] = body->inertia / (part * part) * units.mass * units.length * units.length;
  }
  if (!options.start) return;
  const std::vector<double> energies = mode_energies(contact, *options.start);
  normal_energy = std::accumulate(energies.begin(), energies.end(), normal_energy);
}

std::array<std::vector<double>, 2> arms(const Contact& contact, const ContactPoints& points) {
  std::array<std::vector<double>, 2> arms;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    std::vector<double>& arm = arms[static_cast<std::size_t>(number)];
    arm.resize(points.count);
    if (body == nullptr || body->inertia == 0.0) continue;
    const UnitRatios units = units_of(contact, number);
    const std::vector<double> recess = body->surface(seen_by(points, units)).recess;
    for (std::size_t i = 0; i < arm.size(); ++i) arm[i] = (body->extent - recess[i]) * units.length;
  }
  return arms;
}

void ObliqueFrame::require(const Obliquity& obliquity) const {
  stoss::require("tangential", obliquity.tangential, ranges::along, "velocity along the surface in c");
  stoss::require("friction", obliquity.friction, ranges::friction, "coefficient of Coulomb's law");
  const std::array spins{std::pair{"spin", obliquity.spin}, std::pair{"second_spin", obliquity.second_spin}};
  for (std::size_t k = 0; k < spins.size(); ++k) {
    const auto& [name, spin] = spins[k];
    if (inertia[k] > 0.0) {
      stoss::require(name, spin * radius[k], ranges::along, "of the body, times its radius in that of the first, in c");
    } else if (spin != 0.0) {
      throw InvalidInput::out_of_range(std::string(name), "one that is not 0", "only 0",
                                       "there is no such body, or it does not turn");
    }
  }
}

double ObliqueFrame::initial_energy(const Obliquity& before) const {
  return normal_energy + 0.5 * mass_along * before.tangential * before.tangential +
         0.5 * inertia[0] * before.spin * before.spin + 0.5 * inertia[1] * before.second_spin * before.second_spin;
}

AlongOutcome ObliqueFrame::unchanged(const Obliquity& obliquity) {
  AlongOutcome same;
  same.tangential = obliquity.tangential;
  same.spin = {obliquity.spin, obliquity.second_spin};
  return same;
}

double ObliqueFrame::mobility_of_sliding() const {
  double mobility = 1.0 / mass_along;
  for (std::size_t k = 0; k < 2; ++k) {
    if (inertia[k] > 0.0) mobility += radius[k] * radius[k] / inertia[k];
  }
  return mobility;
}

AlongOutcome ObliqueFrame::settled(AlongOutcome now, double friction, double momentum) const {
  const double slides = sliding(now.tangential, now.spin[0], now.spin[1]), mobility = mobility_of_sliding();
  const double most = friction * momentum, impulse = std::clamp(slides / mobility, -most, most);
  now.tangential -= impulse / mass_along;
  now.impulse += impulse;
  for (std::size_t k = 0; k < 2; ++k) {
    if (inertia[k] == 0.0) continue;
    now.spin[k] -= impulse * radius[k] / inertia[k];
    now.moment[k] += impulse * radius[k];
  }
  now.friction += impulse * (slides - 0.5 * impulse * mobility);  // the impulse times the mean velocity of sliding
  return now;
}

ObliqueSnapshot ObliqueFrame::instant(double time, const Obliquity& before, double velocity, const AlongOutcome& along,
                                      double elastic) const {
  const double initial = initial_energy(before);
  ObliqueSnapshot now;
  now.time = time;
  now.velocity = velocity;
  now.tangential = along.tangential;
  now.spin = along.spin[0];
  now.second_spin = along.spin[1];
  now.energy.translation = 0.5 * mass * velocity * velocity / initial;
  now.energy.across = 0.5 * mass_along * along.tangential * along.tangential / initial;
  now.energy.rotation = 0.5 * inertia[0] * along.spin[0] * along.spin[0] / initial;
  now.energy.second_rotation = 0.5 * inertia[1] * along.spin[1] * along.spin[1] / initial;
  now.energy.elastic = (elastic + along.elastic()) / initial;
  now.energy.friction = along.friction / initial;
  return now;
}

ObliqueImpact ObliqueFrame::joined(Impact normal, const Obliquity& before, AlongOutcome after, double momentum) const {
  ObliqueImpact result;
  if (normal.remaining > 0.0) {
    const double slides = sliding(after.tangential, after.spin[0], after.spin[1]), mobility = mobility_of_sliding();
    after = settled(after, before.friction, momentum);
    // Of Zener's law beside a contact of Mindlin's stiffness: what sticks in the end swings by so much as it parts.
    constexpr double swing = 1.5;
    result.unsettled_sliding = swing * before.friction * std::sqrt(normal.remaining) * speed * mass * mobility;
    const double after_rest = sliding(after.tangential, after.spin[0], after.spin[1]);
    // What sticks may swing with what it slid with, or with what friction lets it, and has it from the heat.
    const bool sticks = std::abs(after_rest) < result.unsettled_sliding;
    const double swings = std::min(std::abs(slides), before.friction * momentum / mass);
    if (sticks) result.unsettled_heat = 0.5 * swings * swings / mobility / initial_energy(before);
  }
  result.before = before;
  result.restitution = normal.restitution;
  result.sliding = sliding(before.tangential, before.spin, before.second_spin);
  result.sliding_after = sliding(after.tangential, after.spin[0], after.spin[1]);
  result.tangential_restitution =
      result.sliding != 0.0 ? -result.sliding_after / result.sliding : std::numeric_limits<double>::quiet_NaN();
  result.tangential_after = after.tangential;
  result.spin_after = after.spin[0];
  result.second_spin_after = after.spin[1];
  result.impulse = after.impulse / mass_along;

  const std::array spin{before.spin, before.second_spin};
  const auto rotation = [&](std::size_t k, double at) { return 0.5 * inertia[k] * at * at; };
  const double initial = initial_energy(before);
  const double scale = speed + std::abs(result.sliding);
  result.momentum_error =
      std::abs(after.impulse + mass_along * (after.tangential - before.tangential)) / (mass_along * scale);
  for (std::size_t k = 0; k < spin.size() && inertia[k] > 0.0; ++k) {
    const double left = std::abs(after.moment[k] + inertia[k] * (after.spin[k] - spin[k]));
    result.angular_momentum_error = std::max(result.angular_momentum_error, left * radius[k] / (inertia[k] * scale));
  }

  const EnergyLedger& own = normal.energy;
  const double share = normal_energy / initial;
  std::array<double, 2> of_modes{};
  for (const ModeEnergy& mode : own.modes) of_modes[static_cast<std::size_t>(mode.body)] += mode.after;
  // What is not in modes is the rest of a body of which a part is there.
  const double second = part_of_second ? own.vibration - of_modes[0] : of_modes[1];
  ObliqueLedger& ledger = result.energy;
  ledger.translation = share * own.translation;
  ledger.across = 0.5 * mass_along * after.tangential * after.tangential / initial;
  ledger.rotation = rotation(0, after.spin[0]) / initial;
  ledger.second_rotation = rotation(1, after.spin[1]) / initial;
  ledger.vibration = share * (own.vibration - second) + after.vibration[0] / initial;
  ledger.second_vibration = share * second + after.vibration[1] / initial;
  ledger.dissipated = share * own.dissipated + after.dissipated / initial;
  ledger.yielded = share * own.yielded;
  ledger.friction = after.friction / initial;
  ledger.unresolved = share * own.unresolved + after.unresolved / initial;
  ledger.stored = share * own.stored + after.stored / initial;
  note_turning(*this, result, normal);
  result.energy_error = 1.0 - ledger.translation - ledger.across - ledger.rotation - ledger.second_rotation -
                        ledger.vibration - ledger.second_vibration - ledger.dissipated - ledger.yielded -
                        ledger.friction - ledger.unresolved - ledger.stored;
  result.normal = std::move(normal);
  return result;
}

}  // namespace stoss
