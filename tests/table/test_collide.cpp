// What a collision keeps, whatever the rule and the motion are.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "stoss/errors.hpp"
#include "stoss/table/collide.hpp"
#include "support/rules.hpp"

namespace stoss {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double energy(const MovingBody<3>& body) {
  return 0.5 * dot(body.velocity, body.velocity) / body.inverse_mass +
         0.5 * dot(body.spin, body.spin) / body.inverse_inertia;
}

/// About the centre of the first body. @param place of the body
Vector angular_momentum(const MovingBody<3>& body, const Vector& place) {
  Vector sum = cross(place, body.velocity);
  for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] / body.inverse_mass + body.spin[i] / body.inverse_inertia;
  return sum;
}

MovingBody<3> in_space(const MovingBody<2>& body) {
  return {body.inverse_mass,
          body.inverse_inertia,
          body.radius,
          {body.velocity[0], body.velocity[1], 0.0},
          {0.0, 0.0, body.spin[0]}};
}

/// Bodies in space, or in a plane, at random.
class Chance {
 public:
  explicit Chance(int dimensions) : dimensions_(dimensions) {}

  double size(double low, double high) { return low * std::pow(high / low, 0.5 + 0.5 * any()); }
  double any() { return uniform_(random_); }

  MovingBody<3> body() {
    MovingBody<3> made{size(0.1, 10.0), size(0.1, 30.0), size(0.3, 3.0)};
    const double speed = size(1e-3, 1.0), turning = size(1e-3, 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool plane = i < 2;
      if (plane || dimensions_ == 3) made.velocity[i] = speed * any();
      if (!plane || dimensions_ == 3) made.spin[i] = turning * any();
    }
    return made;
  }

  Vector normal() { return {any(), any(), dimensions_ == 3 ? any() : 0.0}; }

 private:
  int dimensions_;
  std::mt19937_64 random_{11};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

MovingBody<2> in_plane(const MovingBody<3>& body) {
  return {body.inverse_mass, body.inverse_inertia, body.radius, {body.velocity[0], body.velocity[1]}, {body.spin[2]}};
}

/// One collision, in space or in the plane.
bool meet(int dimensions, const RuleTable& rule, MovingBody<3>& a, MovingBody<3>& b, const Vector& n, double friction) {
  if (dimensions == 3) return collide(rule, a, b, n, friction);
  MovingBody<2> one = in_plane(a), other = in_plane(b);
  const bool met = collide(rule, one, other, {n[0], n[1]}, friction);
  a = in_space(one), b = in_space(other);
  return met;
}

class Collisions : public testing::TestWithParam<int> {};

TEST_P(Collisions, KeepWhatMustBeKept) {
  const RuleTable computed(test::some_rule(), Beyond::clamp), wild(test::wild_rule(2), Beyond::clamp);
  Chance chance(GetParam());
  int met = 0;
  double gained = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    MovingBody<3> a = chance.body(), b = chance.body();
    const MovingBody<3> a0 = a, b0 = b;
    const Vector n = chance.normal();
    const double length = std::sqrt(dot(n, n)), friction = std::abs(chance.any());
    const bool approach = meet(GetParam(), i % 2 == 0 ? computed : wild, a, b, n, friction);
    met += approach;
    const double before = energy(a0) + energy(b0), after = energy(a) + energy(b);
    gained = std::max(gained, (after - before) / before);
    Vector away{};
    for (std::size_t k = 0; k < 3; ++k) away[k] = (a.radius + b.radius) * n[k] / length;
    const Vector turned = angular_momentum(a, {}), turned0 = angular_momentum(a0, {});
    const Vector other = angular_momentum(b, away), other0 = angular_momentum(b0, away);
    const double scale = std::sqrt(before) * 50.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double momentum =
          (a.velocity[k] - a0.velocity[k]) / a.inverse_mass + (b.velocity[k] - b0.velocity[k]) / b.inverse_mass;
      ASSERT_NEAR(momentum, 0.0, 1e-15 * scale);
      ASSERT_NEAR(turned[k] + other[k] - turned0[k] - other0[k], 0.0, 1e-14 * scale);
    }
    ASSERT_NEAR(dot(a.spin, n), dot(a0.spin, n), 1e-15 * scale);
    ASSERT_NEAR(dot(b.spin, n), dot(b0.spin, n), 1e-15 * scale);
    if (!approach) {
      ASSERT_EQ(a.velocity, a0.velocity);
      ASSERT_EQ(b.spin, b0.spin);
    }
  }
  EXPECT_LT(gained, 1e-14);
  EXPECT_NEAR(met, 50'000, 1'000);
}

