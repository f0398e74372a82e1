"""The collision rule as a function: values, units, collisions of arrays, what is written."""

# ruff: noqa: B023 (what refuses is called at once)
import ctypes
import json
import os
import pickle
import shutil
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
    return stoss.collision_rule(BALL, against="same", speed=(1e-3, 1e-2), beyond="clamp")


@pytest.fixture(scope="module")
def steel():
    return stoss.collision_rule(STEEL, speed=(1, 20))


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
    assert np.all(normal <= 1e-3) and np.all(along <= 2e-2) and rule.greatest_error <= (1e-3, 2e-2)


def test_shapes_are_those_of_the_arguments(rule):
    restitution, after = rule([[0.002], [0.003]], [0.001, 0.002, 0.003], 0.3)
    assert restitution.shape == after.shape == (2, 3)
    assert all(isinstance(each, float) for each in rule(0.002, 0.001, 0.3))


def test_speeds_are_in_si_with_a_material(steel):
    own = stoss.collision_rule(stoss.Sphere(poisson=STEEL.poisson), speed=np.array([1, 20]) / STEEL.scales.speed)
    for found, expected in zip(steel(3.0, 1.0, 0.1), own(3.0 / STEEL.scales.speed, 1.0 / STEEL.scales.speed, 0.1)):
        assert found == pytest.approx(expected * (STEEL.scales.speed if found < 0.9 else 1), rel=1e-12)
    velocity, spin, *_ = steel.collide([3.0, 1.0, 0], [0, 0, 40.0], [1, 0, 0], friction=0.1)
    scales = STEEL.scales
    bare, turning, *_ = own.collide(
        np.array([3.0, 1.0, 0]) / scales.speed, np.array([0, 0, 40.0]) / scales.frequency, [1, 0, 0], friction=0.1
    )
    assert velocity == pytest.approx(bare * scales.speed) and spin == pytest.approx(turning * scales.frequency)


@pytest.mark.parametrize("dimension", [2, 3])
def test_collisions_keep_momentum_and_gain_no_energy(rule, dimension):
    chance = np.random.default_rng(5)
    count, turning = 10_000, (3,) if dimension == 3 else ()
    v, w, n = chance.normal(size=(3, count, dimension)) * 0.003
    s, t = chance.normal(size=(2, count, *turning)) * 0.003
    v2, s2, w2, t2 = rule.collide(v, s, n, w, t, friction=0.3)
    assert np.allclose(v + w, v2 + w2, rtol=0, atol=1e-17)
    along = n / np.linalg.norm(n, axis=-1, keepdims=True)
    met = np.sum((v - w) * along, axis=-1) > 0
    assert np.array_equal(v[~met], v2[~met]) and np.array_equal(s[~met], s2[~met]) and 4000 < met.sum() < 6000
    squares = [np.sum(each.reshape(count, -1) ** 2, axis=-1) for each in (v, w, s, t, v2, w2, s2, t2)]
    before, after = (a + b + 0.4 * (c + d) for a, b, c, d in (squares[:4], squares[4:]))
    assert np.all(after <= before * (1 + 1e-14)) and np.mean(after[met]) < 0.99 * np.mean(before[met])
    inertia, arm = 0.4, (along if dimension == 3 else np.concatenate([along, np.zeros((count, 1))], axis=1))
    turned = inertia * (s2 - s + t2 - t)
    if dimension == 2:
        turned = np.stack([0 * turned, 0 * turned, turned], axis=1)
    push = np.concatenate([w2 - w, np.zeros((count, 3 - dimension))], axis=1)
    assert np.allclose(turned + np.cross(2 * arm, push), 0, atol=1e-16)  # about the centre of the first


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


