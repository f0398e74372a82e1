"""What the header of a collision rule does with a normal of any length, and with what is no motion."""

import subprocess

import pytest
from test_table import compiled, written
from test_table_rule import BALLS


REFUSALS = """#include <stdio.h>
#include <string.h>
#include "stoss.h"
static int wrong = 0;
static void expect(int wanted, stoss_rule_body_3d a, stoss_rule_body_3d b, double x, double y, double z, double friction)
{
  stoss_rule_body_2d c = {0.0, 0.0, 0.0, {0.0, 0.0}, 0.0}, d = c, c0, d0;
  const stoss_rule_body_3d a0 = a, b0 = b;
  const double n[3] = {x, y, z};
  c.inverse_mass = a.inverse_mass; c.inverse_inertia = a.inverse_inertia; c.radius = a.radius;
  d.inverse_mass = b.inverse_mass; d.inverse_inertia = b.inverse_inertia; d.radius = b.radius;
  memcpy(c.velocity, a.velocity, sizeof c.velocity); memcpy(d.velocity, b.velocity, sizeof d.velocity);
  c.spin = a.spin[2]; d.spin = b.spin[2];
  c0 = c; d0 = d;
  wrong += stoss_rule_collide_3d(&a, &b, n, friction) != wanted;
  wrong += stoss_rule_collide_2d(&c, &d, n, friction) != wanted;
  if (wanted <= 0) wrong += memcmp(&a, &a0, sizeof a) || memcmp(&b, &b0, sizeof b) || memcmp(&c, &c0, sizeof c) ||
                            memcmp(&d, &d0, sizeof d);
  else wrong += !(a.velocity[0] < -0.004 && a.velocity[0] > -0.0051 && c.velocity[0] < -0.004);
}
int main(void)
{
  const stoss_rule_body_3d a = {1.0, 2.5, 1.0, {0.005, 0.001, 0.0}, {0.0, 0.0, 0.1}};
  const stoss_rule_body_3d wall = {0.0, 0.0, 0.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  const double bad[3] = {HUGE_VAL - HUGE_VAL, HUGE_VAL, -HUGE_VAL}, lengths[5] = {1e-320, 1e-200, 1.0, 1e200, 1.7e308};
  stoss_rule_body_3d c;
  int i;
  for (i = 0; i < 5; ++i) {
    expect(1, a, wall, lengths[i], 0.0, 0.0, 0.3);
    expect(0, a, wall, -lengths[i], 0.0, 0.0, 0.3);
  }
  expect(-1, a, wall, 0.0, 0.0, 0.0, 0.3);
  expect(-1, a, wall, 1.0, 0.0, 0.0, -0.1);
  for (i = 0; i < 3; ++i) {
    expect(-1, a, wall, bad[i], 0.0, 0.0, 0.3);
    expect(-1, a, wall, 1.0, bad[i], 0.0, 0.3);
    expect(-1, a, wall, 1.0, 0.0, 0.0, bad[i]);
    c = a; c.velocity[0] = bad[i]; expect(-1, c, wall, 1.0, 0.0, 0.0, 0.3); expect(-1, wall, c, 1.0, 0.0, 0.0, 0.3);
    c = a; c.spin[2] = bad[i]; expect(-1, c, wall, 1.0, 0.0, 0.0, 0.3); expect(-1, wall, c, 1.0, 0.0, 0.0, 0.3);
    c = a; c.inverse_mass = bad[i]; expect(-1, c, wall, 1.0, 0.0, 0.0, 0.3);
    c = a; c.inverse_inertia = bad[i]; expect(-1, c, wall, 1.0, 0.0, 0.0, 0.3);
    c = a; c.radius = bad[i]; expect(-1, c, wall, 1.0, 0.0, 0.0, 0.3);
  }
  c = a; c.radius = -1.0; expect(-1, c, wall, 1.0, 0.0, 0.0, 0.3);
  printf("%d\\n", wrong);
  return wrong;
}
"""


@pytest.fixture(scope="module")
def folder(stoss, tmp_path_factory):
    folder = tmp_path_factory.mktemp("collisions")
    written(stoss, folder, BALLS)
    (folder / "refusals.c").write_text(REFUSALS)
    return folder


@pytest.mark.parametrize("compiler, standard", [("cc", "c99"), ("c++", "c++11"), ("clang", "c99")])
def test_what_is_no_motion_is_refused(folder, compiler, standard):
    """And a normal may have any length but 0."""
    program = compiled(compiler, standard, folder, "refusals.c", "refusals")
    assert subprocess.run([program], capture_output=True, text=True).stdout == "0\n"
