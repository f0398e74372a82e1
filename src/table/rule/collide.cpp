#include "stoss/table/collide.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a + x b
Vector sum(const Vector& a, double x, const Vector& b) { return {a[0] + x * b[0], a[1] + x * b[1], a[2] + x * b[2]}; }

MovingBody<3> in_space(const MovingBody<2>& body) {
  return {body.inverse_mass,
          body.inverse_inertia,
          body.radius,
          {body.velocity[0], body.velocity[1], 0.0},
          {0.0, 0.0, body.spin[0]}};
}

void set(MovingBody<2>& body, const MovingBody<3>& after) {
  body.velocity = {after.velocity[0], after.velocity[1]};
  body.spin = {after.spin[2]};
}

/// The normal at length 1, from one of any length: brought near 1 first, so that its square is a number.
Vector direction(const Vector& normal) {
  double greatest = 0.0;
  for (const double each : normal) greatest = std::max(greatest, std::isfinite(each) ? std::abs(each) : HUGE_VAL);
  if (!(greatest > 0.0) || !std::isfinite(greatest)) {
    throw InvalidInput::out_of_range("normal",
                                     "(" + shown(normal[0]) + ", " + shown(normal[1]) + ", " + shown(normal[2]) + ")",
                                     "finite numbers that are not all 0");
  }
  Vector n{normal[0] / greatest, normal[1] / greatest, normal[2] / greatest};
  const double length = std::sqrt(dot(n, n));
  for (double& each : n) each /= length;
  return n;
}

void require_motion(const MovingBody<3>& body) {
  const auto require = [](const char* name, std::initializer_list<double> values, bool positive) {
    for (const double value : values) {
      if (std::isfinite(value) && (!positive || value >= 0.0)) continue;
      throw InvalidInput::out_of_range(std::string(name), shown(value),
                                       (positive ? "a finite number, 0 or more" : "finite numbers"));
    }
  };
  require("inverse_mass", {body.inverse_mass}, true);
  require("inverse_inertia", {body.inverse_inertia}, true);
  require("radius", {body.radius}, true);
  require("velocity", {body.velocity[0], body.velocity[1], body.velocity[2]}, false);
  require("spin", {body.spin[0], body.spin[1], body.spin[2]}, false);
}

}  // namespace

bool collide(const RuleTable& rule, MovingBody<3>& first, MovingBody<3>& second, const Vector& normal,
             double friction) {
  const Vector n = direction(normal);
  require_motion(first);
  require_motion(second);
  const Vector relative = sum(first.velocity, -1.0, second.velocity);
  const double speed = dot(relative, n), mobility = first.inverse_mass + second.inverse_mass;
  if (!(speed > 0.0) || !(mobility > 0.0)) return false;
  Vector turning{};
  for (std::size_t i = 0; i < 3; ++i) turning[i] = first.radius * first.spin[i] + second.radius * second.spin[i];
  const Vector along = sum(sum(relative, -speed, n), 1.0, cross(turning, n));
  const double sliding = std::sqrt(dot(along, along));
  const double ratio = second.radius / first.radius;
  const Rule after = rule.unchecked(speed, sliding, friction, ratio);
  if (std::isnan(after.sliding_error)) (void)rule(speed, sliding, friction, ratio);  // says what is refused
  Vector drag{};                                                                     // along the surface
  if (sliding != 0.0) {
    const double turning_mobility =
        first.radius * first.radius * first.inverse_inertia + second.radius * second.radius * second.inverse_inertia;
    drag = sum(drag, (sliding - after.sliding_after) / ((mobility + turning_mobility) * sliding), along);
  }
  const Vector impulse = sum(drag, (1.0 + after.restitution.value) * speed / mobility, n), moment = cross(n, drag);
  first.velocity = sum(first.velocity, -first.inverse_mass, impulse);
  second.velocity = sum(second.velocity, second.inverse_mass, impulse);
  first.spin = sum(first.spin, -first.radius * first.inverse_inertia, moment);
  second.spin = sum(second.spin, -second.radius * second.inverse_inertia, moment);
  return true;
}

bool collide(const RuleTable& rule, MovingBody<2>& first, MovingBody<2>& second, const std::array<double, 2>& normal,
             double friction) {
  MovingBody<3> one = in_space(first), other = in_space(second);
  if (!collide(rule, one, other, {normal[0], normal[1], 0.0}, friction)) return false;
  set(first, one);
  set(second, other);
  return true;
}

}  // namespace stoss
