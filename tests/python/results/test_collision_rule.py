"""The collision rule as a function: values, units, collisions of arrays, what is written."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)
STEEL = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"], loss_time=0)


@pytest.fixture(scope="module")
def rule():
    return stoss.collision_rule(BALL, against="same", speed=(1e-3, 1e-2), beyond="clamp", error=0.01, tolerance=0.05)


@pytest.fixture(scope="module")
def steel():
    return stoss.collision_rule(STEEL, speed=(1, 20), error=0.05, tolerance=0.1)


@pytest.fixture(scope="module")
def mixture():
    return stoss.collision_rule(BALL, against="same", speed=(1e-3, 3e-3), ratio=(1, 1.5), tolerance=0.05)


def test_values_are_those_of_oblique(rule):
    speed, sliding = 0.004, np.array([1e-4, 1e-3, 3e-3, 0.02])
    direct = stoss.oblique(BALL, against="same", speed=speed, tangential=sliding, friction=0.2, tolerance=2e-3)
    restitution, after = rule(speed, sliding, 0.2)
    normal, along = rule.error(speed, sliding, 0.2)
    assert np.all(np.abs(restitution - direct.restitution) <= normal)
    assert np.all(np.abs(after - direct.sliding_after) <= along * (sliding + 0.2 * speed))
    assert np.all(normal <= 1e-2) and np.all(along <= 5e-2) and rule.greatest_error <= (1e-2, 5e-2)


def test_shapes_are_those_of_the_arguments(rule):
    restitution, after = rule([[0.002], [0.003]], [0.001, 0.002, 0.003], 0.3)
    assert restitution.shape == after.shape == (2, 3)
    assert all(isinstance(each, float) for each in rule(0.002, 0.001, 0.3))


@pytest.mark.parametrize("turning", [(), (3,)])
def test_collisions_of_arrays_keep_momentum(rule, turning):
    """In the plane, where spins are numbers, and in space; those that part are left as they are."""
    chance = np.random.default_rng(5)
    v, w, n = chance.normal(size=(3, 1000, len(turning) + 2)) * 0.003
    s, t = chance.normal(size=(2, 1000, *turning)) * 0.003
    v2, s2, w2, t2 = rule.collide(v, s, n, w, t, friction=0.3)
    assert np.allclose(v + w, v2 + w2, rtol=0, atol=1e-17) and s2.shape == t2.shape == s.shape
    met = np.sum((v - w) * n, axis=-1) > 0
    assert np.array_equal(v[~met], v2[~met]) and np.array_equal(s[~met], s2[~met]) and np.all(np.any(v[met] != v2[met],
     axis=-1))


def test_mixture_takes_radii(mixture):
    velocity = np.array([[0.002, 0.001, 0], [0.002, 0.001, 0]])
    v, s, w, t = mixture.collide(velocity, 0.0, [1, 0, 0], friction=0.3, radius=1.0, second_radius=[1.0, 1.4])
    mass = np.array([1, 1.4**3])[:, np.newaxis]
    assert v + mass * w == pytest.approx(velocity, abs=1e-17)
    restitution, after = mixture(0.002, 0.001, 0.3, [1.0, 1.4])
    assert (w - v)[:, 0] == pytest.approx(restitution * 0.002)
    sliding = (v - w)[:, 1] + s[:, 2] + np.array([1, 1.4]) * t[:, 2]
    assert sliding == pytest.approx(after)
    with pytest.raises(stoss.InvalidInput, match="ratio: got 2"):
        mixture(0.002, 0.001, 0.3, 2.0)


def test_nodes_are_plain_arrays(rule, mixture):
    for each, counted in ((rule, (2, 4)), (mixture, (4, 8))):
        for nodes, values, count in zip(each.nodes, (each.restitution, each.sliding), counted):
            assert nodes.shape == (*values.shape, count) and nodes.flags.c_contiguous
            assert np.array_equal(nodes[..., 0], values)


def sliding_after(speeds, slips, nodes, speed, sliding, friction):
    """s′ of pairs without a ratio, as the guide's numba would compile it: loops, numbers and arrays alone."""
    axes, after = (np.log(speeds), slips.copy()), np.empty_like(speed)
    weights, at = np.empty((2, 4)), np.empty(2, np.int64)
    for i in range(speed.size):
        scale = sliding[i] + friction * speed[i]
        spot = (np.log(speed[i]), 2 * sliding[i] / scale - 1)
        for d in range(2):
            places, x = axes[d], spot[d]
            at[d] = min(max(np.searchsorted(places, x) - 1, 0), places.size - 2)
            h = places[at[d] + 1] - places[at[d]]
            t = (x - places[at[d]]) / h
            weights[d] = np.array(
                [(1 + 2 * t) * (1 - t) ** 2, t * t * (3 - 2 * t), h * t * (1 - t) ** 2, -h * t * t * (1 - t)]
            )
        q = 0.0
        for k in range(4):  # value and slope along ln v, at both ends
            for j in range(4):
                node = nodes[at[0] + k % 2, at[1] + j % 2, 0, k // 2 + 2 * (j // 2)]
                q += weights[0, k] * weights[1, j] * node
        after[i] = q * scale
    return after


@pytest.mark.parametrize("compiled", [False, True])
def test_arrays_are_fit_for_compiled_loops(rule, compiled):
    loop = pytest.importorskip("numba").njit(sliding_after) if compiled else sliding_after
    speed, friction = np.geomspace(1e-3, 1e-2, 7), 0.2
    sliding = np.linspace(0, 9, 7) * friction * speed
    found = loop(rule.speed, rule.slip, rule.nodes[1], speed, sliding, friction)
    assert found == pytest.approx(rule(speed, sliding, friction)[1], abs=1e-15)


def test_header_in_c_has_the_unit_of_the_rule(steel, tmp_path):
    """It is that of the core, which the tests of the command compile."""
    steel.to_c(tmp_path / "rule.h", name="balls")
    text = (tmp_path / "rule.h").read_text()
    assert "balls_rule_restitution(" in text and "balls_rule_collide_2d(" in text and "m/s" in text
    assert f"stoss {stoss.__version__}: collision rule" in text and "radius=0.005" in text
    steel.to_rust(tmp_path / "rule.rs", name="balls")
    steel.to_js(tmp_path / "rule.mjs", name="balls")
    assert "pub fn balls_rule_collide_2d(" in (tmp_path / "rule.rs").read_text()
    assert "export function balls_rule_collide_2d(" in (tmp_path / "rule.mjs").read_text()


def test_files(rule, tmp_path):
    rule.to_json(tmp_path / "rule.json")
    document = json.loads((tmp_path / "rule.json").read_text())
    assert document["slip"][0] == -1 and np.shape(document["sliding"]) == rule.sliding.shape
    netcdf = pytest.importorskip("netCDF4")
    rule.to_netcdf(tmp_path / "rule.nc")
    with netcdf.Dataset(tmp_path / "rule.nc") as data:
        assert data["sliding"].dimensions == ("speed", "slip", "ratio") and data["speed"].units == "c"
        assert np.array_equal(data["sliding"][:], rule.sliding) and np.array_equal(data["slip"][:], rule.slip)


def test_says_what_cannot_be(rule):
    v, w, n, nan = [0.005, 0.001, 0], [0, 0, 0.1], [1, 0, 0], np.nan
    for match, call in (
        ("friction: got None", lambda: rule(0.002, 0.001)), ("friction", lambda: rule(0.002, 0.001, -1)),
        ("velocity", lambda: rule.collide([1.0], 0, [1.0], friction=0.3)),
        ("normal: got .*all 0$", lambda: rule.collide(v, w, [nan, 0, 0], friction=0.3)),
        ("velocity: got", lambda: rule.collide([np.inf, 0, 0], w, n, friction=0.3)),
        ("velocity: got", lambda: rule.collide(v, w, n, [0, nan, 0], friction=0.3)),
        ("spin: got", lambda: rule.collide(v, [0, nan, 0], n, friction=0.3)),
        ("friction: got", lambda: rule.collide(v, w, n, friction=nan)),
        ("collision 1 friction: ", lambda: rule.collide(v, w, n, friction=[0.3, nan])),
        ("normal: got .0, 0, 0.,", lambda: rule.collide(v, w, [0, 0, 0], friction=0.3)),
        ("collision 1 normal: got", lambda: rule.collide(v, w, [[1, 0, 0], [0, 0, 0]], friction=0.3)),
    ):
        with pytest.raises(stoss.InvalidInput, match=f"^{match}"):
            call()
    with pytest.raises(stoss.NotConverged, match="tolerance"):
        stoss.collision_rule(BALL, speed=(1e-3, 0.2))


@pytest.mark.skipif("STOSS" not in os.environ, reason="needs the command in STOSS")
def test_the_command_writes_the_same_netcdf(interpreter, tmp_path):
    xarray = pytest.importorskip("xarray")
    words = "--body sphere --poisson 0.3 --against same --speed 1e-3:2e-3 --ratio 1:1.2 --error 0.05 --tolerance 0.1"
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        [os.environ["STOSS"], "table", "--oblique", *words.split(), *"--format netcdf -o rule.nc".split()],
        cwd=tmp_path, env={**interpreter.environment, "PATH": path}, capture_output=True, encoding="utf-8", timeout=60,
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    rule = stoss.collision_rule(BALL, against="same", speed=(1e-3, 2e-3), ratio=(1, 1.2), error=0.05, tolerance=0.1)
    with xarray.open_dataset(tmp_path / "rule.nc") as file:
        assert file["sliding"].dims == ("speed", "slip", "ratio")
        assert np.array_equal(file["sliding"], rule.sliding) and np.array_equal(file["ratio"], rule.ratio)
        assert np.all(file["restitution_error"] > 0)
