// What is no body by its modes at a point, and what such bodies cannot meet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
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
  refused("curvature_difference", [](ModalBody& body) { body.curvature_difference = 2.1; });
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

TEST(ModalBody, RefusesContactsThatAreNotSmallAndRound) {
  ModalBody plane = test::modal_sphere(0.3, 12.0);
  plane.curvature = 0.0;
  test::expect_refusal([&] { (void)contact(modal_body(plane)(5.0, {})); }, {"curvature", "plane"});
  test::expect_refusal([&] { (void)RefinableContact(modal_body(plane), half_space(HalfSpace{0.3})); },
                       {"curvature", "plane"});
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

}  // namespace
}  // namespace modal_refusals
}  // namespace stoss
