// Before they touch and after they part, bodies that vibrate are followed only as long as they may touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/vibration/ensemble.hpp"

namespace stoss {
namespace {

/// The foremost point of the surface, from the plane or the other body; more than 0 if they overlap.
double foremost(const Contact& contact, const ContactGrid& grid, const State& state) {
  const std::size_t nodes = grid.recess.size();
  std::vector<double> place(nodes);
  for (std::size_t i = 0; i < nodes; ++i) place[i] = state.center + contact.extent - grid.recess[i];
  for (std::size_t g = 0, k = 0; g < contact.groups.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    const double scale = std::sqrt(modal_mass(contact, g) / contact.mass);
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      for (std::size_t i = 0; i < nodes; ++i) {
        place[i] += scale * state.coordinate[k] *
                    (group.upper[l] * grid.shape[group.upper_row * nodes + i] +
                     group.lower[l] * grid.shape[group.lower_row * nodes + i]);
      }
    }
  }
  return *std::max_element(place.begin(), place.end());
}

/// How far forward the surface comes in free motion from a state on, or back from it, until no phase of the modes
/// reaches the plane.
double foremost_ever(const Contact& contact, const State& state, double step) {
  const bool point = has_single_point(contact);
  const ContactGrid grid = contact_grid(contact, point ? 0.0 : 0.6, point ? 1 : 60);
  const double end = -clearance(contact, state) - contact.extent;
  double result = -std::numeric_limits<double>::infinity();
  for (double time = 0.0;; time += step) {
    const State now = free_motion(contact, state, time);
    result = std::max(result, foremost(contact, grid, now));
    if (now.center < end) return result;
  }
}

struct Case {
  RefinableContact contact;
  int level;
};

std::vector<Case> cases() {
  return {{RefinableContact(disk(0.33)), 4},
          {RefinableContact(sphere(0.3)), 4},
          {RefinableContact(disk(0.2), disk(0.4)), 4},
          {RefinableContact(sphere(0.3), sphere(0.3)), 3},
          {RefinableContact(rod()), 6}};
}

constexpr int states = 12;
constexpr double temperatures[] = {0.003, 0.05, 0.6};

TEST(Approach, HasNotTouchedBefore) {
  double distances = 0.0, clearances = 0.0;
  for (const auto& [refinable, level] : cases()) {
    const Contact& contact = refinable.at(level);
    for (const double temperature : temperatures) {
      const Spectrum warm = thermal(refinable, temperature, 0.9 * contact.cutoff);
      for (int sample = 0; sample < states; ++sample) {
        const State state = approach(contact, 0.1, draw(warm, 7, static_cast<std::uint64_t>(sample)));
        EXPECT_LT(foremost_ever(contact, state, -0.2 / contact.cutoff), 0.0) << name(contact) << ' ' << sample;
        distances += -(state.center + contact.extent);
        clearances += clearance(contact, state);
      }
    }
  }
  EXPECT_LT(distances, 0.6 * clearances);  // and begins well after the last time that no phase could touch
}

TEST(Impact, EndsWhenNothingTouchesAgain) {
  for (const auto& [refinable, level] : cases()) {
    const Contact& contact = refinable.at(level);
    for (const double temperature : temperatures) {
      const Spectrum warm = thermal(refinable, temperature, 0.9 * contact.cutoff);
      for (int sample = 0; sample < states; ++sample) {
        const Vibration vibration = draw(warm, 8, static_cast<std::uint64_t>(sample));
        const Impact impact = stoss::impact(contact, 0.1, {.start = approach(contact, 0.1, vibration)});
        EXPECT_LT(foremost_ever(contact, impact.final_state, 0.2 / contact.cutoff), 0.0)
            << name(contact) << ' ' << temperature << ' ' << sample;
      }
    }
  }
}

}  // namespace
}  // namespace stoss