TEST_P(Collisions, DoWhatTheRuleSays) {
  const RuleTable rule(test::some_rule(), Beyond::clamp);
  Chance chance(GetParam());
  for (int i = 0; i < 1'000; ++i) {
    MovingBody<3> a = chance.body(), b = chance.body();
    const Vector n = chance.normal();
    const auto motion = [&]() -> std::pair<double, double> {  // v_n and |s|
      const double length = std::sqrt(dot(n, n));
      Vector turning{}, relative{};
      for (std::size_t k = 0; k < 3; ++k) {
        turning[k] = (a.radius * a.spin[k] + b.radius * b.spin[k]) / length;
        relative[k] = a.velocity[k] - b.velocity[k];
      }
      const double speed = dot(relative, n) / length;
      Vector along = cross(turning, n);
      for (std::size_t k = 0; k < 3; ++k) along[k] += relative[k] - speed * n[k] / length;
      return {speed, std::sqrt(dot(along, along))};
    };
    const auto [speed, sliding] = motion();
    if (!meet(GetParam(), rule, a, b, n, 0.3)) continue;
    const auto [speed_after, sliding_after] = motion();
    const Rule expected = rule(speed, sliding, 0.3);
    EXPECT_NEAR(-speed_after, expected.restitution.value * speed, 1e-14);
    EXPECT_NEAR(sliding_after, std::abs(expected.sliding_after), 1e-14);
  }
}

TEST_P(Collisions, OfWhatDoesNotMeetChangeNothing) {
  const RuleTable rule(test::some_rule());
  const auto unchanged = [&](MovingBody<3> a, MovingBody<3> b, const Vector& n) {
    const MovingBody<3> a0 = a, b0 = b;
    EXPECT_FALSE(meet(GetParam(), rule, a, b, n, 0.3));
    EXPECT_EQ(a.velocity[1], a0.velocity[1]);
    EXPECT_EQ(a.spin, a0.spin);
    EXPECT_EQ(b.velocity, b0.velocity);
    EXPECT_EQ(b.spin, b0.spin);
  };
  const MovingBody<3> a{1.0, 2.5, 1.0, {0.1, 0.02, 0.0}, {0.0, 0.0, 0.3}}, wall{0.0, 0.0, 0.0, {}, {}};
  unchanged(a, wall, {-1.0, 0.0, 0.0});
  unchanged(a, a, {1.0, 0.0, 0.0});
  unchanged(MovingBody<3>{0.0, 0.0, 1.0, {0.1, 0.0, 0.0}, {}}, wall, {1.0, 0.0, 0.0});
}

TEST_P(Collisions, AreThoseOfANormalOfAnyLength) {
  const RuleTable rule(test::some_rule(), Beyond::clamp);
  const MovingBody<3> a{1.0, 2.5, 1.0, {0.1, 0.02, 0.0}, {0.0, 0.0, 0.3}}, wall{0.0, 0.0, 0.0, {}, {}};
  const auto after = [&](double length) {
    MovingBody<3> one = a, other = wall;
    EXPECT_TRUE(meet(GetParam(), rule, one, other, {0.6 * length, 0.8 * length, 0.0}, 0.3)) << length;
    return one;
  };
  const MovingBody<3> expected = after(1.0);
  for (const double length : {1e-320, 1e-310, 1e-300, 1e-200, 1e-30, 1e200, 1.7e308}) {
    const MovingBody<3> got = after(length);
    const double rounding = length < 1e-307 ? 1e-3 : 1e-15;  // of the components that are given
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(got.velocity[k], expected.velocity[k], rounding) << length;
      EXPECT_NEAR(got.spin[k], expected.spin[k], rounding) << length;
    }
  }
}

