"""stoss row: bodies on one line."""

import csv
import io
import json

import pytest

BALLS = "row --body sphere --poisson 0.3"
# Own spectral elements, ball after ball, hard smooth contacts, uncertainty 2e-5: velocities over the first speed.
CRADLES = {
    (3, 0.1): [-0.02709, 0.03197, 0.99512],
    (3, 0.02): [-0.04760, 0.05040, 0.99720],
    (5, 0.1): [-0.02709, -0.00827, -0.00279, 0.04338, 0.99477],
}


def record(stoss, *words):
    result = stoss.run(*words, "--format json")
    assert result.returncode == 0, result.stderr
    document = json.loads(result.stdout)
    assert document["schema"] == "stoss/row/2" and document["complete"]
    return document["records"][0]


@pytest.mark.parametrize("count, speed", CRADLES)
def test_cradles_are_those_of_finite_elements(stoss, count, speed):
    row = record(stoss, f"{BALLS} --count {count} --speed {speed}")
    assert row["converged"] and row["velocities"] == [speed] + [0.0] * (count - 1)
    assert sum(row["velocities_after"]) == pytest.approx(speed, rel=1e-12)
    for after, error, known in zip(row["velocities_after"], row["velocities_after_error"], CRADLES[count, speed]):
        assert error < 1e-3 * speed
        assert abs(after - known * speed) < error + 2e-5 * speed
    assert [each["left"] for each in row["contacts"]] == list(range(count - 1))
    shares = [row[name] for name in ("translation", "vibration", "dissipated", "yielded", "unresolved")]
    assert sum(shares) == pytest.approx(1.0, abs=1e-4)


def test_in_si_speeds_and_velocities_are_in_the_same_unit(stoss):
    balls = "row --body sphere --material glass --radius 0.01 --count 3"
    row = record(stoss, f"{balls} --speed 0.5,0.5")
    assert row["velocity_unit"] == "m/s" and row["velocities"] == pytest.approx([0.5, 0.5, 0.0])
    text = stoss.run(f"{balls} --speed 0.5,0.5 --format csv").stdout
    lines = list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))
    assert [float(each["velocity_after_si[m/s]"]) for each in lines] == pytest.approx(row["velocities_after"], rel=1e-14)
    table = stoss.run(f"{balls} --speed 0.5,0.5").stdout
    assert "m/s" in table and max(map(len, table.splitlines())) <= 80


def test_a_document_has_bodies_of_their_own(stoss, tmp_path):
    document = {"bodies": [{"kind": "sphere", "poisson": 0.3}, {"kind": "sphere", "radius": 2, "density": 0.5}],
                "after": "wall", "gaps": [0.001, 0]}  # fmt: skip
    path = tmp_path / "row.json"
    path.write_text(json.dumps(document))
    row = record(stoss, f"row --bodies {path} --speed 0.01")
    again = tmp_path / "again.json"
    made = json.loads(stoss.run(f"row --bodies {path} --speed 0.01 --format json").stdout)
    again.write_text(json.dumps(made["inputs"]["row"]))
    assert record(stoss, f"row --bodies @{again} --speed 0.01") == row
    assert "beside a document" in stoss.run(f"row --bodies {path} --count 2 --speed 0.01").stderr


def test_walls_at_either_end_are_mirror_images(stoss):
    right = record(stoss, f"{BALLS} --count 2 --speed 0.01 --against wall --gap 0,0.001")
    left = record(stoss, f"{BALLS} --count 2 --speed 0,-0.01 --before wall --gap 0.001,0")
    for one, other in zip(right["velocities_after"], reversed(left["velocities_after"])):
        assert one == pytest.approx(-other, abs=1e-9)


def test_a_time_to_stop_says_how_fast_bodies_are_then(stoss):
    forever = f"{BALLS} --count 1 --speed 0.01 --before wall --against wall --gap 0.01"
    result = stoss.run(forever)
    assert result.returncode == 1 and "bodies may meet again" in result.stderr
    assert record(stoss, f"{forever} --until 12.5")["velocities_after"] == pytest.approx([-0.0099861], rel=1e-4)


