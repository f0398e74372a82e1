// What is known of a body along its surface: how friction turns it, its units, and errors that enter those of s′.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stoss/bodies/modal_body.hpp"
#include "stoss/restitution/oblique.hpp"
#include "support/modal_sphere.hpp"

namespace stoss {
namespace modal_tangents {
namespace {

using std::numbers::pi;

// Coulomb's friction at all times: Δs = −μP/m_t, shared by the centre, −μP/M, and by turning, −μPR/I.
TEST(ModalTangent, SlidesAsARigidBodyThatIsStruckOffItsCentre) {
  ModalBody body = test::modal_sphere_along(0.3, 8.0);
  body.mass = 0.5 * body.tangent->mass;  // as the point feels it
  const double whole = body.tangent->mass;
  body.tangent->arm = 1.7;
  body.tangent->inertia = 0.9 * whole;
  for (PointMode& mode : body.modes) mode.displacement *= 0.2, mode.bend *= 0.2;
  body.complete_to = 3.0;  // where there are too few modes for a law of them
  const RefinableContact wall(modal_body(body));
  constexpr double speed = 1e-4, friction = 0.1;
  const ObliqueRestitution found = oblique_restitution(wall, speed, {2e-4, 0.0, 0.0, friction});
  const double impulse = body.mass * (1.0 + found.finest.restitution) * speed;
  EXPECT_NEAR(found.tangential_after.value, 2e-4 - friction * impulse / whole, 1e-7 * speed);
  const double unit = found.spin_after.value;
  EXPECT_NEAR(unit, -friction * impulse * 1.7 / (0.9 * whole), 2e-3 * std::abs(unit));  // rings lie behind the point
  EXPECT_NEAR(found.sliding_after.value, found.tangential_after.value + 1.7 * unit, 1e-12);
  EXPECT_NEAR(found.finest.energy_error, 0.0, 1e-5);
  EXPECT_LT(found.finest.momentum_error, 1e-12);
  EXPECT_LT(found.finest.angular_momentum_error, 1e-12);
}

TEST(ModalTangent, DoesNotDependOnUnits) {
  const ModalBody own = test::modal_sphere_along(0.3, 12.0);
  const ModalBody steel = in_units(own, 1.0 / 0.01, 1.0 / 210e9, 1.0 / 7850.0);
  EXPECT_NEAR(steel.mass, own.mass * 7850.0 * 1e-6, 1e-12);
  EXPECT_NEAR(steel.tangent->inertia, 0.4 * steel.mass * 1e-4, 1e-12);
  EXPECT_NEAR(scales(steel).length, 0.01, 1e-15);
  EXPECT_NEAR(scales(steel).speed, std::sqrt(210e9 / 7850.0), 1e-9);
  const Obliquity obliquity{3e-4, 2e-4, 0.0, 0.3};
  const ObliqueRestitution one = oblique_restitution(RefinableContact(modal_body(own)), 1e-3, obliquity);
  const ObliqueRestitution other = oblique_restitution(RefinableContact(modal_body(steel)), 1e-3, obliquity);
  EXPECT_NEAR(one.restitution.value, other.restitution.value, 1e-9 * (1.0 - one.restitution.value));
  EXPECT_NEAR(one.restitution.error, other.restitution.error, 1e-6 * one.restitution.error);
  EXPECT_NEAR(one.sliding_after.value, other.sliding_after.value, 1e-9 * one.sliding);
  EXPECT_NEAR(one.spin_after.value, other.spin_after.value, 1e-9 * one.sliding);
  EXPECT_NEAR(one.sliding_after.error, other.sliding_after.error, 1e-6 * one.sliding_after.error);
}

/// s′ at v = 1e-3, half stuck, with a change of the body.
template <typename Change>
Estimate sliding_with(const Change& change) {
  ModalBody body = test::modal_sphere_along(0.3, 12.0);
  change(body);
  return oblique_restitution(RefinableContact(modal_body(body)), 1e-3, {3e-4, 0.0, 0.0, 0.3}).sliding_after;
}

TEST(ModalTangent, CarriesTheErrorsOfItsNumbers) {
  const Estimate exact = sliding_with([](ModalBody&) {});
  const auto expect_carried = [&](const auto& uncertain, const auto& changed) {
    const Estimate stated = sliding_with(uncertain), other = sliding_with(changed);
    EXPECT_EQ(stated.value, exact.value);
    const double change = std::abs(other.value - exact.value);
    const double more = std::sqrt(stated.error * stated.error - exact.error * exact.error);
    EXPECT_GT(change, 1e-10);
    EXPECT_GT(more, 0.4 * change);
    EXPECT_LT(more, 3.0 * change);
  };
  expect_carried([](ModalBody& body) { body.tangent->compliance_error = 0.3; },
                 [](ModalBody& body) { body.tangent->compliance += 0.3; });
  expect_carried([](ModalBody& body) { body.compliance_error = 0.3; }, [](ModalBody& body) { body.compliance += 0.3; });
  expect_carried(
      [](ModalBody& body) {
        for (PointMode& mode : body.modes) mode.tangential_error = 0.02 * std::abs(mode.tangential);
      },
      [](ModalBody& body) {
        for (PointMode& mode : body.modes) mode.tangential *= 1.02;
      });
}

TEST(ModalTangent, OfUnequalCurvaturesHasAnErrorForThem) {
  const Estimate round = sliding_with([](ModalBody&) {});
  const Estimate oval = sliding_with([](ModalBody& body) { body.curvature_difference = 0.6; });
  EXPECT_NE(oval.value, round.value);  // that of a contact as soft as the ellipse
  EXPECT_GT(oval.error, 2.0 * round.error);
}

// Two modes of one frequency, of which one moves the point along the normal and one along the surface, are also any two
// combinations of them: nothing changes.
TEST(ModalTangent, StatesWhatModesThatMoveBothWaysMayDo) {
  const auto with_turned_pair = [](double angle) {
    return [angle](ModalBody& body) {
      for (std::size_t i = 0; i + 1 < body.modes.size(); ++i) {
        PointMode &one = body.modes[i], &other = body.modes[i + 1];
        if (one.omega != other.omega || one.displacement == 0.0 || other.displacement != 0.0) continue;
        const PointMode normal = one, along = other;
        const double cosine = std::cos(angle), sine = std::sin(angle);
        one.displacement = cosine * normal.displacement, one.bend = cosine * normal.bend;
        one.tangential = sine * along.tangential, one.tangential_bend = sine * along.tangential_bend;
        other.displacement = -sine * normal.displacement, other.bend = -sine * normal.bend;
        other.tangential = cosine * along.tangential, other.tangential_bend = cosine * along.tangential_bend;
        return;
      }
      FAIL() << "no pair of modes";
    };
  };
  const Estimate exact = sliding_with(with_turned_pair(0.0)), turned = sliding_with(with_turned_pair(0.7));
  EXPECT_NEAR(turned.value, exact.value, 1e-10);
  // One of the two takes back at once what the other does; of a lonely mode the bar tells it.
  EXPECT_NEAR(turned.error, exact.error, 1e-10);
  const Estimate lonely = sliding_with([](ModalBody& body) {
    for (PointMode& mode : body.modes) {
      if (mode.displacement != 0.0 && mode.tangential == 0.0) mode.tangential = 1e-4;
    }
  });
  EXPECT_GT(lonely.error, exact.error + 1e-7);
  // Turning that the normal impulse causes: 2 (1 + ε) m v κ.
  const Estimate tilted = sliding_with([](ModalBody& body) { body.tangent->cross = 1e-3; });
  EXPECT_EQ(tilted.value, exact.value);
  EXPECT_NEAR(tilted.error - exact.error, 4e-6 * (4.0 * pi / 3.0), 1e-8);
}

}  // namespace
}  // namespace modal_tangents
}  // namespace stoss
