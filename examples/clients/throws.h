/* What chipmunk_spin.c, box2d_spin.cpp and bullet_spin.cpp throw on a floor, and how they say what became of it. */
#ifndef STOSS_EXAMPLE_THROWS
#define STOSS_EXAMPLE_THROWS

#include <math.h>
#include <stdio.h>

/* In m/s; rim is the spin times the radius. With friction 0.3 these slide throughout, stick, or turn back. */
struct Throw {
  double down, along, rim;
};

enum { throw_count = 8 };
static const struct Throw throws[throw_count] = {
    {0.3, 0.0, 0.0}, {0.3, 0.05, 0.0}, {0.4, 0.3, 0.0},  {0.8, 3.0, 0.0},
    {0.3, 0.0, 0.4}, {0.5, 0.2, -0.7}, {0.8, -0.3, 0.2}, {0.9, 0.4, 2.0},
};

/* Prints the greatest difference of `count` velocities, spins times radius among them; returns 1 where it is too much.
 */
static int compare(const struct Throw* thrown, double step, const double* found, const double* wanted, int count,
                   double accuracy) {
  double most = 0.0;
  int i;
  for (i = 0; i < count; ++i) {
    const double difference = fabs(found[i] - wanted[i]);
    if (!(difference <= most)) most = difference; /* also what is not a number */
  }
  printf("%7.5f %6.2f %6.2f %6.2f  ", step, thrown->down, thrown->along, thrown->rim);
  for (i = 0; i < count; ++i) printf(" %10.6f", found[i]);
  printf("  %8.1e\n", most);
  return !(most <= accuracy);
}

#endif
