"""stoss table --oblique: the collision rule in C and as JSON is the one that direct values have."""

import json
import math
import random
import subprocess

import pytest

from conftest import number
from test_table import DIALECTS, compiled, written

pytestmark = pytest.mark.numbers

BALLS = "table --body sphere --poisson 0.3 --speed 1e-3:1e-2 --against same --oblique --tolerance 0.1 --error 0.01"
MIXTURE = "table --body sphere --poisson 0.3 --speed 1e-3:3e-3 --against same --ratio 1:1.5 --oblique --tolerance 0.2 --error 0.05"
DISK = "table --body disk --poisson 0.33 --speed 0.05:0.1 --friction 0.3 --oblique --tolerance 0.2 --error 0.02"

PROGRAM = """#include "stoss.h"
#include "mix.h"
#include "stoss.h"
#include <stdio.h>
int main(void)
{
  double v, s, f, r;
  while (scanf("%lf %lf %lf %lf", &v, &s, &f, &r) == 4) {
    printf("%.17g %.17g ", stoss_rule_restitution(v, s, f, r), stoss_rule_sliding(v, s, f, r));
    printf("%.17g %.17g ", stoss_rule_restitution_error(v, s, f, r), stoss_rule_sliding_error(v, s, f, r));
    printf("%.17g\\n", mix_rule_sliding(v, s, f, r));
  }
  return 0;
}
"""

COLLISIONS = """#include "stoss.h"
#include <stdio.h>
#include <stdlib.h>
static double any(void) { return 2.0 * rand() / RAND_MAX - 1.0; }
int main(void)
{
  double energy = 0.0, momentum = 0.0, about = 0.0;
  int i, k, met = 0;
  for (i = 0; i < 100000; ++i) {
    stoss_rule_body_3d a, b, c, d;
    double n[3], before = 0.0, after = 0.0, length = 0.0;
    a.inverse_mass = 1.0; a.inverse_inertia = 2.5; a.radius = 1.0;
    b.inverse_mass = 0.3; b.inverse_inertia = 1.1; b.radius = 1.4;
    for (k = 0; k < 3; ++k) {
      n[k] = any();
      length += n[k] * n[k];
      a.velocity[k] = 0.01 * any(); b.velocity[k] = 0.01 * any();
      a.spin[k] = 0.01 * any(); b.spin[k] = 0.01 * any();
    }
    c = a; d = b;
    met += stoss_rule_collide_3d(&a, &b, n, 0.5 + 0.5 * any());
    for (k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      const double p = (b.velocity[k] - d.velocity[k]) / b.inverse_mass;
      const double q = (b.velocity[m] - d.velocity[m]) * n[l] - (b.velocity[l] - d.velocity[l]) * n[m];
      const double turned = (a.spin[k] - c.spin[k]) / a.inverse_inertia + (b.spin[k] - d.spin[k]) / b.inverse_inertia;
      momentum = fmax(momentum, fabs(p + (a.velocity[k] - c.velocity[k]) / a.inverse_mass));
      about = fmax(about, fabs(turned + 2.4 * q / sqrt(length) / b.inverse_mass));
      before += c.velocity[k] * c.velocity[k] + d.velocity[k] * d.velocity[k] / 0.3;
      before += c.spin[k] * c.spin[k] / 2.5 + d.spin[k] * d.spin[k] / 1.1;
      after += a.velocity[k] * a.velocity[k] + b.velocity[k] * b.velocity[k] / 0.3;
      after += a.spin[k] * a.spin[k] / 2.5 + b.spin[k] * b.spin[k] / 1.1;
    }
    energy = fmax(energy, after / before - 1.0);
  }
  printf("%d %g %g %g\\n", met, energy, momentum, about);
  return 0;
}
"""

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
    folder = tmp_path_factory.mktemp("rules")
    written(stoss, folder, f"{BALLS} --quiet")
    written(stoss, folder, f"{MIXTURE} --name mix --beyond error --quiet", "mix.h")
    (folder / "main.c").write_text(PROGRAM)
    (folder / "collisions.c").write_text(COLLISIONS)
    (folder / "refusals.c").write_text(REFUSALS)
    (folder / "unused.c").write_text('#include "stoss.h"\n#include "mix.h"\nint main(void) { return 0; }\n')
    return folder


@pytest.fixture(scope="module")
def document(stoss):
    return json.loads(stoss.run(BALLS, "--format json").stdout)


def ask(program, *arguments):
    text = "".join(" ".join(map(repr, each)) + "\n" for each in arguments)
    result = subprocess.run([program], input=text, capture_output=True, text=True, timeout=60, check=True)
    return [tuple(map(float, line.split())) for line in result.stdout.splitlines()]


def hermite(places, at):
    """The interval of a place, and the weights of the values and slopes at its ends."""
    k = max(i for i in range(len(places) - 1) if i == 0 or places[i] <= at)
    h = places[k + 1] - places[k]
    t = (at - places[k]) / h
    u = 1 - t
    return k, ((1 + 2 * t) * u * u, t * t * (1 + 2 * u), h * t * u * u, -h * t * t * u)


def evaluated(record, speed, z):
    """What a grid of the JSON document says of a speed and a slip."""
    speeds = [math.log(each) for each in record["speed"]]
    k, (a, b, c, d) = hermite(speeds, math.log(speed))
    slips, nodes = record["slip"], record["nodes"]
    if len(slips) == 1:
        return a * nodes[2 * k] + b * nodes[2 * k + 2] + c * nodes[2 * k + 1] + d * nodes[2 * k + 3]
    j, weights = hermite(slips, z)
    node = lambda i, l, part: nodes[4 * (i * len(slips) + l) + part]  # noqa: E731
    line = lambda l, part: (  # noqa: E731
        a * node(k, l, part) + b * node(k + 1, l, part) + c * node(k, l, part + 1) + d * node(k + 1, l, part + 1)
    )
    return sum(w * each for w, each in zip(weights, (line(j, 0), line(j + 1, 0), line(j, 2), line(j + 1, 2))))


