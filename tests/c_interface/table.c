/* The header that `stoss table` writes and the C interface, in one program: their values are the same. */
#include <math.h>
#include <stdio.h>
#include <stoss/stoss.h>

#include "restitution.h"

int main(void) {
  stoss_body* disk = NULL;
  stoss_contact* contact = NULL;
  stoss_function* function = NULL;
  double speed, difference, worst = 0.0;
  int wrong = stoss_disk_make(0.33, 1.0, 1.0, 1.0, 0.0, &disk) != STOSS_OK ||
              stoss_wall_contact_make(disk, &contact) != STOSS_OK ||
              stoss_function_make(contact, 0.01, 0.2, 1e-3, STOSS_BEYOND_CLAMP, NULL, &function) != STOSS_OK;
  for (speed = 0.01; !wrong && speed < 0.2; speed *= 1.003) {
    double value, error;
    wrong = stoss_function_evaluate(function, &speed, 1, &value, &error) != STOSS_OK;
    difference = fabs(value - stoss_restitution(-speed)) + fabs(error - stoss_restitution_error(speed));
    if (!(difference <= worst)) worst = difference;
  }
  for (speed = -0.002; !wrong && speed < 0.003; speed += 0.001) { /* below the range, 0 among them */
    double value, error;
    wrong = stoss_function_evaluate(function, &speed, 1, &value, &error) != STOSS_OK ||
            value != stoss_restitution(0.01) || stoss_restitution(speed) != stoss_restitution(0.01) ||
            error != HUGE_VAL || stoss_restitution_error(speed) != HUGE_VAL;
  }
  printf("maximum difference %g %s\n", worst, stoss_message());
  stoss_function_free(function);
  stoss_contact_free(contact);
  stoss_body_free(disk);
  return wrong || !(worst <= 1e-13);
}
