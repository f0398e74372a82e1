"""Bodies of files, by their modes at a point: --body @FILE and --against @FILE."""

import json
import pathlib
import re

import pytest
from conftest import number

FILES = pathlib.Path(__file__).parents[2] / "examples" / "any_body"
SPHERE = "--body sphere --radius 0.01 --young 210e9 --poisson 0.3 --density 7850"


def lost(stoss, arguments):
    """1 − ε² and its error, by arguments with --speed."""
    result = stoss.run("restitution --tolerance 0.4 --format json", arguments)
    row = json.loads(result.stdout)["records"][0]
    return row["lost_fraction"], row["lost_fraction_error"]


@pytest.mark.numbers
@pytest.mark.parametrize("against", ["wall", "half-space,material=glass", f"@{FILES}/bar.json", "same"])
def test_sphere_of_a_mesh_is_the_sphere(stoss, against):
    of_modes, error = lost(stoss, f"--body @{FILES}/sphere.json --against {against} --speed 0.5")
    exact, its_error = lost(stoss, f"{SPHERE} --against {against} --speed 0.5")
    assert abs(of_modes - exact) <= error + its_error
    assert error < 0.4 * of_modes  # the tolerance


@pytest.mark.numbers
@pytest.mark.parametrize("quality", [1000, 100])
def test_what_it_meets_has_the_modulus_of_its_frequency(stoss, quality):
    """Its E is that at 1 kHz: in the unit of time of a body of a file as in that of a ball."""
    half_space = f"--against half-space,young=7e10,poisson=0.22,density=2500,quality={quality} --speed 0.5"
    of_modes, error = lost(stoss, f"--body @{FILES}/sphere.json {half_space}")
    exact, its_error = lost(stoss, f"{SPHERE} {half_space}")
    assert abs(of_modes - exact) <= error + its_error
    assert error < 0.003 * of_modes


@pytest.mark.numbers
@pytest.mark.parametrize("bodies", [
    "--body @{0}/sphere.json --yield-strength 3e8", "--body @{0}/sphere.json --yield-strength 3e8 --against half-space,material=glass",
    "--body @{0}/sphere.json --yield-strength 3e8 --against plate,material=glass,thickness=0.02",
    "--body sphere --radius 0.01 --material 'structural steel' --against @{0}/sphere.json",
])  # fmt: skip
def test_predict_takes_bodies_of_files_as_balls(stoss, bodies):
    """With yield, of which nearly all is lost, as struck and as partner."""
    words = "predict --speed 0.01,0.5 --format json"
    found = json.loads(stoss.run(words, bodies.format(FILES)).stdout)["records"]
    same = bodies.replace("@{0}/sphere.json", "sphere --radius 0.01 --young 210e9 --poisson 0.3 --density 7850", 1)
    if "--against @" in bodies:
        same = bodies.replace("@{0}/sphere.json", "sphere,radius=0.01,young=210e9,poisson=0.3,density=7850")
    exact = json.loads(stoss.run(words, same).stdout)["records"]
    for one, other in zip(found, exact):
        both = one["restitution_error"] + other["restitution_error"] + 0.1 * other["by_models"]
        assert abs(one["restitution"] - other["restitution"]) <= both
        assert one["by_models"] == pytest.approx(other["by_models"], rel=0.02, abs=1e-6)
    assert found[-1]["yield"] > 0.1


STEEL = "radius=0.01,young=210e9,poisson=0.3,density=7850"


@pytest.mark.numbers
@pytest.mark.parametrize("ball", [
    "--body sphere --radius 0.005 --material 'bearing steel'", "--body @{0}/sphere.json",
    "--body @{0}/sphere.json --yield-strength 5e8",
])  # fmt: skip
@pytest.mark.parametrize("strength", ["yield_strength=3e8", "yield_strength=3e8,yield_hardening=2e9,yield_rate=0.02"])
def test_a_partner_of_a_file_yields_as_a_sphere_of_its_curvature(stoss, ball, strength):
    """Nearly all is lost to the dent, which knows nothing of the mesh."""
    for words in ("restitution --speed 0.2 --tolerance 0.4 --format json", "predict --speed 0.01,0.5 --format json"):
        found, exact = (json.loads(stoss.run(words, ball.format(FILES), f"--against {each},{strength}").stdout)["records"]
                        for each in (f"@{FILES}/sphere.json", f"sphere,{STEEL}"))  # fmt: skip
        for one, other in zip(found, exact):
            errors = one["restitution_error"] + other["restitution_error"] + 0.01 * other.get("by_models", 0.0)
            assert abs(one["restitution"] - other["restitution"]) <= errors
            assert one["restitution"] == pytest.approx(other["restitution"], rel=2e-3)
            assert one["restitution"] < 0.98
            for name in ("yield", "by_models", "yielded"):
                assert one.get(name) == pytest.approx(other.get(name), rel=5e-3), name