@pytest.mark.parametrize("words, line", {
    "--speed 0,0,0": "speed: got no two bodies that meet",
    "--speed 0.1,0,0,0": "speed: got 4 values, allowed 1 to 3",
    "--speed 2": "speed: got 2, allowed -1 to 1 c",
    "--speed nan": "speed: got 'nan'",
    "--speed 0.1 --count 0": "count: got 0, allowed 1 to 100",
    "--speed 0.1 --count 1": "bodies: got 1, allowed 2 to 100",
    "--speed 0.1 --gap 1,2,3": "gaps: got 3 values, allowed 2",
    "--speed 0.1 --gap -1": "gap: got -1, allowed 0 to 1000 R",
    "--speed 0.1 --tolerance 1e-9": "tolerance: got 1e-09, allowed 1e-6 to 1",
    "--speed 0.1 --against exponential,hardness=200": "after: got exponential, allowed a wall, a half-space or a plate",
    "--speed 0.1 --bodies missing.json": "bodies: --body beside a document",
    "--speed 0.1 --before ice": "before",
    "--speed 0.1 --against sphere,poisson=0.3": "after: got sphere, allowed a wall, a half-space or a plate",
    "--speed 0.1 --against wall,roughness=1e-3": "after: got a wall with roughness",
    "--speed 0.1 --against disk,poisson=0.3": "against: got disk",
}.items())  # fmt: skip
def test_refuses_in_one_line(stoss, words, line):
    result = stoss.run(f"{BALLS} {words}")
    assert result.returncode in (2, 3) and len(result.stderr.splitlines()) == 1
    assert line in result.stderr, result.stderr


@pytest.mark.numbers
def test_every_contact_is_looked_at_for_yielding(stoss, tmp_path):
    steel, brass = ({"kind": "sphere", "material": name, "radius": 0.01} for name in ("bearing steel", "brass"))
    path = tmp_path / "row.json"
    path.write_text(json.dumps({"bodies": [steel, steel, brass, steel], "after": "wall", "gaps": [0, 0, 0, 1e-3]}))
    said = stoss.run(f"row --bodies {path} --speed 0.2").stderr.splitlines()
    assert len(said) == 3, said  # the first contact holds 0.2 m/s, steel does not yield up to 0.256
    assert any("the other ball yields above" in line and "contact 1 is pressed as hard as by" in line for line in said)
    assert any("the ball yields above" in line and "contact 2" in line for line in said)
    assert any("contact 3" in line for line in said)
    assert stoss.run(f"row --bodies {path} --speed 0.001").stderr == ""


def test_two_balls_of_a_material_are_warned_of_as_a_pair(stoss):
    balls = "--body sphere --material 'bearing steel' --radius 0.01 --speed"
    for speed in (0.25, 0.265):
        row = stoss.run(f"row --count 2 {balls} {speed}")
        pair = stoss.run(f"restitution --against same {balls} {speed}")
        assert ("yields" in row.stderr) == ("yields" in pair.stderr) == (speed > 0.26)


def test_any_body_may_vibrate(stoss, tmp_path):
    mode = {"order": 2, "index": 0, "energy": 0.1, "phase": 1.0}
    found = record(stoss, f"{BALLS} --count 3 --speed 0.05 --mode 2,0,energy=0.1,phase=1,body=2")
    path = tmp_path / "row.json"
    balls = [{"kind": "sphere", "poisson": 0.3}] * 3
    path.write_text(json.dumps({"bodies": balls, "vibration": [{"body": 2, **mode}]}))
    assert record(stoss, f"row --bodies {path} --speed 0.05") == found
    assert found["vibration"] > 0.1
    ringing = f"{BALLS} --speed 0.05 --mode 2,0,energy=1"
    assert "vibration body: got 3, allowed 0 to 2" in stoss.run(f"{ringing},body=3").stderr
    assert "got 'of', allowed energy, phase, body" in stoss.run(f"{ringing},of=second").stderr


@pytest.mark.parametrize("gap", [1, 1000])
def test_far_flights_take_no_time(stoss, gap):
    row = record(stoss, f"{BALLS} --count 3 --speed 0.05 --gap {gap}")
    assert row["converged"] and row["steps"] < 40_000 and row["duration"] > 1e4
    assert abs(row["momentum_error"]) < 1e-12 and abs(row["energy_error"]) < 1e-4
