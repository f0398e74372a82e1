"""Rows of disks are those of a plain program of modes, a static tail and one active set for all contacts."""

import json

import pytest

pytest.importorskip("scipy")
from plain_disks import row

pytestmark = pytest.mark.numbers

CASES = {
    "cradle": ([0.1, 0.0, 0.0], False, "--count 3 --speed 0.1"),
    "drop": ([0.1, 0.1], True, "--count 2 --speed 0.1,0.1 --against wall"),
}


@pytest.mark.parametrize("case", CASES)
def test_rows_are_what_a_plain_program_comes_to(stoss, case):
    speeds, wall, words = CASES[case]
    result = stoss.run(f"row --body disk --poisson 0.3 {words} --tolerance 5e-4 --format json")
    found = json.loads(result.stdout)["records"][0]["velocities_after"]
    plain = row(speeds, 30.0, wall)
    assert max(abs(each / 0.1 - its) for each, its in zip(found, plain)) < 1.5e-3