@pytest.mark.skipif(shutil.which("cc") is None, reason="needs cc")
@pytest.mark.parametrize("name", ["rule", "steel", "mixture"])
def test_header_in_c_is_the_same_function(request, tmp_path, name):
    rule = request.getfixturevalue(name)
    rule.to_c(tmp_path / "rule.h")
    values = "".join(
        f"double {each}(double v, double s, double f, double r) {{ return stoss_rule_{each}(v, s, f, r); }}\n"
        for each in ("restitution", "sliding", "restitution_error", "sliding_error")
    )
    bodies = "".join(
        f"int collide_{d}d(stoss_rule_body_{d}d *a, stoss_rule_body_{d}d *b, const double *n, double f)"
        f" {{ return stoss_rule_collide_{d}d(a, b, n, f); }}\n"
        for d in (2, 3)
    )
    (tmp_path / "rule.c").write_text('#include "rule.h"\n' + values + bodies)
    words = ["cc", "-std=c89", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O2", "-shared", "-fPIC"]
    subprocess.run([*words, "rule.c", "-o", "rule.so", "-lm"], cwd=tmp_path, check=True, timeout=60)
    library = ctypes.CDLL(str(tmp_path / "rule.so"))
    chance = np.random.default_rng(1)
    unit = 1.0 if rule.body.material is None else rule.body.scales.speed
    low, high = rule.speed[[0, -1]] * unit
    for _ in range(200):
        v, ratio = low * (high / low) ** chance.random(), rule.ratio[0] + np.ptp(rule.ratio) * chance.random()
        s, friction = v * np.tan(1.5 * (2 * chance.random() - 1)), chance.random()
        for names, expected in (
            (("restitution", "sliding"), rule(v, s, friction, ratio)),
            (("restitution_error", "sliding_error"), rule.error(v, s, friction, ratio)),
        ):
            for its, value in zip(names, expected):
                function = getattr(library, its)
                function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * 4
                assert function(v, s, friction, ratio) == pytest.approx(value, rel=1e-14, abs=1e-14 * abs(s)), its
    if name == "rule":
        _collide_in_c(library, rule, chance)


def _collide_in_c(library, rule, chance):
    mass = 4 * np.pi / 3
    for dimension in (2, 3):
        turns = 3 if dimension == 3 else 1
        for _ in range(200):
            v, w, n = chance.normal(size=(3, dimension)) * 0.003
            s, t = chance.normal(size=(2, turns)) * 0.003
            bodies = [(ctypes.c_double * (3 + dimension + turns))(1 / mass, 2.5 / mass, 1, *a, *b) for a, b in ((v, s), (w, t))]
            getattr(library, f"collide_{dimension}d")(*bodies, (ctypes.c_double * dimension)(*n), ctypes.c_double(0.3))
            spins = (s, t) if dimension == 3 else (s[0], t[0])
            expected = rule.collide(v, spins[0], n, w, spins[1], friction=0.3)
            found = np.array([list(each)[3:] for each in bodies]).ravel()
            assert found == pytest.approx(np.concatenate([np.ravel(each) for each in expected]), abs=1e-16)


def test_files(rule, tmp_path):
    rule.to_json(tmp_path / "rule.json")
    document = json.loads((tmp_path / "rule.json").read_text())
    assert document["slip"][0] == -1 and np.shape(document["sliding"]) == rule.sliding.shape
    rule.to_csv(tmp_path / "rule.csv")
    table = stoss.read_csv(tmp_path / "rule.csv")
    assert np.array_equal(table["sliding"], rule.sliding.ravel())
    netcdf = pytest.importorskip("netCDF4")
    rule.to_netcdf(tmp_path / "rule.nc")
    with netcdf.Dataset(tmp_path / "rule.nc") as data:
        assert data["sliding"].dimensions == ("speed", "slip", "ratio") and data["speed"].units == "c"
        assert np.array_equal(data["sliding"][:], rule.sliding) and np.array_equal(data["slip"][:], rule.slip)


def test_pickle_is_the_same_rule(rule):
    again = pickle.loads(pickle.dumps(rule))
    assert again(0.002, 0.001, 0.3) == rule(0.002, 0.001, 0.3)


def test_says_what_cannot_be(rule):
    def refuse(match, call):
        with pytest.raises(stoss.InvalidInput, match=match):
            call()

    refuse("friction: got None", lambda: rule(0.002, 0.001))
    refuse("friction", lambda: rule(0.002, 0.001, -1))
    refuse("velocity", lambda: rule.collide([1.0], 0, [1.0], friction=0.3))
    v, w, n = [0.005, 0.001, 0], [0, 0, 0.1], [1, 0, 0]
    for bad in (np.nan, np.inf, -np.inf):
        refuse("^normal: got .*all 0$", lambda: rule.collide(v, w, [bad, 0, 0], friction=0.3))
        refuse("^velocity: got", lambda: rule.collide([bad, 0, 0], w, n, friction=0.3))
        refuse("^velocity: got", lambda: rule.collide(v, w, n, [0, bad, 0], friction=0.3))
        refuse("^spin: got", lambda: rule.collide(v, [0, bad, 0], n, friction=0.3))
        refuse("^friction: got", lambda: rule.collide(v, w, n, friction=bad))
        refuse(r"^collision 1 friction: ", lambda: rule.collide(v, w, n, friction=[0.3, bad]))
    refuse("^normal: got .0, 0, 0.,", lambda: rule.collide(v, w, [0, 0, 0], friction=0.3))
    refuse("^normal: got .0, 0, 0.,", lambda: rule.collide(v[:2], 0.1, [0, 0], friction=0.3))
    refuse("^collision 1 normal: got", lambda: rule.collide(v, w, [[1, 0, 0], [0, 0, 0]], friction=0.3))
    whole = rule.collide(v, w, n, friction=0.3)
    for length in (1e-200, 1e200):
        scaled = rule.collide(v, w, np.multiply(length, n), friction=0.3)
        assert all(np.array_equal(one, other) for one, other in zip(scaled, whole))
    refuse("friction: missing", lambda: stoss.collision_rule(poisson=0.33, speed=(0.01, 0.1)))
    refuse("friction: got 0.3", lambda: stoss.collision_rule(BALL, speed=(1e-3, 1e-2), friction=0.3))
    refuse("speed", lambda: stoss.collision_rule(BALL, speed=0.1))
    refuse("beyond", lambda: stoss.collision_rule(BALL, speed=(1e-3, 1e-2), beyond="law"))
    with pytest.raises(stoss.NotConverged, match="tolerance"):
        stoss.collision_rule(BALL, speed=(1e-3, 0.2))


@pytest.mark.skipif("STOSS" not in os.environ, reason="needs the command in STOSS")
def test_the_command_writes_the_same_netcdf(interpreter, tmp_path):
    xarray = pytest.importorskip("xarray")
    words = "--body sphere --poisson 0.3 --against same --speed 1e-3:1e-2 --ratio 1:2 --error 0.01 --tolerance 0.05"
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        [os.environ["STOSS"], "table", "--oblique", *words.split(), *"--format netcdf -o rule.nc".split()],
        cwd=tmp_path, env={**interpreter.environment, "PATH": path}, capture_output=True, encoding="utf-8", timeout=60,
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    ball = stoss.Sphere(poisson=0.3)
    rule = stoss.collision_rule(
        ball, against="same", speed=(1e-3, 1e-2), ratio=(1, 2), error=0.01, tolerance=0.05
    )  # fmt: skip
    with xarray.open_dataset(tmp_path / "rule.nc") as file:
        assert file["sliding"].dims == ("speed", "slip", "ratio")
        assert np.array_equal(file["sliding"], rule.sliding) and np.array_equal(file["ratio"], rule.ratio)
        assert np.all(file["restitution_error"] > 0)
