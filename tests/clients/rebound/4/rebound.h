// What examples/clients/rebound.c names of REBOUND 4.
#ifndef STOSS_TESTS_REBOUND_H
#define STOSS_TESTS_REBOUND_H

enum { REB_INTEGRATOR_IAS15 = 0, REB_INTEGRATOR_LEAPFROG = 4 };
typedef int stub_integrator;
typedef int stub_index;
typedef unsigned int stub_count;

static inline int stub_is_leapfrog(stub_integrator integrator) { return integrator == REB_INTEGRATOR_LEAPFROG; }

#include "../simulation.h"

#endif
