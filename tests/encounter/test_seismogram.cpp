// What a receiver records of an impact.
#include "stoss/encounter/seismogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stoss/encounter/waves.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

Encounter ball_on(const std::string& kind, Values values = {}) {
  Encounter met;
  met.first = of_kind("sphere");
  met.first.values = {{"poisson", 0.3}};
  met.against = of_kind(kind);
  met.against.values = std::move(values);
  return met;
}

Pulse pulse_of(const Encounter& met, double speed) { return pulse(refinable(met), speed); }

TEST(Seismogram, IsWhatTheWavesOfTheImpactDo) {
  // Those of the impact's own modes, whose pressure is not Hertz's: another method for both parts.
  for (const Encounter& met : {ball_on("half-space"), ball_on("plate", {{"thickness", 2.0}})}) {
    constexpr double speed = 0.03, last = 24.0;
    const Receiver receiver{3.0, 1.0};
    const Pulse its = pulse_of(met, speed);
    const Seismogram made = seismogram(met, its, receiver, {.until = last, .points = 481});
    const Contact contact = contact_of(met, its.cutoffs.back(), speed);
    const Waves waves = stoss::waves(met, impact(contact, speed), {},
                                     [&] {
                                       std::vector<double> times;
                                       for (std::size_t i = 40; i < 481; i += 40)
                                         times.push_back(made.instants[i].time);
                                       return times;
                                     }(),
                                     {{receiver.distance}, {receiver.depth}});
    const double most = made.max_normal.value, fastest = made.max_normal_velocity.value;
    for (std::size_t k = 0; k < waves.time.size(); ++k) {
      const RecordedInstant& here = made.instants[40 * (k + 1)];
      EXPECT_NEAR(here.normal.value, waves.normal[k], here.normal.error + 0.01 * most) << here.time;
      EXPECT_NEAR(here.radial.value, waves.lateral[k], here.radial.error + 0.01 * most) << here.time;
      EXPECT_NEAR(here.normal_velocity.value, waves.normal_velocity[k], here.normal_velocity.error + 0.04 * fastest)
          << here.time;
    }
  }
}

TEST(Seismogram, StaysWithinItsErrorsOfAFinerOne) {
  for (const Encounter& met : {ball_on("half-space"), ball_on("plate", {{"thickness", 3.0}})}) {
    const Receiver receiver{5.0, 0.0};
    const SeismogramOptions options{.until = 60.0, .points = 300};
    const Seismogram coarse = seismogram(met, pulse(refinable(met), 1e-3, {.tolerance = 2e-2}), receiver, options);
    const Seismogram fine =
        seismogram(met, pulse(refinable(met), 1e-3, {.tolerance = 1e-3, .points = 1600}), receiver, options);
    int beyond = 0;
    for (std::size_t i = 0; i < coarse.instants.size(); ++i) {
      const RecordedInstant &one = coarse.instants[i], &other = fine.instants[i];
      const auto apart = [](const Estimate& a, const Estimate& b, double most) {
        return std::abs(a.value - b.value) > a.error + b.error + 1e-6 * most;
      };
      if (apart(one.normal, other.normal, coarse.max_normal.value) ||
          apart(one.normal_velocity, other.normal_velocity, coarse.max_normal_velocity.value)) {
        ++beyond;
      }
    }
    EXPECT_LE(beyond, 15);
    EXPECT_LT(coarse.max_normal.error, 0.01 * coarse.max_normal.value);
  }
}

TEST(Seismogram, ArrivesWithTheWavesAndEndsInRest) {
  const Encounter met = ball_on("half-space");
  const Pulse its = pulse_of(met, 1e-3);
  const double pressure = wave_speeds(met).pressure, rayleigh = wave_speeds(met).rayleigh;
  for (const Receiver receiver : {Receiver{50.0, 0.0}, Receiver{0.0, 50.0}, Receiver{40.0, 30.0}}) {
    const Seismogram made = seismogram(met, its, receiver);
    EXPECT_NEAR(made.arrival, 50.0 / pressure, 1e-9);
    for (const RecordedInstant& here : made.instants) {
      if (here.time > made.arrival - 0.5) break;
      EXPECT_LT(std::abs(here.normal.value), 1e-9 * made.max_normal.value) << here.time;
    }
    EXPECT_LT(std::abs(made.instants.back().normal.value), 0.05 * made.max_normal.value);  // it creeps back
  }
  // The greatest displacement on the surface is that of the Rayleigh wave.
  const Seismogram made = seismogram(met, its, {50.0, 0.0});
  const auto most = std::max_element(made.instants.begin(), made.instants.end(), [](const auto& a, const auto& b) {
    return std::abs(a.normal.value) < std::abs(b.normal.value);
  });
  EXPECT_NEAR(most->time, 50.0 / rayleigh + its.rise.value, 0.5 * its.contact_time.value);
}

