// What examples/clients/rebound.c names of REBOUND 4, which is not shipped: names and types are those of its header,
// what they do is written anew, for free flight and hard spheres only.
#ifndef STOSS_TESTS_REBOUND_H
#define STOSS_TESTS_REBOUND_H

#include <math.h>
#include <stdlib.h>

struct reb_particle {
  double x, y, z, vx, vy, vz, ax, ay, az, m, r;
};

struct reb_collision {
  int p1, p2;
};

enum { REB_INTEGRATOR_LEAPFROG = 4, REB_GRAVITY_NONE = 0, REB_COLLISION_DIRECT = 1 };

struct reb_simulation {
  double t, dt, minimum_collision_velocity;
  unsigned int N;
  struct reb_particle particles[8];
  int integrator, gravity, collision;
  int (*collision_resolve)(struct reb_simulation* const r, struct reb_collision c);
  double (*coefficient_of_restitution)(const struct reb_simulation* const r, double v);
};

static inline struct reb_simulation* reb_simulation_create(void) {
  return (struct reb_simulation*)calloc(1, sizeof(struct reb_simulation));
}

static inline void reb_simulation_free(struct reb_simulation* const r) { free(r); }

static inline void reb_simulation_add(struct reb_simulation* const r, struct reb_particle pt) {
  r->particles[r->N++] = pt;
}

/// Exchanges momentum along the line of centres of two particles that overlap and approach; the callback gets their
/// relative velocity along it, which is negative.
static inline int reb_collision_resolve_hardsphere(struct reb_simulation* const r, struct reb_collision c) {
  struct reb_particle *a = &r->particles[c.p1], *b = &r->particles[c.p2];
  const double x = a->x - b->x, y = a->y - b->y, z = a->z - b->z;
  const double distance = sqrt(x * x + y * y + z * z);
  const double v = ((a->vx - b->vx) * x + (a->vy - b->vy) * y + (a->vz - b->vz) * z) / distance;
  if (distance > a->r + b->r || v >= 0.0) return 0;
  const double eps = r->coefficient_of_restitution ? r->coefficient_of_restitution(r, v) : 1.0;
  const double momentum = -(1.0 + eps) * v * a->m * b->m / (a->m + b->m) / distance;
  a->vx += momentum * x / a->m;
  a->vy += momentum * y / a->m;
  a->vz += momentum * z / a->m;
  b->vx -= momentum * x / b->m;
  b->vy -= momentum * y / b->m;
  b->vz -= momentum * z / b->m;
  return 0;
}

static inline void reb_simulation_integrate(struct reb_simulation* const r, double tmax) {
  while (r->t < tmax) {
    for (unsigned int i = 0; i < r->N; ++i) {
      struct reb_particle* p = &r->particles[i];
      p->x += r->dt * p->vx;
      p->y += r->dt * p->vy;
      p->z += r->dt * p->vz;
    }
    for (unsigned int i = 0; i < r->N; ++i) {
      for (unsigned int j = i + 1; j < r->N; ++j) {
        r->collision_resolve(r, (struct reb_collision){(int)i, (int)j});
      }
    }
    r->t += r->dt;
  }
}

#endif
