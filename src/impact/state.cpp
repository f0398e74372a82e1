#include "stoss/impact/state.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "contact/demands.hpp"
#include "impact/recommended.hpp"
#include "numeric/damped_oscillator.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require_modes(const Contact& contact, const State& state) {
  const std::size_t count = mode_count(contact);
  if (state.coordinate.size() != count || state.momentum.size() != count) {
    throw InvalidInput::out_of_range("state",
                                     std::to_string(state.coordinate.size()) + " coordinates and " +
                                         std::to_string(state.momentum.size()) + " momenta",
                                     std::to_string(count) + " of each", "one for every kept mode");
  }
}

/// Maximum displacement of any contact point by the modes, each at its best phase.
double reach(const Contact& contact, const State& state) {
  constexpr int points = 32;
  const double half_width = has_single_point(contact) ? 0.0 : initial_half_width(contact, std::abs(state.velocity));
  const ContactGrid grid = contact_grid(contact, half_width, has_single_point(contact) ? 1 : points);
  const std::size_t nodes = grid.recess.size();
  const auto greatest = [&](std::size_t row) {
    double result = 0.0;
    for (std::size_t i = 0; i < nodes; ++i) result = std::max(result, std::abs(grid.shape[row * nodes + i]));
    return result;
  };
  double sum = 0.0;
  for (std::size_t g = 0, k = 0; g < contact.groups.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    const double mass = modal_mass(contact, g), scale = std::sqrt(mass / contact.mass);
    const double upper = greatest(group.upper_row), lower = greatest(group.lower_row);
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const double amplitude = std::hypot(state.coordinate[k], state.momentum[k] / (mass * group.omega[l]));
      sum += scale * amplitude * (std::abs(group.upper[l]) * upper + std::abs(group.lower[l]) * lower);
    }
  }
  return sum;
}

}  // namespace

State free_motion(const Contact& contact, const State& state, double time) {
  State moved = state;
  moved.center += state.velocity * time;
  std::size_t k = 0;
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const double mass = modal_mass(contact, g);
    const bool lossy = loses(contact);
    for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l, ++k) {
      if (lossy && state.coordinate[k] == 0.0 && state.momentum[k] == 0.0) continue;  // however far back
      const FreeMode mode = free_mode(contact, g, l);
      const auto [kept, coupling, slowed] = numeric::damped_motion(mode.frequency, mode.gamma, time);
      const double inertia = mass * mode.frequency;
      moved.coordinate[k] = state.coordinate[k] * kept + state.momentum[k] * coupling / inertia;
      moved.momentum[k] = state.momentum[k] * slowed - state.coordinate[k] * coupling * inertia;
      if (!std::isfinite(moved.coordinate[k]) || !std::isfinite(moved.momentum[k])) {
        throw InvalidInput::out_of_range("time", std::to_string(time), "times at which the modes are finite",
                                         "a lossy body cannot be followed far back");
      }
    }
  }
  return moved;
}

std::vector<double> mode_energies(const Contact& contact, const State& state) {
  require_modes(contact, state);
  std::vector<double> energies;
  energies.reserve(state.momentum.size());
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const double mass = modal_mass(contact, g);
    for (const double omega : contact.groups[g].omega) {
      const std::size_t k = energies.size();
      const double momentum = state.momentum[k], restoring = mass * omega * state.coordinate[k];
      energies.push_back(0.5 * (momentum * momentum + restoring * restoring) / mass);
    }
  }
  return energies;
}

double clearance(const Contact& contact, const State& state) {
  require_modes(contact, state);
  constexpr double margin = 1.05;
  const double speed = std::abs(state.velocity);
  const double half_width = has_single_point(contact) ? 0.0 : initial_half_width(contact, speed);
  return force_free_distance(contact, margin * reach(contact, state), speed, half_width);
}

}  // namespace stoss
