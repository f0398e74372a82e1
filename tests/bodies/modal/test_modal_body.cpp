// Bodies by their modes at a point: a sphere that is given in this way is the sphere.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/modal_sphere.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace modal_bodies {
namespace {

/// Whether it has converged or not.
Restitution value_of(const RefinableContact& contact, double speed) { return best_restitution(contact, speed, {}); }

struct Meeting {
  const char* what;
  double slowest, fastest;
  std::function<RefinableContact(const BodyMaker&)> with;
};

const std::vector<Meeting>& meetings() {
  static const std::vector<Meeting> all{
      {"a wall", 1e-6, 1e-2, [](const BodyMaker& body) { return RefinableContact(body); }},
      {"a half-space", 1e-4, 1e-2,
       [](const BodyMaker& body) {
         return RefinableContact(body, half_space(HalfSpace{0.2, 0.5, 0.8}));
       }},
      {"a plate", 1e-4, 1e-2,
       [](const BodyMaker& body) {
         return RefinableContact(body, plate(Plate{1.0, 0.3}));
       }},
      {"a smaller sphere", 1e-4, 1e-2,
       [](const BodyMaker& body) {
         return RefinableContact(sphere(Sphere{0.2, 0.5}), body);
       }},
      {"a larger sphere", 1e-4, 1e-2,
       [](const BodyMaker& body) {
         return RefinableContact(body, sphere(Sphere{0.2, 2.0}));
       }},
      {"its like", 1e-4, 1e-2, [](const BodyMaker& body) { return RefinableContact(body, body); }},
  };
  return all;
}

void expect_near(const Estimate& found, const Estimate& expected) {
  EXPECT_NEAR(found.value, expected.value, found.error + expected.error);
}

void expect_is_the_sphere(const std::vector<double>& ratios) {
  for (const Meeting& meeting : meetings()) {
    for (const double poisson : ratios) {
      const RefinableContact whole = meeting.with(sphere(poisson));
      for (double speed = meeting.slowest; speed < 1.01 * meeting.fastest; speed *= 10.0) {
        const Restitution exact = value_of(whole, speed);
        for (const double complete_to : {6.0, 16.0}) {
          for (const bool bends : {true, false}) {
            SCOPED_TRACE(std::string(meeting.what) + ", nu " + std::to_string(poisson) + ", v " +
                         std::to_string(speed) + ", up to " + std::to_string(complete_to) + (bends ? "" : ", pistons"));
            const BodyMaker body = modal_body(test::modal_sphere(poisson, complete_to, bends));
            Restitution found;
            try {
              found = value_of(meeting.with(body), speed);
            } catch (const NotConverged&) {
              continue;
            }
            expect_near(found.lost_fraction, exact.lost_fraction);
            expect_near(found.restitution, exact.restitution);
            expect_near(found.contact_time, exact.contact_time);
            expect_near(found.max_force, exact.max_force);
          }
        }
      }
    }
  }
}

TEST(ModalBody, OfASphereIsTheSphereWithinBothErrors) { expect_is_the_sphere({0.3}); }

TEST(ModalBody, OfAnySphereIsTheSphereWithinBothErrors_long) { expect_is_the_sphere({0.0, 0.3, 0.45}); }

TEST(ModalBody, OfALossySphereLosesAsTheSphere) {
  for (const double loss_time : {0.01, 0.1, 2.0}) {
    for (const double speed : {1e-4, 1e-3}) {
      SCOPED_TRACE(std::to_string(loss_time) + " at " + std::to_string(speed));
      ModalBody body = test::modal_sphere(0.3, 12.0);
      body.loss_time = loss_time;
      const RefinableContact exact(sphere(Sphere{.poisson = 0.3, .loss_time = loss_time}));
      const RefinableContact given(modal_body(body));
      expect_near(value_of(given, speed).lost_fraction, value_of(exact, speed).lost_fraction);
    }
  }
}

// What is stated is worth something: where modes reach to 16 c/R, below 1 % at v = 1e-4 and 10 % at 1e-2.
TEST(ModalBody, StatesErrorsThatAreNotTooLarge) {
  for (const auto& [speed, share] : {std::pair{1e-4, 0.02}, {1e-3, 0.05}, {1e-2, 0.25}}) {
    const RefinableContact contact(modal_body(test::modal_sphere(0.3, 16.0)));
    const Estimate lost = value_of(contact, speed).lost_fraction;
    EXPECT_LT(lost.error, share * lost.value) << speed;
  }
}

/// At v = 1e-3 with a change of the body.
template <typename Change>
Restitution with(const Change& change) {
  ModalBody body = test::modal_sphere(0.3, 12.0);
  change(body);
  return value_of(RefinableContact(modal_body(body)), 1e-3);
}

TEST(ModalBody, CarriesTheErrorsOfItsNumbers) {
  const Restitution exact = with([](ModalBody&) {});
  const auto expect_carried = [&](const auto& uncertain, const auto& changed) {
    const Restitution stated = with(uncertain), other = with(changed);
    EXPECT_EQ(stated.lost_fraction.value, exact.lost_fraction.value);
    EXPECT_GT(stated.lost_fraction.error, exact.lost_fraction.error);
    const double more = std::sqrt(stated.lost_fraction.error * stated.lost_fraction.error -
                                  exact.lost_fraction.error * exact.lost_fraction.error);
    const double change = std::abs(other.finest.lost_fraction - exact.finest.lost_fraction);
    EXPECT_GT(more, 0.4 * change);  // of other cutoffs, the change is another
    EXPECT_LT(more, 3.0 * change);
  };
  expect_carried([](ModalBody& body) { body.compliance_error = 0.05; },
                 [](ModalBody& body) { body.compliance += 0.05; });
  const auto each = [](double PointMode::*value, double share) {
    return [value, share](ModalBody& body) {
      for (PointMode& mode : body.modes) {
        (value == &PointMode::omega_error          ? mode.omega_error
         : value == &PointMode::displacement_error ? mode.displacement_error
         : value == &PointMode::omega              ? mode.omega
                                                   : mode.displacement) +=
            share *
            (value == &PointMode::omega_error || value == &PointMode::omega ? mode.omega : std::abs(mode.displacement));
      }
    };
  };
  expect_carried(each(&PointMode::omega_error, 1e-3), [&](ModalBody& body) {
    each(&PointMode::omega, 1e-3)(body);
    body.complete_to *= 1.001;
  });
  expect_carried(each(&PointMode::displacement_error, 1e-3), each(&PointMode::displacement, 1e-3));
}

// A heavy block without modes that a ball strikes on its face: a rigid ball and a half-space that does not radiate.
TEST(ModalBody, OfAPlaneSurfaceIsStruckByASphere) {
  ModalBody block;
  block.mass = 100.0;
  block.poisson = 0.3;
  block.complete_to = 1.0;
  const Restitution found = value_of(RefinableContact(sphere(0.3), modal_body(block)), 1e-3);
  const Restitution half = value_of(RefinableContact(sphere(0.3), half_space(HalfSpace{0.3})), 1e-3);
  EXPECT_NEAR(found.contact_time.value, half.contact_time.value, 0.02 * half.contact_time.value);
  EXPECT_NEAR(found.max_force.value, half.max_force.value, 0.04 * half.max_force.value);
}

// Of a sphere the first mode has 1.64 c/R: six levels below 4 c/R there is none, five below there is.
TEST(ModalBody, BeginsWhereAModeIsKept) {
  const auto lowest = [](double complete_to) {
    const RefinableContact wall(modal_body(test::modal_sphere(0.3, complete_to)));
    const Levels levels = wall.levels(1e-3, 1.0);
    return std::pair(levels.highest - levels.lowest, wall.cutoff(levels.lowest));
  };
  EXPECT_EQ(lowest(4.6).first, 5);
  EXPECT_GT(lowest(4.6).second, 1.65);
  EXPECT_EQ(lowest(5.0).first, 6);  // one of them is kept as it is
  EXPECT_EQ(lowest(2.9).first, 6);  // none is either way
  const Restitution found = value_of(RefinableContact(modal_body(test::modal_sphere(0.3, 4.6))), 1e-3);
  const Restitution exact = value_of(RefinableContact(sphere(0.3)), 1e-3);
  EXPECT_NEAR(found.lost_fraction.value, exact.lost_fraction.value, found.lost_fraction.error);
  EXPECT_LT(found.lost_fraction.error, 0.08 * exact.lost_fraction.value);
}

/// A body on a spring so soft that it moves as if it were free: rigid motion is its lowest mode.
ModalBody on_a_soft_spring(ModalBody body, double omega) {
  const double displacement = 1.0 / std::sqrt(body.mass);
  body.held = true;
  body.compliance += std::pow(displacement / omega, 2);
  body.modes.insert(body.modes.begin(), {omega, displacement});
  return body;
}

// The ball comes back as fast from both; ε of the free body is that of velocities of both, u' = (ε − r)/(1 + r).
TEST(ModalBody, OnASoftSpringIsAFreeOne) {
  for (const double radius : {0.3, 0.6}) {
    const ModalBody body = test::modal_sphere(0.3, 12.0);
    const BodyMaker ball = sphere(Sphere{0.3, radius});
    const double ratio = std::pow(radius, 3);
    const Estimate free = value_of(RefinableContact(ball, modal_body(body)), 1e-3).restitution;
    const Estimate held = value_of(RefinableContact(ball, modal_body(on_a_soft_spring(body, 1e-3))), 1e-3).restitution;
    EXPECT_NEAR(held.value, (free.value - ratio) / (1.0 + ratio), held.error + free.error) << radius;
    EXPECT_NEAR(held.value, (free.value - ratio) / (1.0 + ratio), 2e-3) << radius;
  }
}

TEST(ModalBody, ThatIsHeldDoesNotMove) {
  const ModalBody held = on_a_soft_spring(test::modal_sphere(0.3, 8.0), 0.1);
  const std::vector<std::string> said{"cannot", "does not move", "let another body meet it"};
  test::expect_refusal([&] { (void)value_of(RefinableContact(modal_body(held)), 1e-3); }, said);
  test::expect_refusal([&] { (void)value_of(RefinableContact(modal_body(held), sphere(0.3)), 1e-3); },
                       {"cannot be the first body"});
}

}  // namespace
}  // namespace modal_bodies
}  // namespace stoss
