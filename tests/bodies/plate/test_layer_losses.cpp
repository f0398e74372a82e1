// Layers that lose energy in different ways: shares of the energy of modes, free waves and slow loads against those of
// complex moduli, and plates whose layers differ in nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "bodies/plate/branches.hpp"
#include "bodies/plate/energy_shares.hpp"
#include "bodies/plate/given.hpp"
#include "bodies/plate/plate_waves.hpp"
#include "bodies/plate/stack.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace plate_losses {
namespace {

using namespace bodies::plate;
using Number = std::complex<double>;

/// PVB at 20 C (Van Duser et al. 1999), s.
const Relaxation pvb{{{0.1606, 3.2557e-11},
                      {0.0787, 4.9491e-9},
                      {0.2912, 7.2427e-8},
                      {0.0711155, 9.8635e-6},
                      {0.2688, 2.8059e-3},
                      {0.0895860, 0.16441}}};
const Layer pane{4e-3, 0.22, 7e10, 2500.0}, film{8e-4, 0.45, 1.36e9, 1070.0};

/// Two panes of glass with a film between them, m, Pa, kg/m³.
Plate laminate() {
  return {pane.thickness, pane.poisson, pane.young, pane.density, 0.0, {film, pane}, {{}, {0.0, pvb}, {}}};
}

/// As the library has it for contacts of a duration in s, in its own units: m, and c and ρ of glass.
struct Stack {
  Given given = given_of(laminate());
  LayerKinds kinds;
  Sheets sheets;

  explicit Stack(double duration)
      : kinds(kinds_of(given, duration * given.speed())), sheets{sheets_of(given, kinds, 1e9)} {}

  [[nodiscard]] Number modulus_of(std::size_t kind, Number s) const {
    return modulus(kinds.all[kind], s) / kinds.stiffness[kind];
  }

  /// Its stiffness by moduli at s.
  [[nodiscard]] SmallMatrix<Complex, 2> at(double k, Number s) const {
    const Number z = -s * s;
    return stack_of_factors<2, Complex>(sheets, k, Complex{z.real(), z.imag()}, [&](int kind) {
      const Number m = modulus_of(static_cast<std::size_t>(kind), s);
      return Complex{m.real(), m.imag()};
    });
  }
};

/// By the secant method.
template <typename Function>
Number root_of(const Function& function, Number from) {
  Number last = from * Number(1.0001, 0.0001), value = function(from), next = function(last);
  for (int n = 0; n < 60 && std::abs(last - from) > 1e-12 * std::abs(last); ++n) {
    const Number step = next * (last - from) / (next - value);
    from = last, value = next;
    last -= step, next = function(last);
  }
  return last;
}

/// s of the mode m at a wave number, by the moduli of all modes that are below a frequency.
Number by_shares(const Stack& stack, double k, const Branches<2>& its, std::size_t m) {
  const std::vector<double> share = energy_shares<2>(stack.sheets, k, its.omega[m], its.amplitude[m], 2);
  const double square = its.omega[m] * its.omega[m];
  return root_of(
      [&](Number s) {
        return s * s + square * (share[0] * stack.modulus_of(0, s) + share[1] * stack.modulus_of(1, s));
      },
      {-1e-3 * its.omega[m], its.omega[m]});
}

Number exact(const Stack& stack, double k, Number near) {
  return root_of(
      [&](Number s) {
        const Complex value = determinant(stack.at(k, s));
        return Number(value.a, value.b);
      },
      near);
}

/// Ross, Kerwin and Ungar's bending wave of two equal faces that shear a soft core between them.
Number of_sandwich(const Stack& stack, double k, Number near) {
  const double h = pane.thickness, face = 1.0 / (1.0 - pane.poisson * pane.poisson), apart = h + film.thickness;
  const double mass = 2.0 * h + film.thickness * film.density / pane.density;
  const double core = film.young / pane.young / (2.0 * (1.0 + film.poisson));
  return root_of(
      [&](Number s) {
        const Number shear = core * modulus(in_time(pvb, stack.given.speed()), s);
        const Number together = 1.0 / (1.0 + face * h * film.thickness * k * k / (2.0 * shear));
        return mass * s * s + face * h * (h * h / 6.0 + 0.5 * apart * apart * together) * std::pow(k, 4);
      },
      near);
}

constexpr double contact_time = 6e-5;

}  // namespace

