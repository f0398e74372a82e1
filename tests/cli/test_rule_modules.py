"""Collision rules as modules of Rust and JavaScript: values and collisions are those of the header in C. The files are
those of tests/data/tables, which tests/table/test_golden_tables.cpp compares with what the library writes."""

import math
import random
import shutil
from pathlib import Path

import pytest

from test_table_modules import rows, run, told

pytestmark = pytest.mark.numbers

TABLES = Path(__file__).resolve().parents[1] / "data/tables"
SPEEDS = {"plain": (0.01, 0.2), "mixture": (51.7219, 1034.438)}  # slowest, fastest
VALUES = ("restitution", "restitution_error", "sliding", "sliding_error")
ODD = [0.0, -0.0, -1.0, math.inf, math.nan]


def arguments(slowest, fastest):
    """Speed, sliding, friction, ratio: within the table, at its ends, beyond, and no numbers."""
    inside = [slowest, 0.3 * fastest, fastest, -0.7 * fastest, 0.5 * slowest, 2 * fastest]
    slides, frictions, ratios = (0.0, 0.3, -0.2, 5.0), (0.0, 0.3, 1.7), (1.0, 1.2, 0.4)
    plain = [(v, s * v, f, r) for v in inside for s in slides for f in frictions for r in ratios]
    first = (inside[1], 0.1 * slowest, 0.3, 1.1)
    return plain + [tuple(x if i == k else y for i, y in enumerate(first)) for k in range(4) for x in ODD]


def encounters(fastest):
    """1/m, 1/I, R, velocity and spin of two bodies, normal and friction; at random, and such as are refused."""
    draw = random.Random(5)
    some = lambda size: [size * draw.uniform(-1, 1) for _ in range(3)]  # noqa: E731
    met = []
    for _ in range(40):
        a = [1.0, 2.5, 1.0, *some(0.5 * fastest), *some(fastest)]
        b = [*map(draw.choice, ([0.0, 0.3], [0.0, 1.1], [1.0, 1.3])), *some(0.5 * fastest), *some(fastest)]
        met.append((*a, *b, *some(3.0), 0.3))
    return met + [tuple(x if i == k else y for i, y in enumerate(met[1])) for k in range(22) for x in ODD]


def split(row, dimensions):
    body = lambda of: (*of[:3], of[3 : 3 + dimensions], of[6:9] if dimensions == 3 else of[6:7])  # noqa: E731
    return body(row[:9]), body(row[9:18]), row[18 : 18 + dimensions]


class Language:
    """How a program is written that prints values, then collisions."""

    nan, infinity, brackets = "NAN", "INFINITY", "{}"

    def numbers(self, of):
        return ", ".join(told(x, self.nan, self.infinity) for x in of)

    def array(self, of):
        return self.brackets[0] + self.numbers(of) + self.brackets[1]

    def spin(self, of):
        return self.array(of) if len(of) == 3 else self.numbers(of)

    def fields(self, of):
        """A body with the names of its fields."""
        words = zip(("inverse_mass", "inverse_inertia", "radius"), map(self.numbers, ([x] for x in of[:3])))
        words = [*words, ("velocity", self.array(of[3])), ("spin", self.spin(of[4]))]
        return "{ " + ", ".join(f"{name}: {text}" for name, text in words) + " }"


class C(Language):
    def run(self, folder, rule, asked, met, dimensions):
        show = " ".join(["%.17g"] * 4)
        values = lambda at: ", ".join(f"{rule}_{each}({self.numbers(at)})" for each in VALUES)  # noqa: E731
        lines = [f'printf("{show}\\n", {values(at)});' for at in asked]
        kind = f"{rule}_body_{dimensions}d"
        spins = ["spin"] if dimensions == 2 else ["spin[0]", "spin[1]", "spin[2]"]
        places = [*(f"velocity[{i}]" for i in range(dimensions)), *spins]
        after = ", ".join(f"{body}.{place}" for body in "ab" for place in places)
        for row in met:
            a, b, normal = split(row, dimensions)
            body = lambda of: f"{{{self.numbers(of[:3])}, {self.array(of[3])}, {self.spin(of[4])}}}"  # noqa: E731
            lines.append(f"{{ {kind} a = {body(a)}, b = {body(b)}; const double n[] = {self.array(normal)};")
            lines.append(f"  int done = {rule}_collide_{dimensions}d(&a, &b, n, {self.numbers(row[-1:])});")
            lines.append(f'  printf("%d{" %.17g" * 2 * len(places)}\\n", done, {after}); }}')
        begin = '#include <stdio.h>\n#include "table.h"\nint main(void) {\n'
        (folder / "main.c").write_text(begin + "\n".join(lines) + "\nreturn 0;\n}\n")
        run("cc", "-O1", "main.c", "-o", "in_c", "-lm", cwd=folder)
        return rows(run("./in_c", cwd=folder))


