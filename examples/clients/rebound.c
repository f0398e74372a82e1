/*
 * Two spheres of ice meet in REBOUND 4 or 5 and leave with the coefficient of restitution of their speed.
 *
 *   stoss table --body sphere --poisson 0.33 --young 9.5e9 --density 917 --radius 1 --loss-time 1e-4 --against same
 *       --speed 1e-3:10 --format c -o restitution.h
 *   cc rebound.c -lrebound -lm && ./a.out
 *
 * Copy the callback. REBOUND hands over the relative velocity along the line of centres, negative when the particles
 * approach; a table does not look at its sign. minimum_collision_velocity, if it is set, keeps the change of that
 * velocity above a floor, whatever the callback says. Units are m, kg, s: for others, convert v.
 */
#include <math.h>
#include <rebound.h>
#include <stdio.h>

#include "restitution.h"

static double coefficient_of_restitution(const struct reb_simulation* const r, double v) {
  (void)r;
  return stoss_restitution(v);
}

static void use_leapfrog(struct reb_simulation* r) {
#ifdef REB_BUILTIN_INTEGRATORS /* since REBOUND 5 */
  reb_simulation_set_integrator(r, "leapfrog");
#else
  r->integrator = REB_INTEGRATOR_LEAPFROG;
#endif
}

/* How fast two equal spheres separate that meet head-on. */
static double speed_after(double speed) {
  struct reb_simulation* r = reb_simulation_create();
  struct reb_particle first = {0}, second = {0};
  double after;
  use_leapfrog(r);
  r->gravity = REB_GRAVITY_NONE;
  r->collision = REB_COLLISION_DIRECT;
  r->collision_resolve = reb_collision_resolve_hardsphere;
  r->coefficient_of_restitution = coefficient_of_restitution;
  r->dt = 0.01 / speed;
  first.m = second.m = 3841.0;
  first.r = second.r = 1.0;
  first.x = -1.05;
  first.vx = 0.5 * speed;
  second.x = 1.05;
  second.vx = -0.5 * speed;
  reb_simulation_add(r, first);
  reb_simulation_add(r, second);
  reb_simulation_integrate(r, 0.3 / speed);
  after = r->particles[1].vx - r->particles[0].vx;
  reb_simulation_free(r);
  return after;
}

int main(void) {
  const double speeds[] = {0.005, 0.05, 0.5, 5.0}, accuracy = 1e-12;
  int i, wrong = 0;
  printf("speed/(m/s)  after/before  eps of the table +- its error  difference\n");
  for (i = 0; i < 4; ++i) {
    const double found = speed_after(speeds[i]) / speeds[i], wanted = stoss_restitution(speeds[i]);
    printf("%11.3f %13.9f %17.9f +- %.5f %11.1e\n", speeds[i], found, wanted, stoss_restitution_error(speeds[i]),
           found - wanted);
    if (!(fabs(found - wanted) <= accuracy)) wrong = 1;
  }
  return wrong;
}