@pytest.mark.numbers
def test_a_table_of_predictions_takes_partners_of_files_that_yield(stoss):
    words = "table --predict --body sphere --radius 0.005 --material 'bearing steel' --speed 0.05:1 --error 1e-2 --format json"
    rows = [json.loads(stoss.run(words, f"--against {each},yield_strength=3e8").stdout)["records"]
            for each in (f"@{FILES}/sphere.json", f"sphere,{STEEL}")]  # fmt: skip
    for one, other in zip(*rows, strict=True):
        assert one["speed"] == other["speed"]
        assert one["restitution"] == pytest.approx(other["restitution"], rel=2e-3)


@pytest.mark.parametrize("ball", ["--radius 0.005", "--radius 0.005 --rigid-body", "--radius 0.02"])
def test_a_ball_is_told_to_yield_on_a_body_of_a_file_as_on_a_sphere(stoss, ball):
    told = [re.findall("the .* yields above [^)]*", stoss.run(f"impact --body sphere --material 'bearing steel' {ball} --against {each} --speed 3").stderr)
            for each in (f"@{FILES}/sphere.json", f"sphere,{STEEL}")]  # fmt: skip
    assert told[0] == told[1] and bool(told[0]) == ("rigid" not in ball)


@pytest.mark.parametrize("given, said", [
    ("sphere.json,yeld_strength=3e8", "'yeld_strength', allowed roughness, u0, coat"), ("sphere.json,yeld_strength=3e8", "did you mean yield_strength?"),
    ("sphere.json,material=glass", "with @FILE"), ("sphere.json,yield_strength=-1", "yield_strength: got -1"),
    ("sphere.json,yield_strength=x", "yield_strength: got 'x'"), ("sphere.json,yield_strength=1,yield_strength=2", "twice"),
    ("sphere.json,yield_rate=0.1", "yield_strength: missing"), ("sphere.json,young_is=relaxed", "young_is: the modes of a body file"),
])  # fmt: skip
def test_numbers_beside_a_file_are_those_of_its_face(stoss, given, said):
    result = stoss.run(f"restitution {SPHERE} --speed 0.1 --against @{FILES}/{given}")
    assert (result.returncode, result.stdout, result.stderr.count("\n")) == (3, "", 1), result.stderr
    assert said in result.stderr


def test_the_name_of_a_file_may_have_commas(stoss, tmp_path):
    path = tmp_path / "one,two.json"
    path.write_text((FILES / "sphere.json").read_text())
    words = f"restitution {SPHERE} --speed 0.1 --tolerance 0.4 --against"
    for more in ("", ",yield_strength=3e8"):
        assert stoss.data(words, f"@{path}{more}") == stoss.data(words, f"@{FILES}/sphere.json{more}") != []


@pytest.mark.parametrize("name, change, said", [
    ("young", 1e-9, "speed of sound"), ("density", 1e-3, "speed of sound"), ("young", 1e-6, "modes"),
    ("mass", 1e6, "one system of units"), ("mass", 1e-9, "one system of units"),
    ("compliance", 1e3, "one system of units"), ("frequency", 1e-3, "one system of units"), ("displacement", 1e3, "one system of units"),
])  # fmt: skip
@pytest.mark.parametrize("file", ["sphere", "beam_55", "bell"])
def test_numbers_in_other_units_are_told_in_one_line(stoss, tmp_path, file, name, change, said):
    body = json.loads((FILES / f"{file}.json").read_text())
    if name in body:
        body[name] *= change
    else:
        body["modes"][name] = [change * each for each in body["modes"][name]]
        body["complete_to"] *= change if name == "frequency" else 1.0
    path = tmp_path / "body.json"
    path.write_text(json.dumps(body))
    result = stoss.run(f"restitution --body sphere --radius 0.005 --material brass --against @{path} --speed 0.1")
    assert (result.returncode, result.stdout, result.stderr.count("\n")) == (3, "", 1), result.stderr
    assert said in result.stderr and "allowed" in result.stderr


