// What examples/clients/rebound.c names of REBOUND 5.
#ifndef STOSS_TESTS_REBOUND_H
#define STOSS_TESTS_REBOUND_H

#include <stdlib.h>
#include <string.h>

#define REB_BUILTIN_INTEGRATORS X(ias15) X(leapfrog)

struct reb_integrator_configuration {
  const char* name;
};
typedef struct reb_integrator_configuration stub_integrator;
typedef size_t stub_index;
typedef size_t stub_count;

static inline int stub_is_leapfrog(stub_integrator integrator) {
  return integrator.name && strcmp(integrator.name, "leapfrog") == 0;
}

#include "../simulation.h"

static inline void* reb_simulation_set_integrator(struct reb_simulation* r, const char* name) {
  r->integrator.name = name;
  return NULL;
}

#endif
