/*
 * Two spheres of ice meet off-centre in REBOUND 4 or 5, with friction, and leave with the velocities and spins of the
 * collision rule. REBOUND has no spins: they are in an array beside its particles.
 *
 *   stoss table --body sphere --poisson 0.33 --young 9.5e9 --density 917 --radius 1 --against same --speed 1e-2:10
 *       --oblique -o rule.h
 *   cc rebound_spin.c -lrebound -lm && ./a.out
 *
 * Copy collision_resolve. It takes the place of reb_collision_resolve_hardsphere and of its callback. In a periodic or
 * shearing box add to the position and the velocity of the first particle those of the ghost box, c.gb. A particle that
 * is removed or sorted moves in its array: spins must follow. Units are m, kg, s: for others, convert velocities.
 */
#include <math.h>
#include <rebound.h>
#include <stdio.h>

#include "rule.h"

static const double friction = 0.3;
static double spin[2][3]; /* rad/s, of each particle */

static stoss_rule_body_3d body_of(const struct reb_particle* p, const double* own_spin) {
  stoss_rule_body_3d body;
  int i;
  body.inverse_mass = 1.0 / p->m;
  body.inverse_inertia = 2.5 / (p->m * p->r * p->r);
  body.radius = p->r;
  body.velocity[0] = p->vx;
  body.velocity[1] = p->vy;
  body.velocity[2] = p->vz;
  for (i = 0; i < 3; ++i) body.spin[i] = own_spin[i];
  return body;
}

static void set(struct reb_particle* p, double* own_spin, const stoss_rule_body_3d* body) {
  int i;
  p->vx = body->velocity[0];
  p->vy = body->velocity[1];
  p->vz = body->velocity[2];
  for (i = 0; i < 3; ++i) own_spin[i] = body->spin[i];
}

static enum REB_COLLISION_RESOLVE_OUTCOME collision_resolve(struct reb_simulation* const r, struct reb_collision c) {
  struct reb_particle *p = &r->particles[c.p1], *q = &r->particles[c.p2];
  const double normal[3] = {q->x - p->x, q->y - p->y, q->z - p->z};
  const double reach = p->r + q->r;
  stoss_rule_body_3d a = body_of(p, spin[c.p1]), b = body_of(q, spin[c.p2]);
  if (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] > reach * reach)
    return REB_COLLISION_RESOLVE_OUTCOME_REMOVE_NONE;
  if (stoss_rule_collide_3d(&a, &b, normal, friction) > 0) {
    set(p, spin[c.p1], &a);
    set(q, spin[c.p2], &b);
  }
  return REB_COLLISION_RESOLVE_OUTCOME_REMOVE_NONE;
}

static void use_leapfrog(struct reb_simulation* r) {
#ifdef REB_BUILTIN_INTEGRATORS /* since REBOUND 5 */
  reb_simulation_set_integrator(r, "leapfrog");
#else
  r->integrator = REB_INTEGRATOR_LEAPFROG;
#endif
}

/* Two equal spheres meet at a speed, whose centres pass each other at an offset; returns their motion afterwards. */
static void meet(double speed, double offset, struct reb_particle after[2]) {
  struct reb_simulation* r = reb_simulation_create();
  struct reb_particle first = {0}, second = {0};
  use_leapfrog(r);
  r->gravity = REB_GRAVITY_NONE;
  r->collision = REB_COLLISION_DIRECT;
  r->collision_resolve = collision_resolve;
  r->dt = 1e-4 / speed;
  first.m = second.m = 3841.0;
  first.r = second.r = 1.0;
  first.x = -1.05;
  first.vx = 0.5 * speed;
  second.x = 1.05;
  second.y = offset;
  second.vx = -0.5 * speed;
  reb_simulation_add(r, first);
  reb_simulation_add(r, second);
  reb_simulation_integrate(r, 2.0 / speed);
  after[0] = r->particles[0];
  after[1] = r->particles[1];
  reb_simulation_free(r);
}

/* About the z axis, of both: of the orbits at their places, and of the spins. */
static double angular_momentum(const struct reb_particle p[2]) {
  double sum = 0.0;
  int k;
  for (k = 0; k < 2; ++k) sum += p[k].m * (p[k].x * p[k].vy - p[k].y * p[k].vx + 0.4 * spin[k][2]);
  return sum;
}

int main(void) {
  const double offsets[] = {0.0, 0.3, 1.0, 1.8}, speed = 0.5;
  int i, wrong = 0;
  printf("offset/m  spin after/(rad/s)  energy after/before  angular momentum after/before\n");
  for (i = 0; i < 4; ++i) {
    struct reb_particle after[2];
    const double m = 3841.0, before = 0.25 * m * speed * speed, turning = 0.5 * m * speed * offsets[i];
    double energy = 0.0, left;
    int k;
    spin[0][2] = spin[1][2] = 0.0;
    meet(speed, offsets[i], after);
    for (k = 0; k < 2; ++k)
      energy += 0.5 * m * (after[k].vx * after[k].vx + after[k].vy * after[k].vy + 0.4 * spin[k][2] * spin[k][2]);
    left = turning > 0.0 ? angular_momentum(after) / turning : 1.0;
    printf("%8.1f %19.6f %20.6f %30.6f\n", offsets[i], spin[0][2], energy / before, left);
    /* They meet when they overlap a little, so their centres are nearer than two radii. */
    if (!(energy <= before && fabs(left - 1.0) < 1e-3 && fabs(spin[0][2] - spin[1][2]) <= 1e-12)) wrong = 1;
    if (offsets[i] > 0.0 && !(spin[0][2] * offsets[i] > 0.0)) wrong = 1;
  }
  return wrong;
}
