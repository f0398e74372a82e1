// What is no body by its modes at a point, and what such bodies cannot meet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/oblique.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/modal_sphere.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace modal_refusals {
namespace {

TEST(ModalBody, RefusesWhatIsNoBody) {
  const auto refused = [](const std::string& name, const auto& change) {
    ModalBody body = test::modal_sphere(0.3, 12.0);
    change(body);
    test::expect_refusal([&] { (void)modal_body(body); }, {name});
  };
  refused("mass", [](ModalBody& body) { body.mass = 0.0; });
  refused("mass", [](ModalBody& body) { body.mass = NAN; });
  refused("curvature", [](ModalBody& body) { body.curvature = -0.1; });
  refused("curvature_difference", [](ModalBody& body) { body.curvature_difference = -0.1; });
  refused("poisson", [](ModalBody& body) { body.poisson = 0.5; });
  refused("compliance", [](ModalBody& body) { body.compliance = INFINITY; });
  refused("compliance_error", [](ModalBody& body) { body.compliance_error = -1.0; });
  refused("complete_to", [](ModalBody& body) { body.complete_to = 0.0; });
  refused("rising order", [](ModalBody& body) { std::swap(body.modes[3], body.modes[4]); });
  refused("rigid motion", [](ModalBody& body) { body.modes[0].omega = 0.0; });
  refused("displacement", [](ModalBody& body) { body.modes[2].displacement = NAN; });
  refused("modes are missing", [](ModalBody& body) { body.modes.resize(4); });
  refused("unit modal mass", [](ModalBody& body) {
    for (PointMode& mode : body.modes) mode.displacement *= 0.1;
  });
}

TEST(ModalBody, RefusesNumbersOfOtherUnits) {
  const auto refused = [](const std::string& name, const auto& change) {
    ModalBody body = test::modal_sphere(0.3, 12.0);
    change(body);
    test::expect_refusal([&] { (void)modal_body(body); }, {name, "units"});
  };
  refused("mass", [](ModalBody& body) { body.mass *= 1e3; });              // g for kg
  refused("compliance", [](ModalBody& body) { body.compliance *= 1e3; });  // mm/N
  refused("compliance", [](ModalBody& body) {
    for (PointMode& mode : body.modes) mode.displacement *= 30.0;
  });
  // Any size in any system of units is as good.
  for (const double unit : {1e-3, 1e3, 1e6}) {
    EXPECT_NO_THROW((void)modal_body(in_units(test::modal_sphere(0.3, 12.0), unit, 1e-3 * unit, 1e6 / unit)));
  }
}

// What they might be by the errors of their displacements is not refused, though it moves the point both ways.
TEST(ModalBody, IsNotRefusedFrictionForTheErrorsOfItsModes) {
  ModalBody body = test::modal_sphere_along(0.3, 12.0);
  for (PointMode& mode : body.modes) {
    if (mode.displacement == 0.0) mode.displacement_error = 1.0;
  }
  const auto rubs = [&] {
    return oblique_restitution(RefinableContact(modal_body(body)), 1e-3, {3e-4, 0.0, 0.0, 0.3});
  };
  EXPECT_NO_THROW((void)rubs());
}

TEST(ModalBody, RefusesContactsThatAreNotSmallAndRound) {
  ModalBody plane = test::modal_sphere(0.3, 12.0);
  plane.curvature = 0.0;
  test::expect_refusal([&] { (void)contact(modal_body(plane)(5.0, {})); }, {"curvature", "flat"});
  test::expect_refusal([&] { (void)RefinableContact(modal_body(plane), half_space(HalfSpace{0.3})); },
                       {"curvature", "flat"});
  EXPECT_NO_THROW(RefinableContact(modal_body(plane), sphere(0.3)));
  ModalBody cylinder = test::modal_sphere(0.3, 12.0);
  cylinder.curvature_difference = 2.0;
  test::expect_refusal([&] { (void)RefinableContact(modal_body(cylinder), half_space(HalfSpace{0.3})); },
                       {"curvature", "4 : 1"});
  EXPECT_NO_THROW(RefinableContact(modal_body(cylinder), sphere(0.3)));
  EXPECT_THROW((void)restitution(RefinableContact(modal_body(test::modal_sphere(0.3, 12.0))), 0.5), NotConverged);
}

TEST(ModalBody, OfTooMuchComplianceInItsModesCannotBeComputed) {
  ModalBody body = test::modal_sphere(0.3, 12.0);
  body.compliance = -20.0;
  EXPECT_THROW((void)restitution(RefinableContact(modal_body(body)), 1e-3), NotConverged);
}

/// With friction at a wall.
ObliqueRestitution rubbed(const ModalBody& body, double friction = 0.3) {
  return oblique_restitution(RefinableContact(modal_body(body)), 1e-3, {3e-4, 0.0, 0.0, friction});
}

TEST(ModalBody, WithoutATangentMeetsNoFriction) {
  const ModalBody body = test::modal_sphere(0.3, 12.0);
  test::expect_refusal([&] { (void)rubbed(body); }, {"friction", "modal body", "tangential data"});
  test::expect_refusal(
      [&] {
        (void)oblique_impact(contact(modal_body(body)(8.0, {})), 1e-3, {3e-4, 0.0, 0.0, 0.3});
      },
      {"tangential data"});
  EXPECT_EQ(rubbed(body, 0.0).tangential_restitution.value, -1.0);
  test::expect_refusal(
      [&] {
        (void)oblique_restitution(RefinableContact(modal_body(body)), 1e-3, {0.0, 1e-3, 0.0, 0.0});
      },
      {"spin", "does not turn"});
  // Nor does what it meets.
  test::expect_refusal(
      [&] {
        (void)oblique_restitution(RefinableContact(sphere(0.3), modal_body(body)), 1e-3, {3e-4, 0.0, 0.0, 0.3});
      },
      {"friction", "tangential data"});
}

TEST(ModalBody, ThatMovesBothWaysAtOnceMeetsNoFriction) {
  ModalBody turning = test::modal_sphere_along(0.3, 12.0);
  turning.tangent->cross = 0.1 / turning.mass;
  test::expect_refusal([&] { (void)rubbed(turning); }, {"friction", "turning", "0.053", "allowed up to 0.05"});
  EXPECT_NO_THROW((void)rubbed(turning, 0.0));
  ModalBody lopsided = test::modal_sphere_along(0.3, 12.0);
  lopsided.modes[2].tangential = 1.0;
  lopsided.modes[2].displacement = 1.0;
  test::expect_refusal([&] { (void)rubbed(lopsided); }, {"friction", "mode 3", "symmetry"});
  // Of modes that are not known to be complete nothing is asked.
  lopsided.modes[2].tangential = 0.0;
  lopsided.complete_to = 11.0;
  lopsided.modes.back().displacement = lopsided.modes.back().tangential = 1.0;
  EXPECT_NO_THROW((void)rubbed(lopsided));
}

TEST(ModalBody, RefusesWhatIsNoTangent) {
  const auto refused = [](const std::string& name, const auto& change) {
    ModalBody body = test::modal_sphere_along(0.3, 12.0);
    change(body);
    test::expect_refusal([&] { (void)modal_body(body); }, {name});
  };
  refused("tangential mass", [](ModalBody& body) { body.tangent->mass = 0.0; });
  refused("tangential inertia", [](ModalBody& body) { body.tangent->inertia = -1.0; });
  refused("tangential arm", [](ModalBody& body) { body.tangent->arm = 0.0; });
  refused("tangential cross", [](ModalBody& body) { body.tangent->cross = INFINITY; });
  refused("tangential compliance", [](ModalBody& body) { body.tangent->compliance = NAN; });
  refused("tangential compliance_error", [](ModalBody& body) { body.tangent->compliance_error = -1.0; });
  refused("mode 3 tangential displacement", [](ModalBody& body) { body.modes[2].tangential = NAN; });
  refused("mode 3 tangential bend", [](ModalBody& body) { body.modes[2].tangential_bend = NAN; });
  refused("mode 3 tangential displacement error", [](ModalBody& body) { body.modes[2].tangential_error = -1.0; });
}

}  // namespace
}  // namespace modal_refusals
}  // namespace stoss
