/*
 * A rough ball in a plane hits the floor at an angle in Chipmunk 7, and leaves with the velocity and spin of the
 * collision rule.
 *
 *   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.2:1
 *       --tolerance 0.05 --oblique -o rule.h
 *   cc chipmunk_spin.c -lchipmunk -lm && ./a.out
 *
 * Copy body_of, set and before_solve. preSolve sets velocities and spins of what approaches. The contact may stay on:
 * the solver then finds bodies that part, and leaves their velocities alone. What approaches slower than the table
 * begins is left to Chipmunk, which so holds what rests; let the table begin above the 0.16 m/s that gravity adds in a
 * step of 1/60 s. Bodies that move freely are balls, of moment 2/5 m R^2. A table of disks is for one friction, that
 * of its command. Units are m, kg, s.
 */
#include <chipmunk/chipmunk.h>

#include "rule.h"
#include "throws.h"

static const double radius = 0.1, gravity = 9.81, friction = 0.3;

static stoss_rule_body_2d body_of(cpBody* body, cpShape* shape, cpVect point) {
  stoss_rule_body_2d round = {0.0, 0.0, 0.0, {0.0, 0.0}, 0.0}; /* a wall, which moves as it does at the point */
  cpVect velocity = cpBodyGetVelocityAtWorldPoint(body, point);
  if (cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC) {
    velocity = cpBodyGetVelocity(body);
    round.inverse_mass = 1.0 / cpBodyGetMass(body);
    round.inverse_inertia = 1.0 / cpBodyGetMoment(body);
    round.radius = cpCircleShapeGetRadius(shape);
    round.spin = cpBodyGetAngularVelocity(body);
  }
  round.velocity[0] = velocity.x;
  round.velocity[1] = velocity.y;
  return round;
}

static void set(cpBody* body, const stoss_rule_body_2d* round) {
  if (round->inverse_mass == 0.0) return;
  cpBodySetVelocity(body, cpv(round->velocity[0], round->velocity[1]));
  cpBodySetAngularVelocity(body, round->spin);
}

static cpBool before_solve(cpArbiter* arbiter, cpSpace* space, cpDataPointer data) {
  const cpVect n = cpArbiterGetNormal(arbiter), point = cpArbiterGetPointA(arbiter, 0);
  const double normal[2] = {n.x, n.y}; /* from the first body to the second */
  cpShape *shape_a, *shape_b;
  cpBody *first, *second;
  stoss_rule_body_2d a, b;
  (void)space;
  (void)data;
  cpArbiterGetShapes(arbiter, &shape_a, &shape_b);
  cpArbiterGetBodies(arbiter, &first, &second);
  a = body_of(first, shape_a, point);
  b = body_of(second, shape_b, point);
  if (cpvdot(cpv(a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1]), n) < STOSS_RULE_SLOWEST) return cpTrue;
  if (stoss_rule_collide_2d(&a, &b, normal, cpArbiterGetFriction(arbiter)) > 0) {
    set(first, &a);
    set(second, &b);
  }
  return cpTrue;
}

/* The motion of a ball before and after its first impact, or where it is after three seconds. */
struct Flight {
  stoss_rule_body_2d before, after;
  double height;
};

static struct Flight fly(const struct Throw* thrown, double step) {
  const double mass = 31.4;
  struct Flight flight;
  cpSpace* space = cpSpaceNew();
  cpShape* floor = cpSegmentShapeNew(cpSpaceGetStaticBody(space), cpv(-9.0, -1.0), cpv(9.0, -1.0), 1.0);
  cpBody* body = cpBodyNew(mass, 0.4 * mass * radius * radius);
  cpShape* ball = cpCircleShapeNew(body, radius, cpvzero);
  double time;
  cpSpaceAddDefaultCollisionHandler(space)->preSolveFunc = before_solve;
  cpSpaceSetGravity(space, cpv(0.0, -gravity));
  cpSpaceSetCollisionSlop(space, 1e-4);
  cpShapeSetFriction(floor, 1.0);
  cpShapeSetFriction(ball, friction);
  cpSpaceAddShape(space, floor);
  cpSpaceAddBody(space, body);
  cpSpaceAddShape(space, ball);
  cpBodySetPosition(body, cpv(0.0, radius + 1.3 * step * thrown->down));
  cpBodySetVelocity(body, cpv(thrown->along, -thrown->down));
  cpBodySetAngularVelocity(body, thrown->rim / radius);
  flight.after = body_of(body, ball, cpvzero);
  for (time = 0.0; time < 3.0 && flight.after.velocity[1] < 0.1; time += step) {
    flight.before = flight.after;
    cpSpaceStep(space, step);
    flight.after = body_of(body, ball, cpvzero);
  }
  flight.height = cpBodyGetPosition(body).y;
  cpSpaceRemoveShape(space, ball);
  cpSpaceRemoveBody(space, body);
  cpSpaceRemoveShape(space, floor);
  cpShapeFree(ball);
  cpBodyFree(body);
  cpShapeFree(floor);
  cpSpaceFree(space);
  return flight;
}

int main(void) {
  const double down[2] = {0.0, -1.0}, steps[] = {1e-3, 1.0 / 60.0}, accuracy = 1e-12;
  const struct Throw slow = {0.03, 0.0, 0.0};
  double height;
  int i, wrong = 0;
  printf(" step/s   down  along   rim/(m/s)  after: along, up, rim            difference from the rule\n");
  for (i = 0; i < 2 * throw_count; ++i) {
    const double step = steps[i % 2];
    struct Flight flight = fly(&throws[i / 2], step);
    stoss_rule_body_2d floor = {0.0, 0.0, 0.0, {0.0, 0.0}, 0.0}, *ball = &flight.before;
    double found[3], wanted[3];
    stoss_rule_collide_2d(ball, &floor, down, friction);
    wanted[0] = ball->velocity[0];
    wanted[1] = ball->velocity[1] - gravity * step; /* which acts after preSolve */
    wanted[2] = ball->spin * radius;
    found[0] = flight.after.velocity[0];
    found[1] = flight.after.velocity[1];
    found[2] = flight.after.spin * radius;
    if (compare(&throws[i / 2], step, found, wanted, 3, accuracy)) wrong = 1;
  }
  height = fly(&slow, 1.0 / 60.0).height;
  printf("a ball that falls slower than the table begins rests at %.4f m\n", height);
  if (!(fabs(height - radius) < 0.01 * radius)) wrong = 1;
  return wrong;
}
