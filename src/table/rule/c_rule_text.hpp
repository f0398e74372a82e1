#pragma once

#include <string_view>

namespace stoss::table {

/// The rule at any arguments, as RuleTable::unchecked has it.
inline constexpr std::string_view c_rule_function = R"(
/* Restitution, its error, sliding after, its error; what is not a number where the table says nothing. */
@NAME@_FUNCTION void @name@_at(double speed, double sliding, double friction, double ratio, double *found)
{
  const double s = fabs(sliding), limit = friction * fabs(speed), scale = s + limit;
  double v = fabs(speed), p = @place@, after;
  int inside, i;
  for (i = 0; i < 4; ++i) found[i] = HUGE_VAL - HUGE_VAL;
@unused@  if (!(v < HUGE_VAL && s < HUGE_VAL && @friction@@ratio@)) return;
  inside = v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST@inside@;
  if (!inside) {
    found[1] = found[3] = HUGE_VAL;
@outside@  }
  @name@_look_up(log(v), scale > 0.0 ? (s - limit) / scale : -1.0, p, found);
  if (found[0] < 0.0) found[0] = 0.0;
  if (found[0] > 1.0) found[0] = 1.0;
  after = found[2] * scale;
  if (after < -s) after = -s;
  if (after > s) after = s;
  found[2] = sliding < 0.0 ? -after : after;
  if (!inside) found[1] = found[3] = HUGE_VAL;
}
)";

/// The collision of two bodies, as stoss::collide has it.
inline constexpr std::string_view c_collide_functions = R"(
/* A round body: inverse_mass 0 does not move, inverse_inertia 0 does not turn. */
typedef struct {
  double inverse_mass, inverse_inertia, radius;
  double velocity[2], spin; /* spin from x to y */
} @name@_body_2d;

typedef struct {
  double inverse_mass, inverse_inertia, radius;
  double velocity[3], spin[3];
} @name@_body_3d;

/* The normal at length 1, from one of any length; 0 if it has no direction. */
@NAME@_FUNCTION int @name@_direction(const double *normal, int count, double *n)
{
  double greatest = 0.0, square = 0.0;
  int i;
  for (i = 0; i < count; ++i) {
    if (!(fabs(normal[i]) < HUGE_VAL)) return 0;
    if (fabs(normal[i]) > greatest) greatest = fabs(normal[i]);
  }
  if (!(greatest > 0.0)) return 0;
  for (i = 0; i < count; ++i) n[i] = normal[i] / greatest;
  for (i = 0; i < count; ++i) square += n[i] * n[i];
  for (i = 0; i < count; ++i) n[i] /= sqrt(square);
  return 1;
}

/* Whether the numbers of a body are finite, and mass, moment of inertia and radius not negative. */
@NAME@_FUNCTION int @name@_is_motion(double inverse_mass, double inverse_inertia, double radius, const double *velocity,
                                     const double *spin, int count, int turns)
{
  double nothing = 0.0 * inverse_mass + 0.0 * inverse_inertia + 0.0 * radius;
  int i;
  for (i = 0; i < count; ++i) nothing += 0.0 * velocity[i];
  for (i = 0; i < turns; ++i) nothing += 0.0 * spin[i];
  return inverse_mass >= 0.0 && inverse_inertia >= 0.0 && radius >= 0.0 && nothing >= 0.0;
}

/* In *normal the impulse along the normal, in *along that of friction against sliding s, over s; 0 if refused. */
@NAME@_FUNCTION int @name@_impulse(double speed, double sliding, double friction, double ratio, double mobility,
                                   double turning, double *normal, double *along)
{
  double found[4];
  @name@_at(speed, sliding, friction, ratio, found);
  *normal = (1.0 + found[0]) * speed / mobility;
  *along = fabs(sliding) > 0.0 ? (sliding - found[2]) / ((mobility + turning) * sliding) : 0.0 * found[2];
  return found[1] >= 0.0;
}