TEST_P(Collisions, RefuseWhatIsNoMotion) {
  const MovingBody<3> a{1.0, 2.5, 1.0, {0.1, 0.02, 0.0}, {0.0, 0.0, 0.3}}, wall{0.0, 0.0, 0.0, {}, {}};
  const Vector n{1.0, 0.0, 0.0};
  const auto refused = [&](const std::string& name, MovingBody<3> one, MovingBody<3> other, const Vector& normal,
                           double friction = 0.3) {
    for (const RuleTable& rule : {RuleTable(test::some_rule()), RuleTable(test::some_rule(), Beyond::clamp)}) {
      const MovingBody<3> before = other;
      try {
        meet(GetParam(), rule, one, other, normal, friction);
        ADD_FAILURE() << name;
      } catch (const InvalidInput& error) {
        EXPECT_EQ(std::string(error.what()).find(name + ": got "), 0U) << error.what();
      }
      EXPECT_EQ(one.velocity[1], 0.02);
      EXPECT_EQ(other.spin, before.spin);
    }
  };
  refused("normal", a, wall, {0.0, 0.0, 0.0});
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    refused("normal", a, wall, {bad, 0.0, 0.0});
    refused("normal", a, wall, {1.0, bad, 0.0});
    refused("friction", a, wall, n, bad);
    const auto broken = [&](const std::string& name, double MovingBody<3>::*number) {
      MovingBody<3> one = a, other = wall;
      one.*number = other.*number = bad;
      refused(name, one, wall, n);
      refused(name, a, other, n);
    };
    broken("inverse_mass", &MovingBody<3>::inverse_mass);
    broken("inverse_inertia", &MovingBody<3>::inverse_inertia);
    broken("radius", &MovingBody<3>::radius);
    MovingBody<3> one = a;
    one.velocity[0] = bad;
    refused("velocity", one, wall, n);
    one = a;
    one.spin[2] = bad;
    refused("spin", one, wall, n);
    refused("spin", one, wall, {-1.0, 0.0, 0.0});  // also where they do not approach
  }
  MovingBody<3> one = a;
  one.radius = -1.0;
  refused("radius", one, wall, n);
  refused("friction", a, wall, n, -0.1);
}

TEST_P(Collisions, HeadOnDoNotTurn) {
  const RuleTable rule(test::some_rule());
  MovingBody<3> a{1.0, 2.5, 1.0, {0.1, 0.0, 0.0}, {}}, wall{0.0, 0.0, 0.0, {}, {}};
  EXPECT_TRUE(meet(GetParam(), rule, a, wall, {2.0, 0.0, 0.0}, 0.3));
  EXPECT_DOUBLE_EQ(a.velocity[0], -0.1 * rule(0.1, 0.0, 0.3).restitution.value);
  EXPECT_EQ(a.velocity[1], 0.0);
  EXPECT_EQ(a.spin, Vector{});
  EXPECT_EQ(wall.velocity, Vector{});
  MovingBody<3> slow{1.0, 2.5, 1.0, {1e-3, 0.0, 0.0}, {}};  // below the range
  EXPECT_TRUE(meet(GetParam(), rule, slow, wall, {1.0, 0.0, 0.0}, 0.3));
  EXPECT_TRUE(std::isnan(slow.velocity[0]));
}

INSTANTIATE_TEST_SUITE_P(Space, Collisions, testing::Values(2, 3),
                         [](const auto& each) { return each.param == 2 ? "flat" : "solid"; });

}  // namespace
}  // namespace stoss
