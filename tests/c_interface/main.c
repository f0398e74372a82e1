/* A user's program in C89: a glass ball on steel, against the installed library. */
#include <math.h>
#include <stdio.h>
#include <stoss/stoss.h>
#include <string.h>

#define REQUIRE(condition)                                                 \
  do {                                                                     \
    if (!(condition)) {                                                    \
      printf("line %d: %s (%s)\n", __LINE__, #condition, stoss_message()); \
      return 1;                                                            \
    }                                                                      \
  } while (0)

static int count_to_two(void* context) {
  int* calls = (int*)context;
  *calls += 1;
  return *calls >= 2;
}

/* The number of docs/reference/c.md: nu = 0.33 at 0.1 c. */
static int one_speed(void) {
  stoss_body* disk = NULL;
  stoss_contact* contact = NULL;
  stoss_result result;
  double speed = 0.1;
  REQUIRE(stoss_disk_make(0.33, 1.0, 1.0, 1.0, 0.0, &disk) == STOSS_OK);
  REQUIRE(stoss_wall_contact_make(disk, &contact) == STOSS_OK);
  stoss_body_free(disk);
  REQUIRE(stoss_curve(contact, &speed, 1, STOSS_TOLERANCE, STOSS_ABSOLUTE, NULL, &result) == STOSS_OK);
  printf("%.5f +- %.5f\n", result.restitution.value, result.restitution.error);
  REQUIRE(result.converged && fabs(result.restitution.value - 0.94704) < 0.00005);
  stoss_contact_free(contact);
  return 0;
}

/* Steel ball of 5 mm on glass, in SI: glass takes 0.85 % of the energy at 1 m/s. */
static int in_si(void) {
  const double wave_speed = sqrt(2.1e11 / 7810.0);
  stoss_body *ball = NULL, *block = NULL;
  stoss_contact* contact = NULL;
  stoss_function* function = NULL;
  stoss_result result;
  double speed = 1.0 / wave_speed, value, error, slowest, fastest, greatest;
  REQUIRE(stoss_sphere_make(0.3, 0.005, 2.1e11, 7810.0, 0.0, &ball) == STOSS_OK);
  REQUIRE(stoss_half_space_make(0.22, 7e10, 2500.0, 0.0, &block) == STOSS_OK);
  REQUIRE(stoss_pair_contact_make(ball, block, &contact) == STOSS_OK);
  REQUIRE(stoss_curve(contact, &speed, 1, STOSS_TOLERANCE, STOSS_ABSOLUTE, NULL, &result) == STOSS_OK);
  REQUIRE(fabs(result.lost_fraction.value - 0.0085) < 0.00005);
  REQUIRE(stoss_function_make(contact, 0.5 * speed, 2.0 * speed, 1e-3, STOSS_BEYOND_ERROR, NULL, &function) ==
          STOSS_OK);
  REQUIRE(stoss_function_evaluate(function, &speed, 1, &value, &error) == STOSS_OK);
  REQUIRE(fabs(value - result.restitution.value) <= error + result.restitution.error);
  REQUIRE(stoss_function_range(function, &slowest, &fastest, &greatest) == STOSS_OK);
  REQUIRE(slowest == 0.5 * speed && fastest == 2.0 * speed && error <= greatest && greatest <= 1e-3);
  speed = -4.0 * speed;
  REQUIRE(stoss_function_evaluate(function, &speed, 1, &value, &error) == STOSS_INVALID_INPUT);
  REQUIRE(strncmp(stoss_message(), "speed: got ", 11) == 0);
  stoss_function_free(function);
  stoss_contact_free(contact);
  stoss_body_free(block);
  stoss_body_free(ball);
  return 0;
}

/* A rough ball that slides all the time: friction takes 3.5 mu (1 + eps) of the speed from s. */
static int oblique(void) {
  stoss_contact* contact = NULL;
  stoss_obliquity asked;
  stoss_oblique_result result;
  REQUIRE(stoss_open("{\"first\": {\"kind\": \"sphere\", \"poisson\": 0.3}}", &contact) == STOSS_OK);
  REQUIRE(stoss_collision(contact, "{\"speed\": 0.01, \"tangential\": 0.03, \"friction\": 0.1}", &asked) == STOSS_OK);
  REQUIRE(stoss_oblique(contact, &asked, 1, STOSS_OBLIQUE_TOLERANCE, NULL, &result) == STOSS_OK);
  REQUIRE(result.converged && result.sliding == 0.03 && result.before.friction == 0.1);
  REQUIRE(fabs(result.sliding_after.value - (0.03 - 0.0035 * (1.0 + result.restitution.value))) < 5e-5);
  stoss_contact_free(contact);
  return 0;
}

/* A cradle of three balls: momentum is kept, and the last takes nearly all. */
static int row(void) {
  const double speeds[3] = {0.01, 0.0, 0.0};
  stoss_estimate after[3];
  REQUIRE(stoss_row("{\"bodies\": [{\"kind\": \"sphere\", \"poisson\": 0.3}, {\"kind\": \"sphere\"}, "
                    "{\"kind\": \"sphere\"}]}",
                    speeds, 3, 1e-3, NULL, after) == STOSS_OK);
  REQUIRE(fabs(after[0].value + after[1].value + after[2].value - 0.01) < 1e-12);
  REQUIRE(after[0].value < 0.0 && after[2].value > 0.0099 && after[2].error < 1e-5);
  return 0;
}

static int interrupted(void) {
  int calls = 0;
  stoss_body* sphere = NULL;
  stoss_contact* contact = NULL;
  stoss_function* function = NULL;
  stoss_control control;
  control.threads = 2;
  control.poll = count_to_two;
  control.context = &calls;
  REQUIRE(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &sphere) == STOSS_OK);
  REQUIRE(stoss_wall_contact_make(sphere, &contact) == STOSS_OK);
  REQUIRE(stoss_function_make(contact, 1e-5, 1.0, 1e-6, STOSS_BEYOND_CLAMP, &control, &function) == STOSS_INTERRUPTED);
  REQUIRE(calls == 2 && function == NULL);
  stoss_contact_free(contact);
  stoss_body_free(sphere);
  return 0;
}

int main(void) {
  stoss_body* body = NULL;
  REQUIRE(stoss_version()[0] != '\0' && stoss_message()[0] == '\0');
  REQUIRE(stoss_sphere_make(0.5, 1.0, 1.0, 1.0, 0.0, &body) == STOSS_INVALID_INPUT);
  REQUIRE(body == NULL && strncmp(stoss_message(), "poisson: got 0.5, allowed ", 26) == 0);
  REQUIRE(stoss_disk_make(0.33, 1.0, 1.0, 1.0, 0.0, NULL) == STOSS_INVALID_INPUT);
  if (one_speed() != 0 || in_si() != 0 || oblique() != 0 || row() != 0 || interrupted() != 0) return 1;
  printf("stoss %s in C\n", stoss_version());
  return 0;
}
