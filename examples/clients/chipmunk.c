/*
 * A disk falls on the floor in Chipmunk 7 and leaves with the coefficient of restitution of its speed.
 *
 *   stoss table --body disk --poisson 0.4 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format c
 *       -o restitution.h
 *   cc chipmunk.c -lchipmunk -lm && ./a.out
 *
 * Copy speed_of_approach, before_solve and how `drop` names it. Chipmunk multiplies the relative velocity that bodies
 * have in preSolve, before gravity acts in this step. It has no threshold, and what pushes bodies apart does not enter
 * their velocities: the ratio of the speeds is that of the table to rounding. Units are m, kg, s.
 */
#include <chipmunk/chipmunk.h>
#include <math.h>
#include <stdio.h>

#include "restitution.h"

static double speed_of_approach(const cpArbiter* arbiter) {
  cpBody *a, *b;
  cpVect point, velocity;
  cpArbiterGetBodies(arbiter, &a, &b);
  point = cpArbiterGetPointA(arbiter, 0);
  velocity = cpvsub(cpBodyGetVelocityAtWorldPoint(a, point), cpBodyGetVelocityAtWorldPoint(b, point));
  return cpvdot(velocity, cpArbiterGetNormal(arbiter)); /* the normal points from a to b */
}

/* What this example looks at: the speeds before and after the first impact. */
struct Impact {
  double before, after;
};

static cpBool before_solve(cpArbiter* arbiter, cpSpace* space, cpDataPointer data) {
  struct Impact* impact = (struct Impact*)data;
  const double speed = speed_of_approach(arbiter);
  (void)space;
  if (speed > 0.0) {
    cpArbiterSetRestitution(arbiter, stoss_restitution(speed));
    if (impact->before == 0.0) impact->before = speed;
  }
  return cpTrue;
}

static void after_solve(cpArbiter* arbiter, cpSpace* space, cpDataPointer data) {
  struct Impact* impact = (struct Impact*)data;
  (void)space;
  if (impact->after == 0.0) impact->after = -speed_of_approach(arbiter);
}

/* Drops a disk, thrown down with a speed from five steps above the floor. */
static struct Impact drop(double speed, double step) {
  const double radius = 0.1, mass = 31.4;
  struct Impact impact = {0.0, 0.0};
  cpSpace* space = cpSpaceNew();
  cpShape* floor = cpSegmentShapeNew(cpSpaceGetStaticBody(space), cpv(-1.0, -1.0), cpv(1.0, -1.0), 1.0);
  cpBody* body = cpBodyNew(mass, cpMomentForCircle(mass, 0.0, radius, cpvzero));
  cpShape* disk = cpCircleShapeNew(body, radius, cpvzero);
  cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space);
  int i;
  handler->preSolveFunc = before_solve;
  handler->postSolveFunc = after_solve;
  handler->userData = &impact;
  cpSpaceSetGravity(space, cpv(0.0, -9.81));
  cpSpaceAddShape(space, floor);
  cpSpaceAddBody(space, body);
  cpSpaceAddShape(space, disk);
  cpBodySetPosition(body, cpv(0.0, radius + 5.3 * step * speed));
  cpBodySetVelocity(body, cpv(0.0, -speed));
  for (i = 0; i < 20 && impact.after == 0.0; ++i) cpSpaceStep(space, step);
  cpSpaceRemoveShape(space, disk);
  cpSpaceRemoveBody(space, body);
  cpSpaceRemoveShape(space, floor);
  cpShapeFree(disk);
  cpBodyFree(body);
  cpShapeFree(floor);
  cpSpaceFree(space);
  return impact;
}

int main(void) {
  const double speeds[] = {0.02, 0.1, 0.5, 2.0, 8.0}, steps[] = {1e-3, 1.0 / 60.0}, accuracy = 1e-12;
  int i, wrong = 0;
  printf(" step/s  before/(m/s)  after/before  eps of the table +- its error  difference\n");
  for (i = 0; i < 10; ++i) {
    const struct Impact impact = drop(speeds[i / 2], steps[i % 2]);
    const double found = impact.after / impact.before, wanted = stoss_restitution(impact.before);
    printf("%7.5f %13.7f %13.9f %17.9f +- %.5f %11.1e\n", steps[i % 2], impact.before, found, wanted,
           stoss_restitution_error(impact.before), found - wanted);
    if (!(fabs(found - wanted) <= accuracy)) wrong = 1;
  }
  return wrong;
}
