"""stoss table: the function in C, as columns and as JSON is the one that direct values have."""

import ctypes
import json
import math
import os
import random
import shutil
import subprocess

import pytest


pytestmark = pytest.mark.numbers

DISK = "table --body disk --poisson 0.33 --speed 1e-4:0.3"
BALL = (
    "table --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.005 --speed 0.01:10"
    " --against half-space,poisson=0.23,young=7e10,density=2500"
)
SMALL_BALL = BALL.partition(" --against")[0] + " --error 0.1"

WARNINGS = "-pedantic -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Wfloat-equal -Wundef -Werror".split()
DIALECTS = [("gcc", "c89"), ("g++", "c++98"), ("g++", "c++20"), ("clang", "c99")]

PROGRAM = """#include "stoss.h"
#include "other.h"
#include "stoss.h"
#include <stdio.h>
int main(void)
{
  double v;
  while (scanf("%lf", &v) == 1) printf("%.17g %.17g\\n", stoss_restitution(v), stoss_restitution_error(v));
  return other_restitution(0.1) > 0.0 ? 0 : 1;
}
"""


def compiled(compiler, standard, folder, source="main.c", target="main", more=()):
    """Compiles without a word; returns the program."""
    if shutil.which(compiler) is None:
        pytest.skip(f"needs {compiler}")
    language = "c++" if "++" in compiler else "c"
    words = [compiler, f"-std={standard}", *WARNINGS, *more, "-O2", "-x", language, source, "-o", target, "-lm"]
    result = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=120)
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    return folder / target


def values(program, speeds):
    """ε and its error at each of the speeds, as the compiled header has them."""
    text = "".join(f"{speed!r}\n" for speed in speeds)
    result = subprocess.run([program], input=text, capture_output=True, text=True, timeout=60, check=True)
    return [tuple(map(float, line.split())) for line in result.stdout.splitlines()]


def evaluated(document, speed):
    """What the JSON document says of a speed."""
    knots = document["records"]
    k = max(i for i in range(len(knots) - 1) if i == 0 or knots[i]["speed"] <= speed)
    a, b = knots[k], knots[k + 1]
    h = math.log(b["speed"] / a["speed"])
    t = math.log(speed / a["speed"]) / h
    u = 1 - t
    value = a["restitution"] * (1 + 2 * t) * u * u + b["restitution"] * t * t * (1 + 2 * u)
    return value + h * t * u * (a["slope"] * u - b["slope"] * t), a["error_to_next"]


def within(speeds):
    slowest, fastest = map(float, speeds.split(":"))
    chance = random.Random(17)
    inner = [slowest * (fastest / slowest) ** chance.random() for _ in range(24)]
    return [slowest, *inner, fastest]


def written(stoss, folder, job, name="stoss.h"):
    result = stoss.run(job, f"-o {folder / name}")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    return (folder / name).read_text()


@pytest.fixture(scope="module")
def headers(stoss, tmp_path_factory):
    folder = tmp_path_factory.mktemp("headers")
    written(stoss, folder, DISK)
    written(stoss, folder, f"{DISK} --name other --beyond error", "other.h")
    (folder / "main.c").write_text(PROGRAM)
    (folder / "unused.c").write_text('#include "stoss.h"\nint main(void) { return 0; }\n')
    return folder


@pytest.fixture(scope="module")
def document(stoss):
    return json.loads(stoss.run(DISK, "--format json").stdout)


@pytest.mark.parametrize("compiler, standard", DIALECTS)
def test_header_is_of_every_dialect(headers, document, compiler, standard):
    casts = ["-Wold-style-cast"] if "++" in compiler else ["-Wmissing-prototypes"]
    compiled(compiler, standard, headers, "unused.c", "unused", casts)
    program = compiled(compiler, standard, headers, more=casts)
    speeds = within("1e-4:0.3")
    for speed, got in zip(speeds, values(program, speeds)):
        expected = evaluated(document, speed)
        assert got[0] == pytest.approx(expected[0], rel=1e-14) and got[1] == expected[1]


@pytest.fixture(scope="module")
def disk(headers):
    return compiled("cc", "c99", headers, target="disk")