TEST(EnergyShares, AreThoseOfTheFrequencyAndAddUp) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    Sheets sheets;
    const int layers = 2 + trial % 3;
    for (int i = 0; i < layers; ++i) {
      const double shear = std::pow(10.0, -1.5 * unit(random)), ratio = 2.2 + 4.0 * unit(random);
      sheets.all.push_back({0.2 + unit(random), shear, ratio * shear, 0.3 + unit(random), i});
    }
    const double k = std::pow(10.0, -1.0 + 1.5 * unit(random));
    const Branches<2> its = branches<2>(sheets, k, 3.0, {});
    for (std::size_t m = 0; m < its.omega.size(); ++m) {
      if (its.amplitude[m].norm() < 1e-3) continue;
      const auto share = energy_shares<2>(sheets, k, its.omega[m], its.amplitude[m], static_cast<std::size_t>(layers));
      double sum = 0.0;
      for (int i = 0; i < layers; ++i) {
        constexpr double small = 1e-4;
        std::vector<double> frequency;
        for (const double sign : {1.0, -1.0}) {
          Sheets other = sheets;
          other.all[static_cast<std::size_t>(i)].shear_modulus *= 1.0 + sign * small;
          other.all[static_cast<std::size_t>(i)].pressure_modulus *= 1.0 + sign * small;
          const Branches<2> changed = branches<2>(other, k, 3.1, {});
          frequency.push_back(changed.omega[m]);
        }
        const double slope = std::log(frequency[0] / frequency[1]) / small;  // of ω², by twice the step
        EXPECT_NEAR(share[static_cast<std::size_t>(i)], slope, 1e-5) << trial << " " << m << " " << i;
        sum += slope;
      }
      EXPECT_NEAR(sum, 1.0, 1e-6);
    }
  }
}

TEST(WavesOfALaminate, HaveTheFrequenciesAndDampingOfComplexModuli) {
  const Stack stack(2.0 * contact_time);
  for (const double k : {20.0, 50.0, 100.0, 200.0, 400.0}) {
    const Branches<2> its = branches<2>(stack.sheets, k, 400.0, {});
    const Number mode = by_shares(stack, k, its, 0), wave = exact(stack, k, mode);
    EXPECT_NEAR(mode.imag() / wave.imag(), 1.0, 4e-4) << k;
    EXPECT_NEAR(mode.real() / mode.imag(), wave.real() / wave.imag(), 7e-4) << k;
    if (k < 150.0) {  // long waves
      const Number sandwich = of_sandwich(stack, k, mode);
      EXPECT_NEAR(mode.imag() / sandwich.imag(), 1.0, 0.05) << k;
      EXPECT_NEAR(mode.real() / sandwich.real(), 1.0, 0.15) << k;
    }
  }
}

TEST(WavesOfALaminate, AnswerLoadsAsThoseOfComplexModuli) {
  const double duration = 2.0 * contact_time;
  const Stack stack(duration);
  const double own = duration * stack.given.speed(), cutoff = 2000.0;
  const Lamina plate =
      lamina(Contour::ball, stack.sheets.all, stack.kinds.stiffness, 4.0 * turning_frequency(stack.given, own));
  const Number s = Number(0.3, 1.0) * (0.5 * turning_frequency(stack.given, own));
  for (const bodies::PlaneWaves& waves : plane_waves(plate, cutoff, own, {})) {
    if (waves.wave_number < 20.0 || waves.wave_number > 1000.0) continue;
    Number sum = waves.residual_compliance.radial;
    for (std::size_t m = 0; m < waves.omega.size(); ++m) {
      const double* const moduli = waves.moduli.data() + 2 * m;
      const Number modulus = moduli[0] * stack.kinds.stiffness[0] * stack.modulus_of(0, s) +
                             moduli[1] * stack.kinds.stiffness[1] * stack.modulus_of(1, s);
      sum += waves.normal[m] * waves.normal[m] / (s * s + waves.omega[m] * waves.omega[m] * modulus);
    }
    const SmallMatrix<Complex, 2> answer = inverse(stack.at(waves.wave_number, s));
    const double weight = plate.weight(waves.wave_number) * waves.weight;
    const Number exact = weight * Number(answer(1, 1).a, answer(1, 1).b);
    EXPECT_LT(std::abs(sum / exact - 1.0), 3e-3) << waves.wave_number;
  }
}

