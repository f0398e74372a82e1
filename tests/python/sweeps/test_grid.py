"""What no grid may be, grids that are too large, and the fair shares of shards."""

import re
import time
from pathlib import Path

import numpy as np
import pytest

import stoss
from stoss._subcommands import sample

BALLS = {"kind": "sphere", "poisson": [0.1, 0.3]}
PAGE = Path(__file__).parents[3] / "docs/howto/sweeps.md"
SIZES = {"kind": "sphere", "poisson": 0.3, "radius": "lin:1:2:10000", "density": "lin:1:2:10"}


def grid(**changed):
    return stoss.Grid(**{"bodies": BALLS, "speed": [0.01, 0.03, 0.1], **changed})


@pytest.mark.parametrize("name", ["tolerance", "absolute"])
@pytest.mark.parametrize(
    "value", [np.nan, np.inf, -1.0, 10**400, 10**5000, "x", True, [1e-3]], ids=lambda value: str(type(value))
)
def test_accuracies_are_refused_by_name(name, value):
    with pytest.raises(stoss.InvalidInput, match=f"^{name}: got .*, allowed [^\n]*$"):
        grid(**{name: value})


@pytest.mark.parametrize(
    "changed, message",
    [
        ({"speed": "log:.1:.2:1000000000"}, "speed: got 'log:.1:.2:1000000000', allowed a number"),
        ({"bodies": {**BALLS, "radius": "lin:1:2:1000001"}}, "bodies: radius: got 'lin:1:2:1000001'"),
        ({"speed": "log:.1:.2:" + "9" * 5000}, "speed: got 'log:"),
        ({"speed": "log:1e-999999:1e999999:3"}, "speed: got 'log:"),
        ({"speed": "lin:0.1:1e400:3"}, "speed: got 'lin:"),
        ({"speed": [0.1, 10**5000]}, "speed: got"),
        ({"bodies": {**BALLS, "radius": 10**5000}}, "bodies: radius: got"),
        ({"bodies": {**BALLS, "radius": [1, 10**400]}}, "bodies: radius: got"),
        ({"bodies": {"kind": [["sphere"]]}}, "bodies: kind: got ['sphere'], allowed disk"),
        ({"bodies": {"kind": {"a": 1}}}, "bodies: kind: got"),
        ({"against": {"kind": {"a": 1}}}, "against: kind: got"),
        ({"bodies": []}, "bodies: got none"), ({"against": []}, "against: got none"), ({"speed": []},
         "speed: got none"),
        ({"speed": [0.1, 0.2, 0.1]}, "speed: got 0.1 twice"), ({"speed": [0.1, np.nan]}, "speed: got nan"),
        ({"bodies": [stoss.Sphere(poisson=0.1)] * 2}, "grid: got Sphere"), ({"bodies": "sphere"},
         "bodies: got 'sphere'"),
        ({"against": ["same", {"kind": "sphere"}]}, "grid: got Sphere"), ({"bodies": {**BALLS, "colour": 1}},
         'bodies: got "colour"'),
        ({"bodies": {"kind": "sphere", "poisson": np.nan}}, "bodies: got {"), ({"bodies": {"kind": "cube"}},
         "bodies: kind: got 'cube'"),
        ({"against": {"kind": "exponential", "hardness": 0}}, "hardness: got 0"), ({"against": stoss.HalfPlane()},
         "against: got HalfPlane"),
        ({"against": {"kind": "wall", "radius": 2}}, "against: got 'radius'"), ({"speed": "log:0:1:3"},
         "speed: got 'log:0:1:3'"),
        (
            {"bodies": [stoss.Sphere(poisson=0.1), stoss.Sphere(radius=1, material=stoss.materials["glass"])]},
            "bodies: got some with",
        ),
        (
            {"bodies": SIZES, "against": SIZES},
            "grid: got 10000000000 cases (100000 bodies, 100000 partners, 3 speeds), allowed 100000",
        ),
        (
            {"bodies": {**SIZES, "radius": [1, 2]}, "speed": np.linspace(0.1, 0.2, 50_001)},
            "grid: got 1000020 values (20 bodies, 1 partners, 50001 speeds), allowed 1000000",
        ),
    ],
)
def test_what_would_never_end_is_refused_at_once(changed, message):
    begin = time.process_time()
    with pytest.raises(stoss.InvalidInput) as error:
        grid(**changed)
    assert str(error.value).startswith(message) and "\n" not in str(error.value) and len(str(error.value)) < 300
    assert time.process_time() - begin < 1.0


@pytest.mark.parametrize("text", [f"speed = {'9' * 5000}", f"speed = {'[' * 5000}", "speed = \ud800", "[[bodies]", ""])
def test_toml_that_is_no_grid_is_refused_in_one_line(text, tmp_path):
    path = tmp_path / "grid.toml"
    path.write_bytes(text.encode("utf-8", "surrogatepass"))
    with pytest.raises(stoss.InvalidInput, match="^grid: got [^\n]*, allowed [^\n]*$"):
        stoss.Grid.from_toml(path)


@pytest.mark.parametrize("key", ["bodies", "against", "speed", "tolerance", "absolute", "radius", "kind", "material"])
@pytest.mark.parametrize("value", ["nan", "inf", "-1", '"x"', "{}", "[[]]", "{a = 1}", "1979-05-27", "false",
 '["", 1]'])
