"""stoss table as modules of Rust and JavaScript: they give what the header in C gives, inside, at and beyond the range."""

import math
import os
import shutil
import subprocess

import pytest

pytestmark = pytest.mark.numbers

TABLES = {
    "disk": "table --body disk --poisson 0.33 --speed 1e-2:0.1 --error 0.01",
    "Ball_2": "table --body sphere --poisson 0.3 --young 7e10 --density 2500 --radius 0.005 --speed 0.1:1 --beyond error --name Ball_2",
    "pairs": "table --body disk --poisson 0.33 --speed 1e-2:0.1 --against same --ratio 1:3 --error 0.02",
    "unequal": "table --body disk --poisson 0.33 --speed 1e-2:0.1 --against disk,poisson=0.2,radius=2 --ratio 1:3 --error 0.02"
    " --beyond error",
}
SPEEDS = [0.0, -0.0, 5e-324, 9.999e-3, 0.01, 0.0123, -0.034, 0.0999999, 0.1, 0.1000001, -0.37, 1.0, 1.7, 1e300, math.inf, math.nan]
RATIOS = [-1.0, 0.0, 0.2, 1 / 3, 0.5, 1.0, 1.3, 2.0, 3.0, 3.1, math.inf, math.nan]


def call(job):
    """Prefix of the functions of a table, and what they are asked."""
    prefix = job.partition(" --name ")[2] or "stoss"
    if "--ratio" in job:
        return f"{prefix}_pair", [(v, r) for v in SPEEDS for r in RATIOS]
    return prefix, [(v,) for v in SPEEDS]


def told(number, nan, infinity):
    return nan if math.isnan(number) else repr(number).replace("inf", infinity)


def rows(text):
    return [tuple(map(float, line.split())) for line in text.replace("Infinity", "inf").splitlines()]


def run(*words, cwd):
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def write(stoss, folder, job, form, name):
    done = stoss.run(job, f"--format {form} -o {folder / name}")
    assert (done.returncode, done.stdout) == (0, ""), done.stderr


def in_c(stoss, folder, job):
    write(stoss, folder, job, "c", "table.h")
    prefix, asked = call(job)
    lines = ""
    for each in asked:
        given = ", ".join(told(number, "NAN", "INFINITY") for number in each)
        lines += f'printf("%.17g %.17g\\n", {prefix}_restitution({given}), {prefix}_restitution_error({given}));\n'
    (folder / "main.c").write_text(f'#include <stdio.h>\n#include "table.h"\nint main(void) {{\n{lines}return 0;\n}}\n')
    run("cc", "-O1", "main.c", "-o", "in_c", "-lm", cwd=folder)
    return rows(run("./in_c", cwd=folder))


def in_js(stoss, folder, job):
    write(stoss, folder, job, "js", "table.mjs")
    prefix, asked = call(job)
    given = ", ".join("[" + ", ".join(told(number, "NaN", "Infinity") for number in each) + "]" for each in asked)
    (folder / "main.mjs").write_text(
        'import * as table from "./table.mjs";\n'
        f"for (const at of [{given}])\n"
        f"  console.log(`${{table.{prefix}_restitution(...at)}} ${{table.{prefix}_restitution_error(...at)}}`);\n"
        f"if (!(table.{prefix.upper()}_SLOWEST < table.{prefix.upper()}_FASTEST)) throw 1;\n"
    )
    return rows(run("node", "main.mjs", cwd=folder))


def in_rust(stoss, folder, job):
    write(stoss, folder, job, "rust", "table.rs")
    prefix, asked = call(job)
    lines = ""
    for each in asked:
        given = ", ".join(told(number, "f64::NAN", "f64::INFINITY") for number in each)
        lines += f'println!("{{}} {{}}", table::{prefix}_restitution({given}), table::{prefix}_restitution_error({given}));\n'
    (folder / "main.rs").write_text(f"mod table;\nfn main() {{\n{lines}}}\n")
    (folder / "unused.rs").write_text("mod table;\nfn main() {}\n")
    for program in ("unused", "main"):
        run("rustc", "--edition", "2018", "-D", "warnings", "-O", f"{program}.rs", cwd=folder)
    return rows(run("./main", cwd=folder))


@pytest.mark.skipif(shutil.which("cc") is None, reason="needs cc")
@pytest.mark.parametrize("job", TABLES.values(), ids=TABLES)
@pytest.mark.parametrize("program, language", [("node", in_js), ("rustc", in_rust)])
def test_a_module_gives_what_the_header_gives(stoss, tmp_path, program, language, job):
    if shutil.which(program) is None:
        pytest.skip(f"needs {program}")
    expected, got = in_c(stoss, tmp_path, job), language(stoss, tmp_path, job)
    assert len(expected) == len(call(job)[1]) and sum(math.isfinite(error) for _, error in expected) >= 3
    # The logarithm of one language may differ from that of another in the last place.
    assert got == [pytest.approx(each, rel=0, abs=1e-15, nan_ok=True) for each in expected]


@pytest.mark.skipif(shutil.which("node") is None, reason="needs node")
def test_words_of_a_command_stay_in_the_comment(stoss, tmp_path):
    """A line of comment ends at U+2028 too in JavaScript, and Rust refuses marks of direction in it."""
    name = "a\u2028throw 1;\u202e\nthrow 2; *\u2066.mjs"
    words = [os.path.abspath(stoss.path), *TABLES["disk"].split(), "--format", "js", "-o", name]
    assert subprocess.run(words, cwd=tmp_path, timeout=60).returncode == 0
    text = (tmp_path / name).read_text(encoding="utf-8")
    assert not set(text) & set("\u2028\u2029\u202e\u2066")
    (tmp_path / "table.mjs").write_text(text, encoding="utf-8")
    run("node", "table.mjs", cwd=tmp_path)