@pytest.mark.parametrize("command", ["restitution", "impact", "oblique", "predict", "table", "distribution", "bounce"])
def test_a_file_that_cannot_be_read_is_an_error_of_input_and_output(stoss, tmp_path, command):
    for where in ("--body", f"{SPHERE} --against"):
        for path, reason in ((tmp_path / "none.json", "No such file"), (tmp_path, "Is a directory")):
            more = "--friction 0.1 --angle 20" if command == "oblique" else ""
            result = stoss.run(command, "--speed 0.1", where, f"@{path}", more)
            assert (result.returncode, result.stdout, result.stderr.count("\n")) == (4, "", 1), result.stderr
            assert "cannot read" in result.stderr and reason in result.stderr


@pytest.mark.parametrize("against", ["wall", "same", "half-space,material=glass"])
def test_what_is_kept_ends_where_modes_are_known(stoss, against):
    """Without a cutoff, those of a file are enough."""
    body, = stoss.data(f"impact --body @{FILES}/bar.json --speed 0.5 --against {against}")
    assert 1.3 < number(body, "cutoff") <= 1.36
    if against != "same":  # which does not come back
        stoss.data(f"bounce --body @{FILES}/bar.json --speed 0.5 --against {against} --count 2 --flight-time 1")


@pytest.mark.parametrize("file", ["bell", "bat_30"])
def test_a_ball_that_vibrates_meets_a_body_whose_curvatures_differ(stoss, file):
    """It begins where the ball and the other curvatures do not touch yet: "the body already touches the wall"."""
    ball = ("restitution --body sphere --poisson 0.3 --radius 0.05 --young 1e9 --density 1000 --speed 0.05 "
            f"--against @{FILES}/{file}.json")
    still, = json.loads(stoss.run(ball, "--format json").stdout)["records"]
    moved, = json.loads(stoss.run(ball, "--format json --mode 2,0,energy=1e-10").stdout)["records"]
    errors = still["restitution_error"] + moved["restitution_error"]
    assert abs(moved["restitution"] - still["restitution"]) <= errors
    assert moved["restitution_error"] < 2 * still["restitution_error"] + 1e-6


@pytest.mark.parametrize("words", ["restitution --mode 0,2,energy=0.1", "distribution --spectrum 0,2,energy=0.1"])
def test_what_is_known_at_a_point_does_not_vibrate_before(stoss, words):
    result = stoss.run(words, f"--body @{FILES}/bar.json --speed 0.1 --against wall")
    assert result.returncode == 3
    assert result.stderr.startswith("stoss: error: vibration: got a mode of 'bar', allowed modes of bodies that are known")


@pytest.mark.parametrize("words, said", [
    # what is taken where none is given is not refused, and neither is a value in other units
    ("impact --body @{}/beam_30.json --against sphere,poisson=-0.082,radius=0.167,young=3030000,density=3630 --speed 0.07", ""),
    ("distribution --body sphere --material brass --radius 0.002 --rigid-body --against half-space,material=PMMA --speed 0.1 "
     "--temperature 1e-3", "temperature: got bodies without modes that vibrate"),
    ("oblique --body rod --material brass --length 0.1 --area 1e-5 --speed 1 --friction 0 --spin 0.04",
     "spin: got one that is not 0, allowed only 0"),
    ("oblique --body rod --material brass --length 0.1 --area 1e-5 --speed 1 --friction 0.1",
     "friction: not available for 'rod', but"),
    ("restitution --body @{}/beam_30.json --against half-space,material=ice --speed 0.1", "'beam struck at x = 30 mm'"),
])  # fmt: skip
def test_no_message_is_of_what_was_not_given(stoss, words, said):
    result = stoss.run(words.format(FILES))
    assert said in result.stderr if said else result.returncode == 0, result.stderr
