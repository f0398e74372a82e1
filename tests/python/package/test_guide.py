"""The Python in the pages of docs/ and README.md that have some runs as it stands, and prints what
they say.

All ```python blocks of a page run in order in one namespace. What they print is compared with a
```text block that follows at once, or with a comment `# → …` at the end of a statement. Words must
agree, and numbers to what is shown of them: x ± e within e, others to two units of their last
digit. An … stands for anything. A StossWarning is output too: the page shows it as a line
`StossWarning: …` at the end of the ```text block, or keeps within what the result is good for.
"""

import ast
import contextlib
import importlib.util
import io
import math
import os
import re
import shutil
import subprocess
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
import stoss

ROOT = Path(__file__).parents[3]
TOUR = "docs/tutorials/vibrating_bodies.md"
NOT_RUN = {"docs/architecture.md"}  # its Python is a part of the package: tests/docs/test_pages.py
PAGES = sorted(
    page for each in [ROOT / "README.md", *ROOT.glob("docs/**/*.md")]
    if (page := str(each.relative_to(ROOT))) not in NOT_RUN and "```python\n" in each.read_text(encoding="utf-8")
)  # fmt: skip
# Pictures that a page draws and shows.
PICTURES = {
    TOUR: [f"vibrating_{name}.png" for name in ("phase", "warm", "bounces")],
    "docs/howto/plates.md": ["restitution.png"],
}
FILES = {  # that a page reads
    "docs/tutorials/cad.md": "examples/any_body/beam_55.json", "docs/howto/loss.md": "studies/relaxing/happy.csv",
    "docs/understand/findings/relaxing.md": "studies/relaxing/happy.csv",
}  # fmt: skip
COMMANDS = {"docs/reference/tables.md": "stoss table --body disk --poisson 0.33 --speed 1e-4:0.3 --format json -o restitution.json"}
PROGRAMS = {"docs/tutorials/lammps.md": "lmp"}  # that a page runs
FENCED = re.compile(r"^```(\w*)\n(.*?)^```$\n?", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?(?![\w.]*\d)")


def last_digit(number):
    """The value of one unit of the last digit that is shown."""
    mantissa, _, exponent = number.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def same_number(got, shown):
    whole = "." not in shown and "e" not in shown.lower()
    if whole and "." not in got:
        return int(got) == int(shown)
    allowed = min(2.0 * last_digit(shown), 0.3 * abs(float(shown)) or math.inf)
    return abs(float(got) - float(shown)) <= allowed * (1 + 1e-9)


def tokens(text):
    return re.findall(rf"{NUMBER.pattern}|\w+|[^\w\s]", text)


def all_agree(got, shown):
    if len(got) != len(shown):
        return False
    for k, (mine, theirs) in enumerate(zip(got, shown)):
        if not NUMBER.fullmatch(theirs):
            right = mine == theirs
        elif not NUMBER.fullmatch(mine):
            right = False
        elif shown[k + 1 : k + 2] == ["±"] and k + 2 < len(got):  # a value with its error
            right = abs(float(mine) - float(theirs)) <= float(got[k + 2])
        elif shown[k - 1 : k] == ["±"]:
            right = 0.4 <= float(mine) / float(theirs) <= 2.5
        else:
            right = same_number(mine, theirs)
        if not right:
            return False
    return True


def agrees(got, shown):
    got, shown = tokens(got), tokens(shown)
    if "…" not in shown:
        return all_agree(got, shown)
    k = shown.index("…")
    head, tail = shown[:k], shown[k + 1 :]
    rest = len(got) - len(tail)
    return rest >= k and all_agree(got[:k], head) and all_agree(got[rest:], tail)


def blocks(page):
    """(first line, code, text that follows or None) of each block of Python."""
    text = (ROOT / page).read_text(encoding="utf-8")
    found = list(FENCED.finditer(text))
    for this, following in zip(found, found[1:] + [None]):
        if this.group(1) != "python":
            continue
        at_once = following and following.group(1) == "text" and not text[this.end() : following.start()].strip()
        yield text[: this.start(2)].count("\n") + 1, this.group(2), following.group(2) if at_once else None


def run(code, first_line, names):
    """Runs the statements one by one; yields (line, what the statement printed or is, its comment
    or None)."""
    lines = code.splitlines()
    for statement in ast.parse(code).body:
        printed = io.StringIO()
        value = None
        with contextlib.redirect_stdout(printed):
            if isinstance(statement, ast.Expr):
                value = eval(compile(ast.Expression(statement.value), "<page>", "eval"), names)
            else:
                exec(compile(ast.Module([statement], []), "<page>", "exec"), names)
        _, arrow, comment = lines[statement.end_lineno - 1].partition("# → ")
        said = printed.getvalue() or ("" if value is None else repr(value))
        yield first_line + statement.end_lineno - 1, printed.getvalue(), said, comment if arrow else None


@pytest.mark.parametrize("page", PAGES)
def test_page(page, tmp_path, monkeypatch):
    if page in PROGRAMS and shutil.which(PROGRAMS[page]) is None:
        pytest.skip(f"needs {PROGRAMS[page]}")
    if page in FILES:
        shutil.copy(ROOT / FILES[page], tmp_path)
    if page in COMMANDS:
        assert COMMANDS[page] in (ROOT / page).read_text(encoding="utf-8")
        subprocess.run([os.environ["STOSS"], *COMMANDS[page].split()[1:]], cwd=tmp_path, check=True, capture_output=True)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(plt, "show", lambda *_, **__: None)
    plt.switch_backend("Agg")
    names = {"__name__": "__page__"}
    compared, wrong = 0, []
    for first_line, code, text in blocks(page):
        output = ""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", stoss.StossWarning)
            for line, printed, said, comment in run(code, first_line, names):
                output += printed
                if comment is not None:
                    compared += 1
                    if not agrees(said, comment):
                        wrong.append(f"{page}:{line}: got {said.strip()!r}, the page says {comment!r}")
        warned = dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, stoss.StossWarning))
        warned = [each for each in warned if each not in output]  # a program may print what it is warned of
        output += "".join(f"StossWarning: {each}\n" for each in warned)
        if text is None and warned:
            wrong.append(f"{page}:{first_line}: warns, which the page does not show:\n{output}")
        if text is not None:
            compared += 1
            if not agrees(output, text):
                wrong.append(f"{page}:{first_line}: got\n{output}the page says\n{text}")
    plt.close("all")
    assert not wrong, "\n" + "\n".join(wrong)
    assert compared
    for name in PICTURES.get(page, ()):
        assert_same_picture(tmp_path / name, ROOT / "docs/images" / name)