def places(count, slowest=1e-3, fastest=1e-2):
    chance = random.Random(3)
    for _ in range(count):
        v, friction = slowest * (fastest / slowest) ** chance.random(), 0.05 + 0.4 * chance.random()
        yield v, math.tan(1.5 * chance.random()) * friction * v, friction, 1.0


@pytest.mark.parametrize("compiler, standard", DIALECTS)
def test_header_is_of_every_dialect(folder, document, compiler, standard):
    casts = ["-Wold-style-cast"] if "++" in compiler else ["-Wmissing-prototypes"]
    compiled(compiler, standard, folder, "unused.c", "unused", casts)
    program = compiled(compiler, standard, folder, more=casts)
    asked = list(places(20))
    normal, along = document["records"]
    for (v, s, friction, _), got in zip(asked, ask(program, *asked)):
        scale = s + friction * v
        z = (s - friction * v) / scale
        assert got[0] == pytest.approx(evaluated(normal, v, z), rel=1e-13)
        assert got[1] == pytest.approx(evaluated(along, v, z) * scale, abs=1e-13 * scale)
        assert got[2] <= document["greatest_error"] <= 1e-2
        assert got[3] <= document["greatest_sliding_error"] <= 0.1


@pytest.fixture(scope="module")
def program(folder):
    return compiled("cc", "c99", folder, target="rules")


def test_limits(program):
    low, inside, fast, none, still = ask(
        program, (1e-5, 0.0, 0.3, 1.0), (2e-3, 0.0, 0.3, 1.0), (0.1, 0.02, 0.3, 1.0), (2e-3, 0.1, 0.0, 1.0),
        (0.0, 0.1, 0.3, 1.0),
    )  # fmt: skip
    assert low[1] == inside[1] == 0 and low[2] == math.inf and inside[2] < 1e-2
    assert fast[3] == math.inf and -0.02 <= fast[1] <= 0.02
    assert none[1] == 0.1 and still[1] == 0.1
    assert math.isnan(low[4]) and math.isnan(fast[4])  # --beyond error
    for bad in ((math.nan, 0.1, 0.3, 1.0), (2e-3, math.nan, 0.3, 1.0), (2e-3, 0.1, -0.3, 1.0), (2e-3, math.inf, 0.3, 1.0)):
        assert all(math.isnan(each) for each in ask(program, bad)[0])
    wide, outside = ask(program, (2e-3, 1e-3, 0.3, 1 / 1.4), (2e-3, 1e-3, 0.3, 1.6))
    assert wide[4] == pytest.approx(ask(program, (2e-3, 1e-3, 0.3, 1.4))[0][4]) and math.isnan(outside[4])


@pytest.mark.long
def test_a_disk_at_a_wall_has_a_rule_of_one_friction(stoss, tmp_path):
    written(stoss, tmp_path, f"{DISK} --quiet")
    (tmp_path / "main.c").write_text(PROGRAM.replace('#include "mix.h"\n', "").replace("mix_", "stoss_"))
    other, own = ask(compiled("cc", "c99", tmp_path), (0.07, 0.1, 0.2, 1.0), (0.07, 0.1, 0.3, 1.0))
    assert math.isnan(other[1]) and abs(own[1]) <= 0.1


def test_collisions_keep_what_must_be_kept(folder):
    program = compiled("cc", "c99", folder, "collisions.c", "collisions")
    met, energy, momentum, about = map(float, subprocess.run([program], capture_output=True, check=True).stdout.split())
    assert 49_000 < met < 51_000 and energy < 1e-14 and momentum < 1e-16 and about < 1e-15


@pytest.mark.parametrize("compiler, standard", DIALECTS[1:])
def test_what_is_no_motion_is_refused(folder, compiler, standard):
    """And a normal may have any length but 0."""
    program = compiled(compiler, "c99" if standard == "c89" else standard, folder, "refusals.c", "refusals")
    assert subprocess.run([program], capture_output=True, text=True).stdout == "0\n"


def test_two_columns_are_at_one_speed(stoss):
    rows = stoss.run(BALLS.replace("1e-3:1e-2", "0.004"), "--format two-column").stdout.splitlines()
    (x, y), (u, v), (p, q) = (tuple(map(float, row.split())) for row in (rows[0], rows[-2], rows[-1]))
    assert (x, y, u, p) == (0, 0, pytest.approx(9), pytest.approx(18)) and q - v == pytest.approx(9)
    words = "oblique --body sphere --poisson 0.3 --against same --speed 0.004 --friction 0.1 --tangential 0.0036"
    direct = stoss.data(words, "--tolerance 1e-3")[0]
    assert v == pytest.approx(number(direct, "sliding_after") / 4e-4, abs=0.5)
    assert 4 < len(rows) < 40


def test_what_a_function_of_the_sliding_leaves_out_is_said(stoss):
    wide = stoss.run(BALLS.replace("1e-3:1e-2", "0.04:0.06").replace("0.05", "0.1"))
    assert wide.returncode == 0 and "does not tell velocity from spin" in wide.stderr
    assert "velocity from spin" not in stoss.run(BALLS.replace("1e-3:1e-2", "1e-3:2e-3").replace("0.05", "0.02")).stderr