def test_sign_does_not_count(disk):
    speeds = within("1e-4:0.3")
    assert values(disk, speeds) == values(disk, [-speed for speed in speeds])


def test_beyond_the_range_is_the_nearer_end(disk):
    (low, _), (high, _) = values(disk, [1e-4, 0.3])
    beyond = [(0.0, low), (1e-310, low), (9.99e-5, low), (0.3000001, high), (1e300, high), (math.inf, high)]
    for speed, end in beyond:
        assert values(disk, [speed, -speed]) == [(end, math.inf)] * 2
    assert all(math.isnan(each) for each in values(disk, [math.nan])[0])


def test_beyond_can_be_not_a_number(stoss, tmp_path):
    written(stoss, tmp_path, f"{DISK} --beyond error")
    (tmp_path / "main.c").write_text(PROGRAM.replace('#include "other.h"\n', "").replace("other_", "stoss_"))
    program = compiled("cc", "c89", tmp_path)
    for value, error in values(program, [0.0, 9.99e-5, 0.31, -1, math.inf]):
        assert math.isnan(value) and error == math.inf
    assert all(math.isnan(each) for each in values(program, [math.nan])[0])
    assert all(error < 1e-3 for _, error in values(program, [1e-4, 0.3]))


def test_reckless_compilers_stay_within_the_arrays(headers):
    """With -ffast-math a comparison with what is not a number may say anything: nothing else is
    read."""
    sanitize = ["-ffast-math", "-Wno-float-equal", "-fsanitize=address,undefined", "-fno-sanitize=float-cast-overflow"]
    program = compiled("gcc", "c99", headers, target="fast", more=sanitize)
    speeds = [math.nan, math.inf, 0.0, 1e-4, 0.3, 1e300]
    assert len(values(program, speeds)) == len(speeds)


def test_document(document):
    assert document["schema"] == "stoss/table/2" and document["complete"] and document["units"] == {"speed": "c"}
    assert document["inputs"]["beyond"] == "clamp" and document["inputs"]["speed"] == "1e-4:0.3"
    errors = [record["error_to_next"] for record in document["records"][:-1]]
    assert max(errors) == document["greatest_error"] and "error_to_next" not in document["records"][-1]
    assert all(record["restitution_error"] <= 1e-3 / 2 for record in document["records"])


def test_header_says_where_it_comes_from(stoss, headers):
    text = (headers / "stoss.h").read_text()
    version = stoss.run("--version").stdout.split()[1]
    for line in [f"stoss {version}: table", f"command: stoss {DISK} -o ", 'first: {"kind":"disk","poisson":0.33}', "error: 0.001"]:
        assert f"\n * {line}" in text
    assert "in c; its sign" in text and "in m/s; its sign" in stoss.run(SMALL_BALL).stdout


def test_words_of_a_command_stay_in_the_comment(stoss, tmp_path):
    name = "a*/ int b; /*c.h"
    (tmp_path / "a*").mkdir()
    (tmp_path / "a*" / " int b; ").mkdir()
    words = [os.path.abspath(stoss.path), *DISK.split(), "--error", "0.05", "-o", name]
    assert subprocess.run(words, cwd=tmp_path, timeout=60).returncode == 0
    shutil.move(tmp_path / name, tmp_path / "stoss.h")
    (tmp_path / "unused.c").write_text('#include "stoss.h"\nint main(void) { return 0; }\n')
    compiled("cc", "c89", tmp_path, "unused.c")


@pytest.mark.skipif(shutil.which("cc") is None, reason="needs cc")
def test_other_languages_take_it_from_a_shared_library(headers):
    """As Julia's ccall and Python's ctypes do."""
    (headers / "shared.c").write_text('#include "stoss.h"\ndouble restitution(double v) { return stoss_restitution(v); }\n')
    subprocess.run(["cc", "-shared", "-fPIC", "shared.c", "-o", "shared.so", "-lm"], cwd=headers, check=True, timeout=60)
    restitution = ctypes.CDLL(str(headers / "shared.so")).restitution
    restitution.restype, restitution.argtypes = ctypes.c_double, [ctypes.c_double]
    assert restitution(-0.1) == values(compiled("cc", "c99", headers, target="again"), [0.1])[0][0]
