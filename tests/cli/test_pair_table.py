"""stoss table --ratio: the functions of speed and ratio of radii in C are those of JSON and of
direct values."""

import json
import math
import random
import shutil
import subprocess

import pytest

pytestmark = pytest.mark.numbers

DISKS = "table --body disk --poisson 0.33 --speed 0.01:0.2 --against same --ratio 1:2 --error 5e-3"
WARNINGS = "-pedantic -Wall -Wextra -Wconversion -Wshadow -Wfloat-equal -Werror".split()
PROGRAM = """#include "pairs.h"
#include "other.h"
#include "pairs.h"
#include <stdio.h>
int main(void)
{
  double v, r;
  while (scanf("%lf %lf", &v, &r) == 2)
    printf("%.17g %.17g\\n", stoss_pair_restitution(v, r), stoss_pair_restitution_error(v, r));
  return other_pair_restitution(0.1, 1.5) > 0.0 ? 0 : 1;
}
"""


def evaluated(document, speed, ratio):
    """What the JSON document says of a speed and a ratio."""
    rows = document["records"]
    places = [(each - 1) / (each + 1) for each in document["ratio"]]
    s = abs((ratio - 1) / (ratio + 1)) if document["inverse_is_same"] else (ratio - 1) / (ratio + 1)
    k = max(i for i in range(len(rows) - 1) if i == 0 or rows[i]["speed"] <= speed)
    j = max(i for i in range(len(places) - 1) if i == 0 or places[i] <= s)
    h = math.log(rows[k + 1]["speed"] / rows[k]["speed"])

    def cubic(width, t, left, right, slope, slope_at_end):
        u = 1 - t
        return left * (1 + 2 * t) * u * u + right * t * t * (1 + 2 * u) + width * t * u * (slope * u - slope_at_end * t)

    def across(value, slope, column):
        t = math.log(speed / rows[k]["speed"]) / h
        return cubic(h, t, *(rows[i][value][column] for i in (k, k + 1)), *(rows[i][slope][column] for i in (k, k + 1)))

    g = places[j + 1] - places[j]
    values = [across("restitution", "slope_of_speed", i) for i in (j, j + 1)]
    slopes = [across("slope_of_ratio", "slope_of_both", i) for i in (j, j + 1)]
    return cubic(g, (s - places[j]) / g, *values, *slopes), rows[k]["error_to_next"][j]


@pytest.mark.parametrize(("compiler", "standard"), [("gcc", "c89"), ("g++", "c++20")])
def test_header_is_the_table(stoss, tmp_path, compiler, standard):
    if shutil.which(compiler) is None:
        pytest.skip(f"needs {compiler}")
    for name, file in (("stoss", "pairs.h"), ("other", "other.h")):
        assert stoss.run(DISKS, f"--name {name} -o", str(tmp_path / file)).returncode == 0
    document = json.loads(stoss.run(DISKS, "--format json").stdout)
    (tmp_path / "main.c").write_text(PROGRAM)
    language = "c++" if "++" in compiler else "c"
    words = [compiler, f"-std={standard}", *WARNINGS, "-O2", "-x", language, "main.c", "-o", "main", "-lm"]
    result = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert (result.returncode, result.stderr) == (0, "")
    chance = random.Random(1)
    points = [(0.01 * 20 ** chance.random(), 0.5 * 4 ** chance.random()) for _ in range(200)]
    points += [(0.01, 1.0), (0.2, 2.0), (-0.2, 0.5), (0.05, 1.0)]
    beyond = [(0.3, 1.0), (0.1, 2.1), (0.1, 0.4), (1e-3, 1.0)]
    text = "".join(f"{v!r} {r!r}\n" for v, r in points + beyond)
    run = subprocess.run([tmp_path / "main"], input=text, capture_output=True, text=True, timeout=60, check=True)
    found = [tuple(map(float, line.split())) for line in run.stdout.splitlines()]
    for (v, r), (value, error) in zip(points, found):
        expected, bar = evaluated(document, abs(v), r)
        assert value == pytest.approx(expected, abs=1e-13) and error == bar <= 5e-3
    clamped = [evaluated(document, 0.2, 1.0), evaluated(document, 0.1, 2.0), evaluated(document, 0.1, 2.0)]
    for (value, error), (expected, _) in zip(found[len(points) :], [*clamped, evaluated(document, 0.01, 1.0)]):
        assert value == pytest.approx(expected, abs=1e-13) and error == math.inf
