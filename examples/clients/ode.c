/*
 * A ball falls on the floor in the Open Dynamics Engine and leaves with the coefficient of restitution of its speed.
 *
 *   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format c
 *       -o restitution.h
 *   cc ode.c $(pkg-config --cflags --libs ode) -lm && ./a.out
 *
 * Copy speed_of_approach and near. ODE multiplies the relative velocity that bodies have in the callback, before
 * gravity acts in this step. What pushes bodies apart takes the place of the bounce where it is faster, which it is at
 * rest only. bounce_vel is a threshold: 0 lets slow bodies bounce. Contacts are a little soft, which takes 1e-6 of the
 * speed here, unless soft_cfm is 0. The ratio of the speeds is then that of the table to rounding. Units are m, kg, s.
 */
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>

#include "restitution.h"

static dWorldID world;
static dJointGroupID contacts;
static double before; /* of the first impact, for this example */

/* The velocity of a body, or of what has none, along a normal at a point. */
static double along(dBodyID body, const dReal* point, const dReal* normal) {
  dVector3 velocity = {0.0, 0.0, 0.0, 0.0};
  if (body) dBodyGetPointVel(body, point[0], point[1], point[2], velocity);
  return velocity[0] * normal[0] + velocity[1] * normal[1] + velocity[2] * normal[2];
}

static double speed_of_approach(dBodyID a, dBodyID b, const dContactGeom* geom) { /* the normal points from b to a */
  return along(b, geom->pos, geom->normal) - along(a, geom->pos, geom->normal);
}

static void near(void* data, dGeomID first, dGeomID second) {
  dContact contact[4];
  dBodyID a = dGeomGetBody(first), b = dGeomGetBody(second);
  const int count = dCollide(first, second, 4, &contact[0].geom, sizeof(dContact));
  int i;
  (void)data;
  for (i = 0; i < count; ++i) {
    const double speed = speed_of_approach(a, b, &contact[i].geom);
    contact[i].surface.mode = dContactBounce | dContactSoftCFM;
    contact[i].surface.mu = 0.0; /* yours */
    contact[i].surface.bounce = stoss_restitution(speed > 0.0 ? speed : 0.0);
    contact[i].surface.bounce_vel = 0.0;
    contact[i].surface.soft_cfm = 0.0;
    dJointAttach(dJointCreateContact(world, contacts, &contact[i]), a, b);
    if (before == 0.0 && speed > 0.0) before = speed;
  }
}

/* Drops a ball, thrown down with a speed from five steps above the floor; returns how fast it leaves. */
static double drop(double speed, double step) {
  const double radius = 0.1;
  dSpaceID space = dSimpleSpaceCreate(0);
  dBodyID ball;
  dMass mass;
  double after;
  int i;
  world = dWorldCreate();
  contacts = dJointGroupCreate(0);
  dWorldSetGravity(world, 0.0, -9.81, 0.0);
  dCreatePlane(space, 0.0, 1.0, 0.0, 0.0);
  ball = dBodyCreate(world);
  dMassSetSphere(&mass, 1000.0, radius);
  dBodySetMass(ball, &mass);
  dGeomSetBody(dCreateSphere(space, radius), ball);
  dBodySetPosition(ball, 0.0, radius + 5.3 * step * speed, 0.0);
  dBodySetLinearVel(ball, 0.0, -speed, 0.0);
  before = 0.0;
  for (i = 0; i < 20 && before == 0.0; ++i) {
    dSpaceCollide(space, NULL, near);
    dWorldStep(world, step);
    dJointGroupEmpty(contacts);
  }
  after = dBodyGetLinearVel(ball)[1];
  dJointGroupDestroy(contacts);
  dWorldDestroy(world);
  dSpaceDestroy(space);
  return after;
}

int main(void) {
  const double speeds[] = {0.02, 0.1, 0.5, 2.0, 8.0}, steps[] = {1e-3, 1.0 / 60.0}, accuracy = 1e-12;
  int i, wrong = 0;
  dInitODE();
  printf(" step/s  before/(m/s)  after/before  eps of the table +- its error  difference\n");
  for (i = 0; i < 10; ++i) {
    const double after = drop(speeds[i / 2], steps[i % 2]), found = after / before, wanted = stoss_restitution(before);
    printf("%7.5f %13.7f %13.9f %17.9f +- %.5f %11.1e\n", steps[i % 2], before, found, wanted,
           stoss_restitution_error(before), found - wanted);
    if (!(fabs(found - wanted) <= accuracy)) wrong = 1;
  }
  dCloseODE();
  return wrong;
}
