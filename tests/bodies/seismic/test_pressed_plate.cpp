// What a plate does at a receiver, against the half-space and against bending.
#include "bodies/plate/pressed_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/half_space/pressed_block.hpp"
#include "bodies/plate/given.hpp"

namespace stoss::bodies::plate {
namespace {

constexpr double nu = 0.3, pi = std::numbers::pi;

Lamina plate_of(double thickness) {
  const Given given = given_of(Plate{thickness, nu});
  return lamina(Contour::ball, sheets_of(given, kinds_of(given, 1e6), 1e6));
}

Instants until(double last, double duration, std::size_t outputs = 120) {
  const double interval = last / static_cast<double>(outputs - 1);
  const auto stride = static_cast<std::size_t>(std::ceil(interval * 400.0 / duration));
  return {interval / static_cast<double>(stride), 2, stride, outputs};
}

/// sin^{3/2}, as of Hertz.
PressedLoad pulse(const Instants& instants, double duration, double radius) {
  PressedLoad load;
  const auto count = static_cast<std::size_t>(duration / instants.step) + 6;
  for (std::size_t j = 0; j < count; ++j) {
    const double phase = pi * (static_cast<double>(j) - 2.0) * instants.step / duration;
    const double force = phase > 0.0 && phase < pi ? std::pow(std::sin(phase), 1.5) : 0.0;
    load.force.push_back(force);
    load.radius.push_back(radius * std::cbrt(force));
  }
  return load;
}

double greatest(const std::vector<double>& of) {
  double most = 0.0;
  for (const double each : of) most = std::max(most, std::abs(each));
  return most;
}

double apart(const std::vector<double>& one, const std::vector<double>& other) {
  double most = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) most = std::max(most, std::abs(one[i] - other[i]));
  return most;
}

double mean_apart(const std::vector<double>& one, const std::vector<double>& other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) sum += std::abs(one[i] - other[i]);
  return sum / static_cast<double>(one.size());
}

TEST(PressedPlate, IsAHalfSpaceUntilItsFirstEcho) {
  constexpr double thickness = 20.0, duration = 10.0, last = 28.0;
  const Instants instants = until(last, duration);
  for (const double radius : {0.0, 0.5}) {
    const PressedLoad load = pulse(instants, duration, radius);
    for (const auto& [distance, depth] : {std::pair{4.0, 0.0}, {4.0, 0.5}, {0.0, 3.0}, {6.0, 4.0}}) {
      const half_space::PressedBlock block(nu, distance, depth, radius, instants, {});
      const Motion on_block = block.of(load);
      const PressedPlate made =
          pressed_plate(plate_of(thickness), nu, distance, depth, instants, {load}, 120.0 / duration, {});
      const Motion& on_plate = made.motions.front();
      const double most = greatest(on_block.normal), fastest = greatest(on_block.normal_velocity);
      // On the surface the Rayleigh wave is sharper than the cutoff; five forces on the half-space stand for a
      // pressure.
      const double allowed = radius > 0.0 || depth == 0.0 ? 0.015 : 2e-3;
      EXPECT_LT(apart(on_block.normal, on_plate.normal), allowed * most) << distance << " " << depth << " " << radius;
      EXPECT_LT(apart(on_block.radial, on_plate.radial), allowed * most) << distance << " " << depth << " " << radius;
      EXPECT_LT(mean_apart(on_block.normal_velocity, on_plate.normal_velocity), 0.02 * fastest)
          << distance << " " << depth << " " << radius;
    }
  }
}

TEST(PressedPlate, ConvergesWithTheCutoffWithinWhatItLeavesOut) {
  constexpr double duration = 10.0;
  const Instants instants = until(80.0, duration);
  const PressedLoad load = pulse(instants, duration, 0.3);
  const auto at = [&](double cutoff) {
    return pressed_plate(plate_of(4.0), nu, 5.0, 4.0, instants, {load}, cutoff / duration, {});
  };
  const Motion exact = at(400.0).motions.front();
  double before = 1.0;
  for (const double cutoff : {30.0, 60.0, 120.0}) {
    const PressedPlate made = at(cutoff);
    const double error = apart(made.motions.front().normal, exact.normal);
    EXPECT_LT(error, 3.0 * greatest(made.unresolved.normal)) << cutoff;
    EXPECT_LT(error, 0.5 * before) << cutoff;
    EXPECT_LT(apart(made.motions.front().normal_velocity, exact.normal_velocity),
              3.0 * greatest(made.unresolved.normal_velocity))
        << cutoff;
    before = error;
  }
}

TEST(PressedPlate, GivesWayAsBoussinesqHasIt) {
  // A thin plate straight below an impulse I moves by I/(8√(Dρh)), until its rim is heard.
  constexpr double thickness = 0.1, duration = 10.0;
  const Instants instants = until(200.0, duration);
  const PressedLoad load = pulse(instants, duration, 0.0);
  double impulse = 0.0;
  for (const double force : load.force) impulse += force * instants.step;
  const double bending = std::pow(thickness, 3) / (12.0 * (1.0 - nu * nu));
  const double expected = impulse / (8.0 * std::sqrt(bending * thickness));
  for (const double depth : {0.05, 0.1}) {
    const PressedPlate made =
        pressed_plate(plate_of(thickness), nu, 0.0, depth, instants, {load}, 100.0 / duration, {});
    EXPECT_NEAR(made.motions.front().normal.back(), expected, 2e-3 * expected);
    EXPECT_NEAR(made.motions.front().normal_velocity.back(), 0.0, 1e-4 * expected);
  }
}

