/* Collision rule of two round elastic bodies with friction: speed v of approach along the normal, sliding s of the
 * first body's point of contact over the second's, Coulomb's friction, ratio of the second radius to the first.
 *
 *   plain_rule_restitution(v, s, friction, ratio)  of the normal velocity, error at most 0.0011
 *   plain_rule_sliding(v, s, friction, ratio)      s afterwards
 *   plain_rule_collide_2d(&a, &b, normal, friction), _3d  changes velocities and spins, with the normal from a to b,
 *                                              of any length but 0. 1: done. 0: they do not approach, and -1: the
 *                                              normal has no direction, an argument is not finite, negative, or
 *                                              none of the table (friction, ratio); then nothing changes
 *
 * Velocities are in c, spins times radii too. Errors, interpolation included, are those of
 * plain_rule_restitution_error and plain_rule_sliding_error, the latter over |v_t| + |spin R| of both + friction v: at
 * most 0.0014.
 *
 * The friction may be any.
 * The ratio does not count.
 * Speeds go from PLAIN_RULE_SLOWEST to PLAIN_RULE_FASTEST. Beyond, values are not numbers, errors HUGE_VAL.
 *
 * Where s = 0 there is no friction. |s afterwards| <= |s| and restitution <= 1: no collision gains energy.
 */
#ifndef PLAIN_RULE_RESTITUTION_TABLE
#define PLAIN_RULE_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define PLAIN_RULE_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define PLAIN_RULE_FUNCTION static inline
#else
#define PLAIN_RULE_FUNCTION static
#endif
#ifdef __cplusplus
#define PLAIN_RULE_INDEX(x) static_cast<int>(x)
#else
#define PLAIN_RULE_INDEX(x) ((int)(x))
#endif

#define PLAIN_RULE_SLOWEST 0.01
#define PLAIN_RULE_FASTEST 0.2

/* ln(speed) */
static const double plain_rule_restitution_speeds[4] = {
  -4.605170185988091, -3.912023005428146, -2.995732273553991, -1.6094379124341003
};
/* interval in which each of equal parts of it begins */
static const int plain_rule_restitution_speeds_first[5] = {
  0, 1, 2, 2, 2
};
/* ln(speed) */
static const double plain_rule_sliding_speeds[3] = {
  -4.605170185988091, -3.506557897319982, -1.6094379124341003
};
/* interval in which each of equal parts of it begins */
static const int plain_rule_sliding_speeds_first[4] = {
  0, 1, 1, 1
};
/* z */
static const double plain_rule_sliding_slips[8] = {
  -1.0, -0.5, 0.0, 0.5, 0.75, 0.8, 0.9, 1.0
};
/* interval in which each of equal parts of it begins */
static const int plain_rule_sliding_slips_first[9] = {
  0, 0, 1, 1, 2, 2, 3, 6, 6
};
/* value at each crossing, and its derivatives along the axes */
static const double plain_rule_restitution_nodes[8] = {
  0.945, -0.007213475204444827, 0.94, -0.009837716959933586, 0.9249999999999999,
  -0.02425164813614186, 0.85, -0.054101064033336095
};
/* of each cell */
static const double plain_rule_restitution_errors[3] = {
  0.0011, 0.0011, 0.0011
};
/* value at each crossing, and its derivatives along the axes */
static const double plain_rule_sliding_nodes[96] = {
  0.0, 0.0, -0.2286072469804248, 0.0043324505963729665, -0.0964493960849646, 0.0017628539790982012,
  -0.15719033735943358, 0.002718965320019838, -0.15719033735943358, 0.002718965320019838,
  0.006048313202832084, -0.0009690010259301514, -0.09040108288213253, 0.0007938529531680496,
  0.3822623906705541, -0.009468610963861718, 0.036250000000000004, -0.0022755980665671474,
  3.296934055254755, 0.005539026208732676, 0.2290000000000002, -0.0018204784532537784, 3.855,
  0.00910239226626771, 0.6145, -0.0009102392266269397, 3.8549999999999995, 0.009102392266268893,
  1.0, 0.0, 3.8550000000000013, 0.009102392266269906, 0.0, 0.0, -0.223847563515202,
  0.0068015706357273335, -0.09451270304039984, 0.0027675274287829923, -0.15420324864639737,
  0.004268539079404636, -0.15420324864639737, 0.004268539079404636, 0.0049837567680132006,
  -0.001521247335047225, -0.08952894627238664, 0.0012462800937357672, 0.371860058309038,
  -0.014864895712104184, 0.03374999999999995, -0.0035724910518860845, 3.3030192975149233,
  0.008695789409204378, 0.2270000000000001, -0.002857992841508947, 3.8649999999999993,
  0.01428996420754318, 0.6134999999999999, -0.0014289964207545413, 3.865, 0.014289964207544737, 1.0,
  0.0, 3.865000000000003, 0.014289964207546097, 0.0, 0.0, -0.18339025406080806,
  0.021325646125027554, -0.07805081216159936, 0.008677306132427214, -0.12881299458558937,
  0.0133835784046813, -0.12881299458558937, 0.0133835784046813, -0.004064972927946789,
  -0.004769719241824498, -0.08211578508954614, 0.003907586890602717, 0.28344023323615175,
  -0.04660739741150588, 0.012499999999999956, -0.01120118926019234, 3.3547438567263645,
  0.027264780100111838, 0.2100000000000002, -0.008960951408153825, 3.95, 0.04480475704076989, 0.605,
  -0.0044804757040769125, 3.95, 0.04480475704076913, 1.0, 0.0, 3.950000000000002,
  0.04480475704076913
};
/* of each cell */
static const double plain_rule_sliding_errors[14] = {
  0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135,
  0.00135, 0.00135, 0.00135
};

