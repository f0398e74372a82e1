"""Bodies of files that have a tangent, with friction: stoss oblique."""

import json
import pathlib

import pytest

FILES = pathlib.Path(__file__).parents[2] / "examples" / "any_body"
SPHERE = "--body sphere --radius 0.01 --young 210e9 --poisson 0.3 --density 7850"
OBLIQUE = "oblique --speed 0.5 --friction 0.3 --angle 5,20,45 --format json"


@pytest.mark.numbers
@pytest.mark.parametrize("against", ["wall", "half-space,material=glass", "same"])
def test_sphere_of_a_mesh_rubs_as_the_sphere(stoss, against):
    every = [json.loads(stoss.run(OBLIQUE, f"--body {each} --against {against}").stdout)["records"]
             for each in (f"@{FILES}/sphere.json", SPHERE.removeprefix("--body "))]  # fmt: skip
    for found, exact in zip(*every):
        for name in ("restitution", "tangential_restitution", "sliding_after", "spin_after"):
            assert abs(found[name] - exact[name]) <= found[f"{name}_error"] + exact[f"{name}_error"], name
        assert found["tangential_restitution_error"] < 0.02


@pytest.mark.numbers
@pytest.mark.parametrize("motion", [
    "--speed 0.02,5 --angle 1,30,80 --friction 0.05", "--speed 1 --angle 60 --friction 1", "--speed 1 --angle 45 --friction 1e-9",
    "--speed 0.5 --tangential 0 --spin 20,-200 --friction 0.2", "--speed 0.5 --tangential 0.3 --spin -50 --friction 0.5",
])  # fmt: skip
def test_at_other_speeds_angles_frictions_and_spins_too(stoss, motion):
    """In SI; what turns has the mesh's arm, a polyhedron's, which is less by some 1e-5."""
    found, exact = (json.loads(stoss.run("oblique --format json", motion, each).stdout)["records"]
                    for each in (f"--body @{FILES}/sphere.json", SPHERE))  # fmt: skip
    for one, other in zip(found, exact, strict=True):
        for name in ("restitution", "sliding_after_si", "tangential_after_si", "spin_after_si", "friction_loss"):
            allowed = one[f"{name}_error"] + other[f"{name}_error"] + 3e-5 * abs(other[name])
            assert abs(one[name] - other[name]) <= allowed, name


@pytest.mark.numbers
@pytest.mark.parametrize("bodies, turning", [
    (f"--body @{FILES}/sphere.json", 3.5), (f"--body @{FILES}/sphere.json --against same", 3.5),
    (f"--body sphere --radius 0.005 --material 'bearing steel' --against @{FILES}/beam_0.json", 3.467),
])  # fmt: skip
def test_what_slides_all_the_time_obeys_coulombs_law(stoss, bodies, turning):
    """s falls by μ (1 + ε) v times m (1/m + R²/I + …); a mirrored impact is the mirror image; without friction nothing changes."""
    words = f"oblique --speed 0.5 {bodies} --format json"
    for friction in (1e-9, 0.1):
        left, right = json.loads(stoss.run(words, f"--friction {friction} --tangential -20,20").stdout)["records"]
        lost = friction * (1 + right["restitution"]) * 0.5 * turning
        assert right["sliding_si"] - right["sliding_after_si"] == pytest.approx(lost, rel=2e-3, abs=1e-13)
        for name in ("sliding_after", "tangential_after", "spin_after", "second_spin_after"):
            assert left[name] == -right[name], name
        assert left["restitution"] == right["restitution"]
        assert 0 < right["friction_loss"] < 2 * friction
    smooth, = json.loads(stoss.run(words, "--friction 0 --tangential 20").stdout)["records"]
    assert smooth["sliding_after"] == smooth["sliding"] and smooth["spin_after"] == 0 == smooth["friction_loss"]


@pytest.mark.numbers
def test_ball_rubs_on_the_middle_of_a_beam(stoss):
    """Its normal motion is that of the central impact, and a block gives back more."""
    ball = "--body sphere --radius 0.005 --material 'bearing steel'"
    beam = f"--against @{FILES}/beam_0.json"
    rows = json.loads(stoss.run(OBLIQUE, ball, beam).stdout)["records"]
    thick = json.loads(stoss.run(OBLIQUE, ball, "--against half-space,material='structural steel'").stdout)["records"]
    central, = json.loads(stoss.run("restitution --speed 0.5 --tolerance 0.1 --format json", ball, beam).stdout)["records"]
    for row, its in zip(rows, thick):
        assert abs(row["restitution"] - central["restitution"]) <= row["restitution_error"] + central["restitution_error"]
        assert row["restitution"] < 0.95 * its["restitution"]
        assert row["tangential_restitution_error"] < 0.03
        assert abs(row["tangential_restitution"]) <= 1


def test_friction_needs_a_tangent(stoss, tmp_path):
    """Without data along the surface one line says so; with them the body rubs and turns."""
    rub = "oblique --speed 0.05 --tangential 0.1 --friction 0.05 --tolerance 0.05 --format json"
    for bodies in (f"--body @{FILES}/hollow_sphere_mesh.json", f"{SPHERE} --against @{FILES}/bell.json"):
        refused = stoss.run(rub, bodies)
        assert refused.returncode == 3 and refused.stdout == "" and refused.stderr.count("\n") == 1
        assert "tangential data" in refused.stderr and "allowed" in refused.stderr
        assert stoss.run(rub.replace("--friction 0.05", "--friction 0"), bodies).returncode == 0
    body = json.loads((FILES / "sphere.json").read_text())
    body["tangent"] = {"direction": [0, 1, 0], "compliance": 0}  # where all slides they do not matter
    body["modes"]["tangential_displacement"] = [0] * len(body["modes"]["frequency"])
    path = tmp_path / "rough.json"
    path.write_text(json.dumps(body))
    found, exact = (json.loads(stoss.run(rub, each).stdout)["records"][0] for each in (f"--body @{path}", SPHERE))
    for name in ("tangential_restitution", "spin_after"):
        allowed = found[f"{name}_error"] + exact[f"{name}_error"]
        assert abs(found[name] - exact[name]) <= allowed, name
        assert found[name] == pytest.approx(exact[name], rel=2e-3), name
    body["tangent"]["direction"] = [6, 0, 8]
    path.write_text(json.dumps(body))
    assert "perpendicular" in stoss.run(rub, f"--body @{path}").stderr
