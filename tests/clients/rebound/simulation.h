// What REBOUND 4 and 5 have in common, for 4/rebound.h and 5/rebound.h, which define the types stub_*. REBOUND is not
// shipped: names and types are those of its header, what they do is written anew, for free flight and hard spheres
// only.
#ifndef STOSS_TESTS_REBOUND_SIMULATION_H
#define STOSS_TESTS_REBOUND_SIMULATION_H

#include <math.h>
#include <stdlib.h>

struct reb_particle {
  double x, y, z, vx, vy, vz, ax, ay, az, m, r;
};

struct reb_collision {
  stub_index p1, p2;
};

enum { REB_GRAVITY_NONE = 0, REB_GRAVITY_BASIC = 1 };
enum { REB_COLLISION_NONE = 0, REB_COLLISION_DIRECT = 1 };
enum REB_COLLISION_RESOLVE_OUTCOME { REB_COLLISION_RESOLVE_OUTCOME_REMOVE_NONE = 0 };

struct reb_simulation {
  double t, dt, minimum_collision_velocity;
  stub_count N;
  struct reb_particle particles[8];
  stub_integrator integrator;
  int gravity, collision;
  enum REB_COLLISION_RESOLVE_OUTCOME (*collision_resolve)(struct reb_simulation* const r, struct reb_collision c);
  double (*coefficient_of_restitution)(const struct reb_simulation* const r, double v);
};

static inline struct reb_simulation* reb_simulation_create(void) {
  struct reb_simulation* r = (struct reb_simulation*)calloc(1, sizeof(struct reb_simulation));
  r->gravity = REB_GRAVITY_BASIC;
  return r;
}

static inline void reb_simulation_free(struct reb_simulation* const r) { free(r); }

static inline void reb_simulation_add(struct reb_simulation* const r, struct reb_particle pt) {
  r->particles[r->N++] = pt;
}

/// Exchanges momentum along the line of centres of two particles that overlap and approach; the callback gets their
/// relative velocity along it, which is negative.
static inline enum REB_COLLISION_RESOLVE_OUTCOME reb_collision_resolve_hardsphere(struct reb_simulation* const r,
                                                                                  struct reb_collision c) {
  struct reb_particle *a = &r->particles[c.p1], *b = &r->particles[c.p2];
  const double x = a->x - b->x, y = a->y - b->y, z = a->z - b->z;
  const double distance = sqrt(x * x + y * y + z * z);
  const double v = ((a->vx - b->vx) * x + (a->vy - b->vy) * y + (a->vz - b->vz) * z) / distance;
  if (distance > a->r + b->r || v >= 0.0) return REB_COLLISION_RESOLVE_OUTCOME_REMOVE_NONE;
  const double eps = r->coefficient_of_restitution ? r->coefficient_of_restitution(r, v) : 1.0;
  const double momentum = -(1.0 + eps) * v * a->m * b->m / (a->m + b->m) / distance;
  a->vx += momentum * x / a->m;
  a->vy += momentum * y / a->m;
  a->vz += momentum * z / a->m;
  b->vx -= momentum * x / b->m;
  b->vy -= momentum * y / b->m;
  b->vz -= momentum * z / b->m;
  return REB_COLLISION_RESOLVE_OUTCOME_REMOVE_NONE;
}

/// Leaves the particles where they are unless they are to fly freely, step by step, and to collide.
static inline void reb_simulation_integrate(struct reb_simulation* const r, double tmax) {
  if (!stub_is_leapfrog(r->integrator) || r->gravity != REB_GRAVITY_NONE || r->collision != REB_COLLISION_DIRECT)
    return;
  while (r->t < tmax) {
    for (stub_count i = 0; i < r->N; ++i) {
      struct reb_particle* p = &r->particles[i];
      p->x += r->dt * p->vx;
      p->y += r->dt * p->vy;
      p->z += r->dt * p->vz;
    }
    for (stub_count i = 0; i < r->N; ++i) {
      for (stub_count j = i + 1; j < r->N; ++j) {
        r->collision_resolve(r, (struct reb_collision){(stub_index)i, (stub_index)j});
      }
    }
    r->t += r->dt;
  }
}

#endif