TEST(PressedPlate, MovesBothFacesTogetherInBending) {
  constexpr double duration = 60.0;
  const Instants instants = until(400.0, duration);
  const PressedLoad load = pulse(instants, duration, 0.0);
  const auto at = [&](double depth) {
    return pressed_plate(plate_of(1.0), nu, 20.0, depth, instants, {load}, 100.0 / duration, {}).motions.front();
  };
  const Motion upper = at(0.0), middle = at(0.5), lower = at(1.0);
  const double most = greatest(upper.normal);
  EXPECT_LT(apart(upper.normal, lower.normal), 0.02 * most);
  EXPECT_LT(apart(middle.normal, lower.normal), 0.02 * most);
  // Late, when only bending is left: both faces run against each other.
  EXPECT_NEAR(upper.radial.back(), -lower.radial.back(), 0.05 * std::abs(upper.radial.back()));
  EXPECT_LT(std::abs(middle.radial.back()), 0.1 * std::abs(upper.radial.back()));
}

TEST(PressedPlate, DoesNotSeeWhereItIsCutIntoLayers) {
  constexpr double duration = 10.0;
  const Instants instants = until(60.0, duration);
  const std::vector<PressedLoad> load{pulse(instants, duration, 0.3)};
  const Given cut = given_of(Plate{.thickness = 0.7, .poisson = nu, .below = {{1.3, nu}}});
  const Lamina layers = lamina(Contour::ball, sheets_of(cut, kinds_of(cut, 1e6), 1e6));
  for (const auto& [distance, depth] : {std::pair{3.0, 0.0}, {3.0, 1.0}, {5.0, 2.0}}) {
    const auto of = [&, r = distance, z = depth](const Lamina& plate) {
      return pressed_plate(plate, nu, r, z, instants, load, 60.0 / duration, {}).motions.front();
    };
    const Motion one = of(plate_of(2.0)), two = of(layers);
    EXPECT_LT(apart(one.normal, two.normal), 1e-6 * greatest(one.normal)) << distance << " " << depth;
    EXPECT_LT(apart(one.radial, two.radial), 1e-6 * greatest(one.normal)) << distance << " " << depth;
  }
}

/// A smooth pulse, sin⁴, of a given number of steps.
Motion on_block(double steps, double distance, double depth) {
  constexpr double duration = 10.0;
  const auto stride = static_cast<std::size_t>(steps / 20.0);
  const Instants instants{duration / steps, 2, stride, 80};
  PressedLoad load;
  for (std::size_t j = 0; j < static_cast<std::size_t>(steps) + 5; ++j) {
    const double phase = pi * (static_cast<double>(j) - 2.0) / steps;
    load.force.push_back(phase > 0.0 && phase < pi ? std::pow(std::sin(phase), 4) : 0.0);
    load.radius.push_back(0.0);
  }
  return half_space::PressedBlock(nu, distance, depth, 0.0, instants, {}).of(load);
}

TEST(PressedBlock, ConvergesWithTheStep) {
  for (const auto& [distance, depth] : {std::pair{6.0, 0.0}, {5.0, 2.0}, {0.0, 6.0}}) {
    const Motion exact = on_block(2560.0, distance, depth);
    const Motion coarse = on_block(40.0, distance, depth), fine = on_block(320.0, distance, depth);
    const double most = greatest(exact.normal), fastest = greatest(exact.normal_velocity);
    const double order =
        std::log2(mean_apart(coarse.normal, exact.normal) / mean_apart(fine.normal, exact.normal)) / 3.0;
    const double of_velocity = std::log2(mean_apart(coarse.normal_velocity, exact.normal_velocity) /
                                         mean_apart(fine.normal_velocity, exact.normal_velocity)) /
                               3.0;
    EXPECT_GT(order, 2.5) << distance << " " << depth;
    EXPECT_GT(of_velocity, 1.5) << distance << " " << depth;
    EXPECT_LT(apart(fine.normal, exact.normal), 1e-6 * most) << distance << " " << depth;
    EXPECT_LT(apart(fine.normal_velocity, exact.normal_velocity), 2e-3 * fastest) << distance << " " << depth;
  }
}

TEST(PressedPlate, SeesSeveralLoadsAsEachByItself) {
  constexpr double duration = 10.0;
  const Instants instants = until(40.0, duration);
  const PressedLoad wide = pulse(instants, duration, 0.4), narrow = pulse(instants, duration, 0.0);
  const auto of = [&](const std::vector<PressedLoad>& loads) {
    return pressed_plate(plate_of(2.0), nu, 3.0, 0.0, instants, loads, 60.0 / duration, {}).motions;
  };
  const auto both = of({wide, narrow});
  EXPECT_LT(apart(both[0].normal, of({wide})[0].normal), 1e-14);
  EXPECT_LT(apart(both[1].normal, of({narrow})[0].normal), 1e-3 * greatest(both[1].normal));
}

}  // namespace
}  // namespace stoss::bodies::plate