TEST(Seismogram, OfFarSurfacesFallsAsTheRootOfTheDistance) {
  const Encounter met = ball_on("half-space");
  const Pulse its = pulse_of(met, 1e-3);
  const auto most = [&](double distance) {
    return seismogram(met, its, {distance, 0.0}, {.points = 4000}).max_normal.value;
  };
  EXPECT_NEAR(most(4000.0) / most(1000.0), 0.5, 0.01);
}

TEST(Seismogram, OfARubyBallOnAThickPlateReachesItsOtherFace) {
  // McLaskey and Glaser drop such balls on plates of steel: R = 2.5 mm, 50 mm.
  Encounter met = ball_on("plate", {{"thickness", 20.0}, {"poisson", 0.29}, {"young", 0.5}, {"density", 2.0}});
  const Pulse its = pulse_of(met, 1e-4);
  const Seismogram made = seismogram(met, its, {0.0, 20.0});
  EXPECT_NEAR(made.arrival, 20.0 / wave_speeds(met).pressure, 1e-9);
  EXPECT_GT(made.max_normal.value, 0.0);
  EXPECT_LT(made.max_normal.error, 2e-3 * made.max_normal.value);
  EXPECT_LT(made.max_normal_velocity.error, 0.05 * made.max_normal_velocity.value);
  EXPECT_EQ(made.instants.size(), 500U);
  // A free face moves twice as far as the inside of a block before the shear wave is there.
  const Encounter block = ball_on("half-space", {{"poisson", 0.29}, {"young", 0.5}, {"density", 2.0}});
  const Seismogram inside = seismogram(block, its, {0.0, 20.0}, {.until = made.instants.back().time});
  const double early = 1.15 * made.arrival;
  const auto at = static_cast<std::size_t>(early / made.instants[1].time);
  EXPECT_NEAR(made.instants[at].normal.value, 2.0 * inside.instants[at].normal.value,
              0.03 * std::abs(made.instants[at].normal.value));
}

TEST(Seismogram, OfAPlateTooThickForAnEchoIsThatOfABlock) {
  const Encounter block = ball_on("half-space"), plate = ball_on("plate", {{"thickness", 200.0}});
  const Pulse its = pulse_of(block, 1e-3);
  const SeismogramOptions options{.until = 100.0, .points = 50};
  const Seismogram one = seismogram(block, its, {10.0, 3.0}, options),
                   other = seismogram(plate, its, {10.0, 3.0}, options);
  for (std::size_t i = 0; i < one.instants.size(); ++i) {
    EXPECT_EQ(one.instants[i].normal.value, other.instants[i].normal.value);
  }
}

TEST(Seismogram, CountsWhatAMaterialMayTakeAsAnError) {
  const Encounter elastic = ball_on("half-space"), lossy = ball_on("half-space", {{"loss_time", 0.01}});
  const Receiver receiver{10.0, 0.0};
  const Seismogram one = seismogram(elastic, pulse_of(elastic, 1e-3), receiver),
                   other = seismogram(lossy, pulse_of(lossy, 1e-3), receiver);
  EXPECT_NEAR(other.max_normal.value, one.max_normal.value, 0.01 * one.max_normal.value);
  EXPECT_GT(other.max_normal.error, 2.0 * one.max_normal.error);
  EXPECT_LT(other.max_normal.error, 0.1 * one.max_normal.value);
}

TEST(Seismogram, Refuses) {
  const Encounter met = ball_on("half-space"), plate = ball_on("plate", {{"thickness", 2.0}});
  const Pulse its = pulse_of(met, 1e-2);
  const auto refused = [&](const Encounter& where, const Receiver& receiver, const std::vector<std::string>& words,
                           const SeismogramOptions& options = {}) {
    test::expect_refusal([&] { (void)seismogram(where, its, receiver, options); }, words);
  };
  refused(met, {-1.0, 0.0}, {"distance: got -1", "0 to 1e6"});
  refused(met, {0.1, 0.0}, {"distance: got 0.1", "twice the radius of the contact"});
  refused(plate, {3.0, 2.5}, {"depth: got 2.5", "0 to 2 R"});
  refused(met, {3.0, 0.0}, {"points: got 1"}, {.points = 1});
  refused(met, {3.0, 0.0}, {"until: got 1e+09"}, {.until = 1e9});
  refused(ball_on("wall"), {3.0, 0.0}, {"against: got wall", "half-space or a plate"});
  refused(ball_on("half-space", {{"loss_time", 3.0}}), {3.0, 0.0},
          {"against: got a material with tan delta", "up to 0.1"});
  Encounter disk;
  disk.first = of_kind("disk");
  disk.first.values = {{"poisson", 0.3}};
  disk.against = of_kind("half-plane");
  refused(disk, {3.0, 0.0}, {"against: got half-plane"});
}

}  // namespace
}  // namespace stoss
