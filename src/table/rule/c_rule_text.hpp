#pragma once

#include <string_view>

namespace stoss::table {

/// Sums of a cubic along one, two and three axes, as numeric::CubicGrid has them.
inline constexpr std::string_view c_cubic_functions = R"(
/* Of values and slopes at both ends of interval k of the places x, in the cubic between them. */
@NAME@_FUNCTION void @name@_weigh(const double *x, int k, double at, double *w)
{
  const double h = x[k + 1] - x[k], t = (at - x[k]) / h, u = 1.0 - t;
  w[0] = (1.0 + 2.0 * t) * u * u;
  w[1] = t * t * (1.0 + 2.0 * u);
  w[2] = h * t * u * u;
  w[3] = -h * t * t * u;
}

@NAME@_FUNCTION double @name@_sum_1(const double *a, const int *next, const double *w)
{
  const double *b = a + next[0];
  return w[0] * a[0] + w[1] * b[0] + w[2] * a[1] + w[3] * b[1];
}

@NAME@_FUNCTION double @name@_sum_2(const double *a, const int *next, const double *w)
{
  const double *b = a + next[1];
  return w[4] * @name@_sum_1(a, next, w) + w[5] * @name@_sum_1(b, next, w) +
         w[6] * @name@_sum_1(a + 2, next, w) + w[7] * @name@_sum_1(b + 2, next, w);
}

@NAME@_FUNCTION double @name@_sum_3(const double *a, const int *next, const double *w)
{
  const double *b = a + next[2];
  return w[8] * @name@_sum_2(a, next, w) + w[9] * @name@_sum_2(b, next, w) +
         w[10] * @name@_sum_2(a + 4, next, w) + w[11] * @name@_sum_2(b + 4, next, w);
}
)";

/// The rule at any arguments, as RuleTable::unchecked has it, and each of its numbers.
inline constexpr std::string_view c_rule_functions = R"(
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
@outside@    if (v < @NAME@_SLOWEST) v = @NAME@_SLOWEST;
  }
  @name@_look_up(log(v), scale > 0.0 ? (s - limit) / scale : -1.0, p, found);
  if (found[0] < 0.0) found[0] = 0.0;
  if (found[0] > 1.0) found[0] = 1.0;
  after = found[2] * scale;
  if (after < -s) after = -s;
  if (after > s) after = s;
  found[2] = sliding < 0.0 ? -after : after;
  if (!inside) found[1] = found[3] = HUGE_VAL;
}

@NAME@_FUNCTION double @name@_restitution(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  @name@_at(speed, sliding, friction, ratio, found);
  return found[0];
}

@NAME@_FUNCTION double @name@_restitution_error(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  @name@_at(speed, sliding, friction, ratio, found);
  return found[1];
}

@NAME@_FUNCTION double @name@_sliding(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  @name@_at(speed, sliding, friction, ratio, found);
  return found[2];
}

@NAME@_FUNCTION double @name@_sliding_error(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  @name@_at(speed, sliding, friction, ratio, found);
  return found[3];
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

/* The impulse of friction against sliding s, over s, and in *normal that along the normal. */
@NAME@_FUNCTION double @name@_impulse(double speed, double sliding, double friction, double ratio, double mobility,
                                      double turning, double *normal)
{
  double found[4];
  @name@_at(speed, sliding, friction, ratio, found);
  *normal = (1.0 + found[0]) * speed / mobility;
  return fabs(sliding) > 0.0 ? (sliding - found[2]) / ((mobility + turning) * sliding) : 0.0 * found[2];
}

@NAME@_FUNCTION int @name@_collide_2d(@name@_body_2d *a, @name@_body_2d *b, const double *normal, double friction)
{
  const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1]);
  const double n = normal[0] / length, m = normal[1] / length;
  const double x = a->velocity[0] - b->velocity[0], y = a->velocity[1] - b->velocity[1];
  const double speed = x * n + y * m, mobility = a->inverse_mass + b->inverse_mass;
  const double arm_a = a->radius * a->inverse_inertia, arm_b = b->radius * b->inverse_inertia;
  const double sliding = y * n - x * m + a->radius * a->spin + b->radius * b->spin;
  double push, drag;
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  drag = sliding * @name@_impulse(speed, sliding, friction, b->radius / a->radius, mobility,
                                  a->radius * arm_a + b->radius * arm_b, &push);
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
  const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  const double mobility = a->inverse_mass + b->inverse_mass;
  const double arm_a = a->radius * a->inverse_inertia, arm_b = b->radius * b->inverse_inertia;
  double n[3], u[3], s[3], turn[3], speed = 0.0, sliding, push, drag;
  int i;
  for (i = 0; i < 3; ++i) {
    n[i] = normal[i] / length;
    u[i] = a->velocity[i] - b->velocity[i];
    turn[i] = a->radius * a->spin[i] + b->radius * b->spin[i];
    speed += u[i] * n[i];
  }
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  for (i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    s[i] = u[i] - speed * n[i] + (turn[j] * n[k] - turn[k] * n[j]);
  }
  sliding = sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
  drag = @name@_impulse(speed, sliding, friction, b->radius / a->radius, mobility,
                        a->radius * arm_a + b->radius * arm_b, &push);
  for (i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double impulse = push * n[i] + drag * s[i], moment = drag * (n[j] * s[k] - n[k] * s[j]);
    a->velocity[i] -= a->inverse_mass * impulse;
    b->velocity[i] += b->inverse_mass * impulse;
    a->spin[i] -= arm_a * moment;
    b->spin[i] -= arm_b * moment;
  }
  return 1;
}
)";

}  // namespace stoss::table