TEST(LayersThatDifferInNothing, AreOnePlate) {
  const Relaxation same{{{0.3, 0.2}, {0.2, 3.0}}};
  Relaxation hardly = same;
  for (RelaxationTerm& term : hardly.terms) term.time *= 1.0 + 1e-13;
  const Plate whole{1.2, 0.3, 2.0, 0.7};
  Plate layers{0.4, 0.3, 2.0, 0.7};
  layers.below = {{0.4, 0.3, 2.0, 0.7}, {0.4, 0.3, 2.0, 0.7}};
  layers.losses = {{0.0, same}, {0.0, hardly}, {0.0, same}};
  Plate alike = layers;
  alike.losses[1] = alike.losses[0];
  const auto of = [](const BodyMaker& plate) {
    const Contact met = contact(sphere(Sphere{0.3}), plate, 12.0, 0.1);
    return impact(met, 0.1);
  };
  const double speed = std::sqrt(2.0 / 0.7);
  const Impact one = of(relaxing(plate(whole), in_time(same, speed)));
  for (const Plate& each : {layers, alike}) {
    const Impact other = of(plate(each));
    EXPECT_NEAR(other.lost_fraction, one.lost_fraction, 1e-10);
    EXPECT_NEAR(other.energy.dissipated, one.energy.dissipated, 1e-10);
    EXPECT_NEAR(other.max_force / one.max_force, 1.0, 1e-10);
  }
}

TEST(LayersThatDiffer, LoseMoreTheMoreOfThemAndTheNearerTheyDo) {
  const Relaxation relaxes{{{0.2, 1.0}, {0.2, 10.0}}};
  const auto lost = [&](const std::vector<MaterialLoss>& losses) {
    Plate its{1.0, 0.3};
    its.below = {{1.0, 0.3, 1.0, 1.0}};
    its.losses = losses;
    const Impact made = impact(contact(sphere(Sphere{0.3}), plate(its), 8.0, 0.1), 0.1);
    return std::vector{made.energy.dissipated, made.lost_fraction};
  };
  for (const MaterialLoss& loss : {MaterialLoss{0.0, relaxes}, MaterialLoss{0.3, {}}}) {
    const auto none = lost({}), below = lost({{}, loss}), above = lost({loss, {}}), both = lost({loss, loss});
    EXPECT_EQ(none[0], 0.0);
    EXPECT_GT(below[0], 0.01);
    EXPECT_GT(above[0], 1.5 * below[0]);
    EXPECT_GT(both[0], above[0]);
    EXPECT_GT(below[1], none[1]);
    EXPECT_GT(above[1], below[1]);
  }
}

TEST(LayersThatDiffer, HaveThatInTheErrorAndNotInTheTolerance) {
  const Relaxation rubber{{{0.3, 0.1}, {0.3, 1.0}, {0.3, 10.0}}};
  Plate its{0.8, 0.2};
  its.below = {{0.16, 0.4, 0.05, 0.5}, {0.8, 0.2, 1.0, 1.0}};
  its.losses = {{}, {0.0, rubber}, {}};
  const Restitution made = restitution({sphere(Sphere{0.3}), plate(its)}, 0.01, {.tolerance = 1e-3});
  EXPECT_TRUE(made.converged);
  const double heat = made.finest.energy.dissipated;
  EXPECT_GT(heat, 0.005);
  EXPECT_GE(made.lost_fraction.error, 0.04 * heat);
  EXPECT_LT(made.lost_fraction.error, 0.04 * heat + 1e-3 * made.lost_fraction.value);
}

TEST(LayersThatDiffer, AreRefusedLossesThatDoNotFit) {
  const auto refusal = [](Plate its, const std::vector<MaterialLoss>& losses) {
    its.losses = losses;
    return test::message_of<InvalidInput>([&] { (void)plate(its, 8.0, 10.0); });
  };
  EXPECT_EQ(refusal(laminate(), {{}, {}}), "losses: got 2, allowed 3, one for each layer (or none)");
  Plate lossy = laminate();
  lossy.loss_time = 1e-6;
  EXPECT_EQ(refusal(lossy, {{}, {}, {}}), "loss_time: the layers have their own (leave it out)");
  EXPECT_EQ(refusal(laminate(), {{}, {1.0, pvb}, {}}),
            "relaxation: the material has a loss_time too (give one of both)");
  EXPECT_EQ(refusal(laminate(), {{}, {-1.0, {}}, {}}).substr(0, 19), "loss_time: got -1, ");
  const BodyMaker made = plate(laminate());
  EXPECT_NE(test::message_of<InvalidInput>([&] { (void)relaxing(made(8.0, {}), pvb); }).find("losses of their own"),
            std::string::npos);
}

}  // namespace plate_losses
}  // namespace stoss