class JavaScript(Language):
    nan, infinity, brackets = "NaN", "Infinity", "[]"

    def run(self, folder, rule, asked, met, dimensions):
        calls = ", ".join(f"table.{rule}_{each}(...at)" for each in VALUES)
        lines = [f"for (const at of [{', '.join(map(self.array, asked))}]) console.log([{calls}].join(' '));"]
        for row in met:
            a, b, normal = split(row, dimensions)
            lines.append(f"{{ const a = {self.fields(a)}, b = {self.fields(b)};")
            call = f"table.{rule}_collide_{dimensions}d(a, b, {self.array(normal)}, {self.numbers(row[-1:])})"
            lines.append(f"  const done = {call};")
            lines.append("  console.log([done, [a, b].map((each) => [each.velocity, each.spin])].flat(4).join(' ')); }")
        (folder / "main.mjs").write_text('import * as table from "./table.mjs";\n' + "\n".join(lines) + "\n")
        return rows(run("node", "main.mjs", cwd=folder))


class Rust(Language):
    nan, infinity, brackets = "f64::NAN", "f64::INFINITY", "[]"

    def run(self, folder, rule, asked, met, dimensions):
        lines = []
        for at in asked:
            calls = ", ".join(f"table::{rule}_{each}({self.numbers(at)})" for each in VALUES)
            lines.append(f'println!("{{}} {{}} {{}} {{}}", {calls});')
        kind = f"table::{rule}_body_{dimensions}d"
        for row in met:
            a, b, normal = split(row, dimensions)
            lines.append(f"{{ let mut a = {kind} {self.fields(a)}; let mut b = {kind} {self.fields(b)};")
            call = f"table::{rule}_collide_{dimensions}d(&mut a, &mut b, &{self.array(normal)}, {self.numbers(row[-1:])})"
            spins = "&[each.spin]" if dimensions == 2 else "&each.spin"
            lines.append(f'  print!("{{}}", {call});')
            lines.append("  for each in &[a, b] {")
            lines.append(f'    for x in each.velocity.iter().chain({spins}) {{ print!(" {{}}", x); }} }}')
            lines.append("  println!(); }")
        (folder / "main.rs").write_text("mod table;\nfn main() {\n" + "\n".join(lines) + "\n}\n")
        (folder / "unused.rs").write_text("mod table;\nfn main() {}\n")
        for program in ("unused", "main"):
            run("rustc", "--edition", "2018", "-D", "warnings", f"{program}.rs", cwd=folder)
        return rows(run("./main", cwd=folder))


@pytest.mark.skipif(shutil.which("cc") is None, reason="needs cc")
@pytest.mark.parametrize("dimensions", [2, 3])
@pytest.mark.parametrize("name", SPEEDS)
@pytest.mark.parametrize("program, language, form", [("node", JavaScript(), "mjs"), ("rustc", Rust(), "rs")])
def test_a_rule_is_that_of_the_header(tmp_path, program, language, form, name, dimensions):
    if shutil.which(program) is None:
        pytest.skip(f"needs {program}")
    slowest, fastest = SPEEDS[name]
    for each in ("h", form):
        shutil.copy(TABLES / f"{name}.{each}", tmp_path / f"table.{each}")
    asked, met = arguments(slowest, fastest), encounters(fastest)
    expected, got = (each.run(tmp_path, f"{name}_rule", asked, met, dimensions) for each in (C(), language))
    collided = [row[0] for row in expected[len(asked) :]]
    assert len(expected) == len(asked) + len(met) and {-1, 0, 1} <= set(collided) and collided.count(1) > 10
    # Square roots and logarithms of one language may differ from those of another in the last place.
    assert got == [pytest.approx(each, rel=1e-13, abs=1e-15, nan_ok=True) for each in expected]


@pytest.mark.parametrize("form", ["rust", "js"])
def test_the_command_writes_them(stoss, tmp_path, form):
    job = "table --body sphere --poisson 0.3 --speed 1e-3:1.1e-3 --oblique --tolerance 0.2 --error 0.05 --name balls"
    done = stoss.run(job, f"--format {form}")
    assert done.returncode == 0, done.stderr
    assert "balls_rule_collide_3d(" in done.stdout and "BALLS_RULE_SLOWEST" in done.stdout