@NAME@_FUNCTION int @name@_collide_2d(@name@_body_2d *a, @name@_body_2d *b, const double *normal, double friction)
{
  const double x = a->velocity[0] - b->velocity[0], y = a->velocity[1] - b->velocity[1];
  const double mobility = a->inverse_mass + b->inverse_mass;
  const double arm_a = a->radius * a->inverse_inertia, arm_b = b->radius * b->inverse_inertia;
  double way[2], n, m, speed, sliding, push, drag;
  if (!@name@_direction(normal, 2, way) ||
      !@name@_is_motion(a->inverse_mass, a->inverse_inertia, a->radius, a->velocity, &a->spin, 2, 1) ||
      !@name@_is_motion(b->inverse_mass, b->inverse_inertia, b->radius, b->velocity, &b->spin, 2, 1)) return -1;
  n = way[0];
  m = way[1];
  speed = x * n + y * m;
  sliding = y * n - x * m + a->radius * a->spin + b->radius * b->spin;
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  if (!@name@_impulse(speed, sliding, friction, b->radius / a->radius, mobility, a->radius * arm_a + b->radius * arm_b,
                      &push, &drag)) return -1;
  drag *= sliding;
  a->velocity[0] -= a->inverse_mass * (push * n - drag * m);
  a->velocity[1] -= a->inverse_mass * (push * m + drag * n);
  b->velocity[0] += b->inverse_mass * (push * n - drag * m);
  b->velocity[1] += b->inverse_mass * (push * m + drag * n);
  a->spin -= arm_a * drag;
  b->spin -= arm_b * drag;
  return 1;
}

@NAME@_FUNCTION int @name@_collide_3d(@name@_body_3d *a, @name@_body_3d *b, const double *normal, double friction)
{
  const double x = a->velocity[0] - b->velocity[0], y = a->velocity[1] - b->velocity[1];
  const double z = a->velocity[2] - b->velocity[2];
  const double p = a->radius * a->spin[0] + b->radius * b->spin[0], q = a->radius * a->spin[1] + b->radius * b->spin[1];
  const double r = a->radius * a->spin[2] + b->radius * b->spin[2], mobility = a->inverse_mass + b->inverse_mass;
  const double arm_a = a->radius * a->inverse_inertia, arm_b = b->radius * b->inverse_inertia;
  double way[3], n, m, l, speed, u, v, w, push, drag, e, f, g;
  if (!@name@_direction(normal, 3, way) ||
      !@name@_is_motion(a->inverse_mass, a->inverse_inertia, a->radius, a->velocity, a->spin, 3, 3) ||
      !@name@_is_motion(b->inverse_mass, b->inverse_inertia, b->radius, b->velocity, b->spin, 3, 3)) return -1;
  n = way[0];
  m = way[1];
  l = way[2];
  speed = x * n + y * m + z * l;
  u = x - speed * n + (q * l - r * m);
  v = y - speed * m + (r * n - p * l);
  w = z - speed * l + (p * m - q * n);
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  if (!@name@_impulse(speed, sqrt(u * u + v * v + w * w), friction, b->radius / a->radius, mobility,
                      a->radius * arm_a + b->radius * arm_b, &push, &drag)) return -1;
  e = push * n + drag * u;
  f = push * m + drag * v;
  g = push * l + drag * w;
  a->velocity[0] -= a->inverse_mass * e;
  a->velocity[1] -= a->inverse_mass * f;
  a->velocity[2] -= a->inverse_mass * g;
  b->velocity[0] += b->inverse_mass * e;
  b->velocity[1] += b->inverse_mass * f;
  b->velocity[2] += b->inverse_mass * g;
  e = drag * (m * w - l * v);
  f = drag * (l * u - n * w);
  g = drag * (n * v - m * u);
  a->spin[0] -= arm_a * e;
  a->spin[1] -= arm_a * f;
  a->spin[2] -= arm_a * g;
  b->spin[0] -= arm_b * e;
  b->spin[1] -= arm_b * f;
  b->spin[2] -= arm_b * g;
  return 1;
}
)";

}  // namespace stoss::table