def test_any_wrong_value_in_toml_is_one_line(key, value, tmp_path):
    path = tmp_path / "grid.toml"
    usual = {"speed": "0.1", "bodies": '{kind = "sphere", radius = 1, material = "structural steel"}'}
    body = {"kind": '"sphere"', "radius": "1", "material": '"structural steel"', key: value}
    changed = {key: value} if key in "bodies against speed tolerance absolute" else {
        "bodies": f"{{{', '.join(f'{name} = {each}' for name, each in body.items())}}}"
    }  # fmt: skip
    path.write_text("\n".join(f"{name} = {each}" for name, each in {**usual, **changed}.items()))
    with pytest.raises(stoss.InvalidInput, match="^[^\n]*got [^\n]*allowed[^\n]*$"):
        stoss.Grid.from_toml(path)


def test_every_shard_has_its_share_of_each_body_and_partner():
    blocks = [{"kind": "half-space", "density": float(k)} for k in range(1, 4)]
    cases = grid(bodies={"kind": "sphere", "poisson": "lin:0:0.4:16"}, against=["wall", *blocks])
    keys = {case.key for case in cases.cases()}
    for shards in (1, 2, 3, 4, 7, 8, 100):
        parts = [sample(cases, shard, shards) for shard in range(1, shards + 1)]
        assert {each.case.key for part in parts for each in part} == keys and sum(map(len, parts)) == len(keys)
        assert max(map(len, parts)) - min(map(len, parts)) <= 1
        for part in parts:
            partners = np.bincount([each.case.place[1] for each in part], minlength=4)
            assert shards > 8 or partners.max() - partners.min() <= 2
            assert shards > 8 or partners.min() > 0


@pytest.fixture(scope="module")
def documented(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "grid.toml"
    path.write_text(re.search(r"```toml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)[1], encoding="utf-8")
    return stoss.Grid.from_toml(path)


def test_two_shards_of_the_documented_grid_have_the_same_number_of_each_partner(documented):
    assert documented.shape == (4, 2, 20)
    for shards in (2, 4):
        for shard in range(1, shards + 1):
            places = np.array([each.case.place for each in sample(documented, shard, shards)])
            assert np.bincount(places[:, 1]).tolist() == [4 // shards] * 2
            assert shards > 2 or sorted(places[:, 0]) == [0, 1, 2, 3]


def test_the_hardest_value_of_the_documented_grid_converges(documented):
    small, block = stoss.Sphere(radius=0.005, material=stoss.materials["glass"]), documented.cases()[1].against
    assert small in documented.bodies and isinstance(block, stoss.HalfSpace)
    assert stoss.restitution(small, against=block, speed=documented.speed[0]).converged


DISK = {"kind": "disk", "poisson": 0.3}
BELL, FLAT = ({"kind": "modal", "file": str(PAGE.parents[2] / f"examples/any_body/{each}.json")} for each in ("bell", "beam_0"))


@pytest.mark.parametrize(
    "changed, message",
    [
        ({"tolerance": 0.0}, "tolerance: got 0, allowed 1e-15 to 0.5"),
        ({"tolerance": 0.6}, "tolerance: got 0.6, allowed 1e-15 to 0.5"),
        ({"absolute": 0.6}, "absolute: got 0.6, allowed 0 to 0.5"),
        ({"friction": 0.1, "tolerance": 1e-7}, "tolerance: got 1e-07, allowed 1e-6 to 0.5"),
        ({"temperature": 0.1, "error": 1e-10}, "error: got 1e-10, allowed 1e-9 to 0.5"),
        ({"temperature": 0.1, "highest": 1.0}, "highest: got 1, allowed"),
        ({"against": ["wall", {"kind": "cube"}]}, "against: kind: got 'cube', allowed disk"),
        ({"against": ["wall", {"kind": "half-plane"}]}, "against: got HalfPlane()"),
        ({"against": ["wall", {"kind": "strip", "thickness": 1}], "friction": 0.1}, "against: got Strip("),
        ({"bodies": [DISK], "against": ["wall", {"kind": "plate", "thickness": 1}]}, "against: got Plate("),
        ({"bodies": [BALLS, {"kind": "rod"}], "friction": 0.1}, "friction: not available for 'rod'"),
        ({"bodies": [DISK], "against": ["wall", {**DISK, "radius": 900}], "friction": 0.1},
         "against: got 'disk' of 900 times"),
        ({"bodies": [DISK], "against": ["wall", {**DISK, "radius": 1100}]}, "radius ratio: got 1100"),
        ({"against": ["wall", {"kind": "half-space", "young": 1e-7}]}, "young ratio: got 1e-07"),
        ({"bodies": [FLAT], "against": [{"kind": "sphere", "radius": 0.01, "material": "glass"}, "wall"]},
         "curvature: the surface of"),
        ({"bodies": [BELL], "against": [{"kind": "sphere", "radius": 0.01, "material": "glass"}], "friction": 0.1},
         "friction: got 'bell' without"),
        ({"speed": [0.01, 1.5]}, "speed: got 1.5, allowed 1e-8 to 1"),
        ({"speed": [0.01, 0.0]}, "speed: got 0, allowed 1e-8 to 1"),
        (
            {"bodies": [{"kind": "sphere", "radius": 0.01, "material": each} for each in ("glass", "rubber")],
             "speed": 200.0},
            "speed: got 200, allowed 5.20886e-07 to 52.0885 m/s",
        ),
    ],
    ids=range(19),
)
def test_what_the_last_case_refuses_is_refused_before_the_first(changed, message, tmp_path):
    begin = time.process_time()
    with pytest.raises(stoss.InvalidInput) as error:
        stoss.sweep({"bodies": BALLS, "speed": [0.01, 0.03], **changed}, store=tmp_path / "store")
    assert str(error.value).startswith(message) and "\n" not in str(error.value), error.value
    assert time.process_time() - begin < 1.0 and not (tmp_path / "store").exists()
