"""What docs/howto/programs.md says of constants follows from what its code prints (which
tests/python/package/test_guide.py runs), and its choice of laws from docs/reference/laws.md."""

import re

from conftest import page

PAGE, WORDS = page("docs/howto/programs.md")
LINES = [tuple(map(float, line)) for line in re.findall(r"wrong by ([\d.]+), loss × ([\d.]+) to ([\d.]+)", PAGE)]


def test_a_constant_over_a_factor_of_two():
    _, low, high = LINES[0]
    assert max(high - 1, 1 - low) <= 1 / 3


def test_a_constant_over_two_decades():
    assert f"wrong by only {LINES[2][0]:.3f}" in WORDS and f"lose {LINES[2][2]:.0f} times too much" in WORDS


def test_laws_and_what_was_tried_are_those_of_the_page_of_laws():
    laws, _ = page("docs/reference/laws.md")
    known = [line.split(" | ") for line in laws.partition("## The programs")[2].splitlines() if line.startswith("| ")]
    advised = re.findall(r"^\| ([^|]*) \| `stoss fit … --law (\S+) --program \w+`[^|]*\| (yes|never run) \|$", PAGE, re.M)
    assert len(advised) == 17
    for programs, law, tried in advised:
        name = re.sub("^Altair ", "", programs)
        (row,) = (row for row in known if re.match(rf"\| {name}\b", row[0]))
        assert f"`{law}`" in row[2] and ("not tried" in row[-1]) == (tried == "never run"), name