def assert_same_picture(*places):
    drawn, shown = map(plt.imread, places)
    assert drawn.shape == shown.shape
    assert np.mean(np.abs(drawn - shown).max(axis=-1) > 0.1) < 0.005  # rounding at the edges of lines


def test_picture_of_a_ball_on_a_block_is_what_its_program_draws_and_readme_says(tmp_path):
    spec = importlib.util.spec_from_file_location("ball_on_block", ROOT / "studies/half_space/ball_on_block.py")
    program = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(program)
    plt.switch_backend("Agg")
    program.draw().savefig(tmp_path / "drawn.png")
    plt.close("all")
    assert_same_picture(tmp_path / "drawn.png", ROOT / "docs/images/ball_on_block.png")
    r = stoss.restitution(program.BALL, against=program.BLOCK, speed=program.SPEED)
    steel = stoss.Sphere(radius=1.0, material=stoss.materials["structural steel"]).scales.speed
    rubber = stoss.Sphere(radius=1.0, material=stoss.materials["rubber"]).scales.speed
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    assert f"at {program.SPEED:g} c, where c = √(E/ρ)" in readme
    assert f"{program.SPEED * rubber:.0f} m/s in soft rubber, {round(program.SPEED * steel, -1):.0f} m/s in steel" in readme
    assert f"Waves take {100 * r.lost_to_second:.0f} % of the energy, and {100 * r.lost_to_first:.1f} % stays" in readme


def test_losses_to_plates_of_the_readme_are_those_of_the_picture():
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"], loss_time=0)
    glass = {"material": stoss.materials["glass"], "loss_time": 0}
    partners = stoss.HalfSpace(**glass), stoss.Plate(thickness=20e-3, **glass), stoss.Plate(thickness=6e-3, **glass)
    block, thick, thin = (100 * float(stoss.restitution(ball, against=each, speed=1.0).lost_fraction) for each in partners)
    assert f"loses {block:.1f} % of its energy to waves" in readme
    assert f"{thick:.0f} % to a plate of 20 mm and {thin:.0f} % to one of 6 mm" in readme


@pytest.mark.parametrize(
    "got, shown, answer",
    [
        ("0.947044 ± 0.000046", "0.94704 ± 0.00005", True),
        ("0.947044 ± 0.000046", "0.94714 ± 0.00005", False),
        ("0.947044 ± 0.000046", "0.94704 ± 0.00050", False),
        ("421 modes, omega 1.43853", "421 modes, omega 1.4385", True),
        ("421 modes, omega 1.43853", "421 modes, omega 1.3383", False),
        ("421 modes", "422 modes", False),
        ("421 modes", "421 roots", False),
        ("(50,)", "(50,)", True),
        ("(50,)", "(5,)", False),
        ("a b 3 c 2.5 d", "a … 2.5 d", True),
        ("a b 3 c 2.5 d", "a … 2.9 d", False),
        ("f(a=1, b=2: c 0.9470 ± 0.0003)", "f(… c 0.9471 ± 0.0003)", True),
        ("f(a=1, b=2: c 0.9470 ± 0.0003)", "f(… c 0.9475 ± 0.0003)", False),
        ("-0.5", "0.5", False),
        ("1e-05", "1e-4", False),
        ("array([0.1, 0.25])", "array([0.1, 0.2])", True),
        ("array([0.1, 0.25])", "array([0.1])", False),
    ],
)
def test_comparison(got, shown, answer):
    assert agrees(got, shown) is answer