/* The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
 * of values a, b and slopes a', b' at its ends. */
PLAIN_RULE_FUNCTION int plain_rule_weigh(const double *x, const int *first, int last, double bins, double at, double *w)
{
  double h, t, u;
  int k;
  k = PLAIN_RULE_INDEX((at - x[0]) * bins);
  if (k < 0) k = 0;
  if (k > last) k = last;
  k = first[k];
  while (k + 1 < last && at >= x[k + 1]) ++k;
  h = x[k + 1] - x[k];
  t = (at - x[k]) / h;
  u = 1.0 - t;
  w[0] = t * t * (1.0 + 2.0 * u);
  w[1] = h * t * u * u;
  w[2] = h * t * u * t;
  return k;
}

PLAIN_RULE_FUNCTION double plain_rule_sum_1(const double *a, int next, const double *w)
{
  const double *b = a + next;
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

PLAIN_RULE_FUNCTION double plain_rule_sum_2(const double *a, int next, int line, const double *w, const double *y)
{
  const double *b = a + line;
  const double begin = plain_rule_sum_1(a, next, w), end = plain_rule_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * plain_rule_sum_1(a + 2, next, w) - y[2] * plain_rule_sum_1(b + 2, next, w);
}

PLAIN_RULE_FUNCTION void plain_rule_look_up(double x, double z, double p, double *found)
{
  double w[3][3];
  int k[3];
  k[0] = plain_rule_weigh(plain_rule_restitution_speeds, plain_rule_restitution_speeds_first, 3, 1.0014246020860023, x, w[0]);
  k[1] = plain_rule_weigh(plain_rule_sliding_speeds, plain_rule_sliding_speeds_first, 2, 0.6676164013906682, x, w[1]);
  k[2] = plain_rule_weigh(plain_rule_sliding_slips, plain_rule_sliding_slips_first, 7, 3.5, z, w[2]);
  found[0] = plain_rule_sum_1(plain_rule_restitution_nodes + (k[0] * 2), 2, w[0]);
  found[1] = plain_rule_restitution_errors[k[0] * 1];
  found[2] = plain_rule_sum_2(plain_rule_sliding_nodes + (k[1] * 32 + k[2] * 4), 32, 4, w[1], w[2]);
  found[3] = plain_rule_sliding_errors[k[1] * 7 + k[2] * 1];
  (void)z;
  (void)p;
}

/* Restitution, its error, sliding after, its error; what is not a number where the table says nothing. */
PLAIN_RULE_FUNCTION void plain_rule_at(double speed, double sliding, double friction, double ratio, double *found)
{
  const double s = fabs(sliding), limit = friction * fabs(speed), scale = s + limit;
  double v = fabs(speed), p = 0.0, after;
  int inside, i;
  for (i = 0; i < 4; ++i) found[i] = HUGE_VAL - HUGE_VAL;
  (void)ratio;
  if (!(v < HUGE_VAL && s < HUGE_VAL && friction >= 0.0 && friction < HUGE_VAL)) return;
  inside = v >= PLAIN_RULE_SLOWEST && v <= PLAIN_RULE_FASTEST;
  if (!inside) {
    found[1] = found[3] = HUGE_VAL;
    return;
  }
  plain_rule_look_up(log(v), scale > 0.0 ? (s - limit) / scale : -1.0, p, found);
  if (found[0] < 0.0) found[0] = 0.0;
  if (found[0] > 1.0) found[0] = 1.0;
  after = found[2] * scale;
  if (after < -s) after = -s;
  if (after > s) after = s;
  found[2] = sliding < 0.0 ? -after : after;
  if (!inside) found[1] = found[3] = HUGE_VAL;
}

PLAIN_RULE_FUNCTION double plain_rule_restitution(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[0];
}

PLAIN_RULE_FUNCTION double plain_rule_restitution_error(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[1];
}

PLAIN_RULE_FUNCTION double plain_rule_sliding(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[2];
}

PLAIN_RULE_FUNCTION double plain_rule_sliding_error(double speed, double sliding, double friction, double ratio)
{
  double found[4];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[3];
}

/* A round body: inverse_mass 0 does not move, inverse_inertia 0 does not turn. */
typedef struct {
  double inverse_mass, inverse_inertia, radius;
  double velocity[2], spin; /* spin from x to y */
} plain_rule_body_2d;

typedef struct {
  double inverse_mass, inverse_inertia, radius;
  double velocity[3], spin[3];
} plain_rule_body_3d;

/* The normal at length 1, from one of any length; 0 if it has no direction. */
PLAIN_RULE_FUNCTION int plain_rule_direction(const double *normal, int count, double *n)
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
PLAIN_RULE_FUNCTION int plain_rule_is_motion(double inverse_mass, double inverse_inertia, double radius, const double *velocity,
                                     const double *spin, int count, int turns)
{
  double nothing = 0.0 * inverse_mass + 0.0 * inverse_inertia + 0.0 * radius;
  int i;
  for (i = 0; i < count; ++i) nothing += 0.0 * velocity[i];
  for (i = 0; i < turns; ++i) nothing += 0.0 * spin[i];
  return inverse_mass >= 0.0 && inverse_inertia >= 0.0 && radius >= 0.0 && nothing >= 0.0;
}

/* In *normal the impulse along the normal, in *along that of friction against sliding s, over s; 0 if refused. */
PLAIN_RULE_FUNCTION int plain_rule_impulse(double speed, double sliding, double friction, double ratio, double mobility,
                                   double turning, double *normal, double *along)
{
  double found[4];
  plain_rule_at(speed, sliding, friction, ratio, found);
  *normal = (1.0 + found[0]) * speed / mobility;
  *along = fabs(sliding) > 0.0 ? (sliding - found[2]) / ((mobility + turning) * sliding) : 0.0 * found[2];
  return found[1] >= 0.0;
}

PLAIN_RULE_FUNCTION int plain_rule_collide_2d(plain_rule_body_2d *a, plain_rule_body_2d *b, const double *normal, double friction)
{
  const double x = a->velocity[0] - b->velocity[0], y = a->velocity[1] - b->velocity[1];
  const double mobility = a->inverse_mass + b->inverse_mass;
  const double arm_a = a->radius * a->inverse_inertia, arm_b = b->radius * b->inverse_inertia;
  double way[2], n, m, speed, sliding, push, drag;
  if (!plain_rule_direction(normal, 2, way) ||
      !plain_rule_is_motion(a->inverse_mass, a->inverse_inertia, a->radius, a->velocity, &a->spin, 2, 1) ||
      !plain_rule_is_motion(b->inverse_mass, b->inverse_inertia, b->radius, b->velocity, &b->spin, 2, 1)) return -1;
  n = way[0];
  m = way[1];
  speed = x * n + y * m;
  sliding = y * n - x * m + a->radius * a->spin + b->radius * b->spin;
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  if (!plain_rule_impulse(speed, sliding, friction, b->radius / a->radius, mobility, a->radius * arm_a + b->radius * arm_b,
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

PLAIN_RULE_FUNCTION int plain_rule_collide_3d(plain_rule_body_3d *a, plain_rule_body_3d *b, const double *normal, double friction)
{
  const double x = a->velocity[0] - b->velocity[0], y = a->velocity[1] - b->velocity[1];
  const double z = a->velocity[2] - b->velocity[2];
  const double p = a->radius * a->spin[0] + b->radius * b->spin[0], q = a->radius * a->spin[1] + b->radius * b->spin[1];
  const double r = a->radius * a->spin[2] + b->radius * b->spin[2], mobility = a->inverse_mass + b->inverse_mass;
  const double arm_a = a->radius * a->inverse_inertia, arm_b = b->radius * b->inverse_inertia;
  double way[3], n, m, l, speed, u, v, w, push, drag, e, f, g;
  if (!plain_rule_direction(normal, 3, way) ||
      !plain_rule_is_motion(a->inverse_mass, a->inverse_inertia, a->radius, a->velocity, a->spin, 3, 3) ||
      !plain_rule_is_motion(b->inverse_mass, b->inverse_inertia, b->radius, b->velocity, b->spin, 3, 3)) return -1;
  n = way[0];
  m = way[1];
  l = way[2];
  speed = x * n + y * m + z * l;
  u = x - speed * n + (q * l - r * m);
  v = y - speed * m + (r * n - p * l);
  w = z - speed * l + (p * m - q * n);
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  if (!plain_rule_impulse(speed, sqrt(u * u + v * v + w * w), friction, b->radius / a->radius, mobility,
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

#undef PLAIN_RULE_FUNCTION
#undef PLAIN_RULE_INDEX

#endif
