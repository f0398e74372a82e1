// Impacts of rods that vibrate, against exact answers by characteristics.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

// A rod that presses against a wall reverses its whole motion in 2L/c, Q(t + 2) = −Q(t): all its periods are 2/l. It
// presses as long as the waves that come to its end push, v + √2 v √e cos(…) > 0: for one mode, e < ½.
TEST(VibratingRods, ReverseTheirMotionAtAWall) {
  const RefinableContact wall{rod()};
  for (const Oscillation& mode : {Oscillation{0, 0, 0, 0.3, 0.5}, {0, 0, 0, 0.3, 3.0}, {0, 0, 1, 0.2, 5.0}}) {
    const Restitution result = restitution(wall, 0.1, {.tolerance = 1e-15, .absolute = 0.05, .vibration = {mode}});
    EXPECT_NEAR(result.restitution.value, 1.0, result.restitution.error);
    EXPECT_NEAR(result.contact_time.value, 2.0, result.contact_time.error);
    EXPECT_LE(result.lost_fraction.error, 0.05);
    EXPECT_EQ(result.finest.contacts, 1);
    const Contact contact = stoss::contact(rod(result.finest.cutoff));
    for (const Oscillation& after : vibration(contact, result.finest.final_state)) {
      if (after.index != mode.index) continue;
      EXPECT_NEAR(after.energy, mode.energy, 0.02);
    }
  }
}

// Rods of one impedance pass waves on as if they were one. All of a short one at rest or vibrating, and so its
// momentum, is in the longer one after 2L₁/c, which parts: ε = L₁/L₂ whatever its vibration.
TEST(VibratingRods, OfWhichTheShortOneVibratesPassOnAllMomentum) {
  const RefinableContact pair(rod(), rod(Rod{.length = 2.5}));
  for (const double phase : {0.0, 2.0, 4.0}) {
    const Restitution result =
        restitution(pair, 0.1, {.tolerance = 1e-15, .absolute = 0.01, .vibration = {{0, 0, 0, 0.2, phase}}});
    EXPECT_NEAR(result.restitution.value, 1.0 / 2.5, result.restitution.error);
    EXPECT_LE(result.restitution.error, 0.02);
  }
}

// Where the long one vibrates, with the velocity w(t) of its free end away from the short one, the short one has
// received the waves G = w/2 when they part at 2L₁/c after the touch at t₀: its velocity is their sum
// ∫ G dt = ½ ∫ w dt over [t₀, t₀ + 2]. Then they part if G(t) > G(t − 2), and with these phases do not meet again.
TEST(VibratingRods, OfWhichTheLongOneVibratesGiveItsWavesToTheShortOne) {
  constexpr double length = 2.5, speed = 0.1, energy = 0.02;
  const RefinableContact pair(rod(), rod(Rod{.length = length}));
  const double omega = std::numbers::pi / length, reduced = length / (1.0 + length);
  // ½ m₂ ω² A² = energy × ½μv²; its end moves by √2 Q towards the short one.
  const double reach = std::sqrt(2.0 * energy * reduced / length) * speed / omega;
  for (const double phase : {-2.5, -2.3}) {
    double touch = 0.0;  // v t + √2 A cos(ωt + φ) = 0
    for (int i = 0; i < 200; ++i) touch = -reach * std::cos(omega * touch + phase) / speed;
    // w = −d/dt √2 A cos(ωt + φ), integrated.
    const double received = 0.5 * reach * (std::cos(omega * touch + phase) - std::cos(omega * (touch + 2.0) + phase));
    const double exact = (speed - received) / length / speed - received / speed;
    const Restitution result =
        restitution(pair, speed, {.tolerance = 1e-15, .absolute = 0.005, .vibration = {{1, 0, 0, energy, phase}}});
    EXPECT_NEAR(result.restitution.value, exact, result.restitution.error);
    EXPECT_LE(result.restitution.error, 0.01);
    EXPECT_GT(std::abs(exact - 1.0 / length), 0.02);
  }
}

}  // namespace
}  // namespace stoss
