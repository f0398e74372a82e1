// How ε depends on the phase of a vibration before the impact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"

namespace stoss {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// ε = Σ c_n cos nφ + s_n sin nφ of one mode, from equal steps of the phase.
struct Harmonics {
  double mean = 0.0, first = 0.0, rest = 0.0;  // amplitude of n = 1; root mean square of all beyond
};

Harmonics harmonics(const Contact& contact, double speed, const Oscillation& mode, const Resolution& resolution) {
  constexpr int phases = 12;
  std::array<double, phases> values{};
  Harmonics result;
  double cosine = 0.0, sine = 0.0;
  for (int i = 0; i < phases; ++i) {
    Oscillation turned = mode;
    turned.phase = turn * i / phases;
    const double value =
        impact(contact, speed, {.resolution = resolution, .start = approach(contact, speed, {turned})}).restitution;
    values[static_cast<std::size_t>(i)] = value;
    result.mean += value / phases;
    cosine += 2.0 * value * std::cos(turned.phase) / phases;
    sine += 2.0 * value * std::sin(turned.phase) / phases;
  }
  result.first = std::hypot(cosine, sine);
  for (int i = 0; i < phases; ++i) {
    const double phase = turn * i / phases;
    const double fit = result.mean + cosine * std::cos(phase) + sine * std::sin(phase);
    result.rest += std::pow(values[static_cast<std::size_t>(i)] - fit, 2) / phases;
  }
  result.rest = std::sqrt(result.rest);
  return result;
}

TEST(VibratingBodies, AreSinusoidalInThePhaseOfASmallVibration) {
  for (const Contact& contact : {contact(disk(0.33, 8.0)), contact(sphere(0.3, 8.0))}) {
    const double speed = 0.1,
                 at_rest = impact(contact, speed, {.resolution = {.step = 0.02 / contact.cutoff}}).restitution;
    std::vector<Harmonics> found;
    const std::array energies{0.000625, 0.0025, 0.01};
    for (const double energy : energies) {
      found.push_back(harmonics(contact, speed, {0, 2, 0, energy, 0.0}, {.step = 0.02 / contact.cutoff}));
    }
    for (std::size_t i = 1; i < found.size(); ++i) {
      // Twice the amplitude of vibration: twice that of ε, four times what is not sinusoidal and what shifts the mean.
      EXPECT_NEAR(std::log2(found[i].first / found[i - 1].first), 1.0, 0.03);
      EXPECT_NEAR(std::log2(found[i].rest / found[i - 1].rest), 2.0, 0.05);
      EXPECT_NEAR(std::log2((found[i].mean - at_rest) / (found[i - 1].mean - at_rest)), 2.0, 0.05);
    }
    EXPECT_GT(found[0].first, 1e-3);
    EXPECT_LT(found[0].rest, 0.05 * found[0].first);
  }
}

}  // namespace
}  // namespace stoss
