"""Bodies that stay on thin plates: a note says that the plate is infinite."""

import pytest
from conftest import rows

pytestmark = pytest.mark.numbers

PLATE = "--body sphere --poisson 0.3 --speed 1e-5 --against plate,thickness=0.15"


def test_a_body_that_stays_comes_with_a_note(stoss):
    for words in (f"restitution {PLATE}", f"oblique {PLATE} --angle 75 --friction 0.1"):
        result = stoss.run(f"{words} --format csv")
        assert result.returncode == 0
        (row,) = rows(result.stdout)
        assert row["stays"] == "true" and float(row["restitution"]) == 0.0
        assert result.stderr.count("never returns what it takes") == 1
        assert stoss.run(f"{words} --quiet").stderr == ""
    assert "never returns" in stoss.run(f"impact {PLATE} --cutoff 8").stderr


def test_a_body_that_parts_has_none(stoss):
    result = stoss.run("restitution --body sphere --poisson 0.3 --speed 1e-3 --against plate,thickness=2 --format csv")
    assert rows(result.stdout)[0]["stays"] == "false" and result.stderr == ""


def test_a_small_value_comes_with_a_note(stoss):
    """As 0 does: of a real plate waves from its rim may throw the ball off."""
    ball = (
        "restitution --radius 0.01 --material 'bearing steel' --speed 1 --tolerance 0.05 --against plate,material=glass"
    )
    for thickness, notes in ((0.005, 1), (0.02, 0)):
        result = stoss.run(f"{ball},thickness={thickness}")
        assert result.returncode == 0
        assert (
            result.stderr.count("may throw the body off with much more (python -m stoss.modal --plate LxWxH --edge")
            == notes
        )


def test_a_disk_on_a_strip_has_a_value_with_friction(stoss):
    disk = "--body disk --poisson 0.3 --speed 0.01 --angle 60 --friction 0.1 --against strip,thickness=0.4"
    result = stoss.run(f"oblique {disk} --format csv")
    (row,) = rows(result.stdout)
    assert float(row["restitution"]) == 0.0 and row["converged"] == "true" and row["stays"] == "true"
