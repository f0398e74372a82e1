"""Plates with an edge that the command meshes by itself, against thin plates in closed form."""

import math

import numpy as np
import pytest
from conftest import UNITS

POISSON, THICKNESS = 0.3, 0.1
FEW = f"{UNITS} --poisson {POISSON} --modes 4 --errors-unknown --size-at-point 0.014"


def moving(body, least=1.0):
    """Angular frequencies of modes that move the middle, over those of a thin plate of side or radius 1: λ²."""
    f, moved = (np.array(body["modes"][name]) for name in ("frequency", "displacement"))
    unit = THICKNESS / math.sqrt(12 * (1 - POISSON**2))
    return 2 * math.pi * f[np.abs(moved) * math.sqrt(body["mass"]) > least] / unit


def mindlin(square):
    """λ² of a supported plate with the squared wave number λ² of a thin one: (κGk² − ω²)(Dk²/h + κG − ω²h²/12) = (κGk)²."""
    shear, bend = 5 / 6 / (2 * (1 + POISSON)), THICKNESS**2 / 12
    bulk = bend / (1 - POISSON**2)
    roots = np.roots([bend, -(shear + bulk * square + shear * bend * square), shear * bulk * square**2])
    return math.sqrt(min(roots) / bulk)


@pytest.mark.long
def test_supported_rectangle(modal):
    """Against Mindlin's plate, of which π²(m² + n²/b²) is the thin limit, and it moves the middle by 2/√M, nearly."""
    body = modal.body(f"--plate 1x1.2x{THICKNESS} --edge supported {FEW}", name="rectangle.json")
    assert body["held"] and body["mass"] == pytest.approx(1.2 * THICKNESS)
    thin = math.pi**2 * (1 + 1 / 1.44)
    assert moving(body)[0] == pytest.approx(mindlin(thin), rel=5e-3)
    assert mindlin(thin) == pytest.approx(thin, rel=0.05)
    first = np.abs(body["modes"]["displacement"][0]) * math.sqrt(body["mass"])
    # Turning sections share the mass, and the upper face is drawn in where it is stretched.
    bent = thin * THICKNESS**2
    drawn_in = POISSON / (1 - POISSON) * bent / 8
    assert first == pytest.approx(2.0 / math.sqrt(1 + bent / 12) * (1 - drawn_in), rel=0.01)


@pytest.mark.long
def test_clamped_disc(modal):
    """10.2158 (Leissa), less by some per cent of shear."""
    body = modal.body(f"--disc 2x{THICKNESS} --edge clamped {FEW}", name="disc.json")
    assert moving(body)[0] == pytest.approx(10.2158, rel=0.04)
    assert body["mass"] == pytest.approx(math.pi * THICKNESS, rel=1e-3)


@pytest.mark.long
def test_free_disc_off_its_middle(modal):
    """5.3583 (ν = 0.3, two nodal diameters) moves the rim but not the middle."""
    body = modal.body(f"--disc 2x{THICKNESS} --at 0.5,0 {FEW}", name="free.json")
    assert "held" not in body and body["rotation"]["point"] == pytest.approx([0.5, 0, THICKNESS / 2], abs=1e-4)
    assert moving(body, 0.2)[0] == pytest.approx(5.3583, rel=0.04)


@pytest.mark.parametrize(
    "words, said",
    [
        ("--plate 1x1", "plate: got '1x1', allowed LxWxH"),
        ("--disc 1x0", "disc: got '1x0', allowed DxH"),
        ("--disc 1x0.004", "up to 200 thicknesses wide"),
        ("--plate 1x1x0.1 --at 0.45,0", "at: got 0.05 from the edge, allowed a thickness, 0.1, or more"),
        ("--plate 1x1x0.1 --point 0,0,0", "point: with a plate, which has its own"),
        ("--plate 1x1x0.1 --disc 1x0.1", "give a plate or a disc, not both"),
        ("--edge free", "edge: is of a plate or a disc"),
        ("--point 0,0,0", "mesh: missing"),
    ],
)
def test_refusals(modal, words, said):
    done = modal.run(f"{words} --material glass -o refused.json")
    assert done.returncode == 2 and said in done.stderr, done.stderr
    assert "Traceback" not in done.stderr
