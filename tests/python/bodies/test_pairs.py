"""Two bodies: values of independent finite elements, exact ones of rods, and what no choice of words may change."""

import dataclasses
import pickle

import numpy as np
import pytest

import stoss

ONE = stoss.Disk(poisson=0.33)
TWO = stoss.Disk(poisson=0.2, radius=2.0, young=3.0, density=2.0)
COLUMNS = ("restitution", "lost_fraction", "contact_time", "max_force", "max_compression")


@pytest.fixture(scope="module")
def pair():
    """An impact of unequal disks, at little cost."""
    return stoss.impact(ONE, against=TWO, speed=0.2, cutoff=12)


@pytest.mark.parametrize("body", [ONE, stoss.Disk(radius=0.01, material=stoss.materials["glass"], plane="strain")])
def test_equal_bodies_are_one_at_a_wall(body):
    unit = 1.0 if body.material is None else body.scales.speed
    pairs = stoss.restitution(body, against="same", speed=np.array([0.02, 0.2]) * unit)
    alone = stoss.restitution(body, speed=np.array([0.01, 0.1]) * unit)
    assert pairs.restitution == pytest.approx(alone.restitution, rel=1e-12)
    assert pairs.contact_time == pytest.approx(alone.contact_time, rel=1e-12)
    assert pairs.max_compression == pytest.approx(2 * alone.max_compression, rel=1e-12)  # of both
    assert pairs.lost_to_first == pytest.approx(pairs.lost_to_second, rel=1e-9)
    assert np.all(alone.lost_to_second == 0) and np.all(alone.lost_to_first > 0)
    twin = dataclasses.replace(body)
    again = stoss.restitution(body, against=twin, speed=pairs.speed * unit)
    assert np.array_equal(again.restitution, pairs.restitution)


def test_same_of_many_poisson_numbers():
    many = stoss.restitution(poisson=[[0.2], [0.5]], against="same", speed=[0.1, 0.2], tolerance=1e-2)
    assert many.against == "same" and many.body is None and "against 'same'" in repr(many)
    for i, nu in enumerate((0.2, 0.5)):
        disk = stoss.Disk(poisson=nu)
        alone = stoss.restitution(disk, against=disk, speed=0.2, tolerance=1e-2)
        assert many.restitution[i, 1] == alone.restitution and alone.against == disk


def test_swapping_changes_names_only():
    there = stoss.restitution(ONE, against=TWO, speed=0.1)
    # In units of the second body.
    length, velocity, mass = 2.0, (3.0 / 2.0) ** 0.5, 2.0 * 4.0
    back = stoss.restitution(TWO, against=ONE, speed=0.1 / velocity)
    for name, unit in (("lost_fraction", 1.0), ("contact_time", length / velocity), ("max_compression", length),
                       ("max_force", mass * velocity**2 / length)):  # fmt: skip
        assert unit * getattr(back, name) == pytest.approx(getattr(there, name), rel=1e-9), name
    assert (back.lost_to_second, back.lost_to_first) == pytest.approx((there.lost_to_first, there.lost_to_second))


def test_units_are_the_users():
    steel, glass = stoss.materials["structural steel"], stoss.materials["glass"]
    for factor in (1.0, 7.0):  # geometrically similar
        first = stoss.Disk(radius=0.01 * factor, material=steel, loss_time=0, plane="strain")
        second = stoss.Disk(radius=0.02 * factor, material=glass, loss_time=0, plane="strain")
        si = stoss.restitution(first, against=second, speed=2.0)
        ratios = {"young": second.young / first.young, "density": second.density / first.density}
        like = stoss.restitution(
            stoss.Disk(poisson=first.poisson), against=stoss.Disk(poisson=second.poisson, radius=2.0, **ratios),
            speed=2.0 / first.scales.speed,
        )  # fmt: skip
        for name in COLUMNS:
            assert getattr(si, name) == pytest.approx(getattr(like, name), rel=1e-9), name
        scales = (first.young / first.density) ** 0.5
        assert first.scales.speed == pytest.approx(scales, rel=1e-12)
        assert si.speed_si == pytest.approx(2.0, rel=1e-14)
        assert si.contact_time_si == pytest.approx(like.contact_time * 0.01 * factor / scales, rel=1e-9)
        assert si.max_force_si == pytest.approx(like.max_force * np.pi * 0.01 * factor * first.young, rel=1e-9)


@pytest.mark.parametrize(
    "first, second, value",
    [
        ({}, {"length": 2.5}, 0.4),
        ({"area": 3, "length": 10}, {"length": 25}, 0.7875),  # (Z1, T1, Z2, T2) = (3, 10, 1, 25)
        ({"length": 10}, {"area": 3, "length": 20}, 0.75),  # (1, 10, 3, 20)
    ],
)
def test_rods_are_exact(first, second, value):
    hit = stoss.impact(stoss.Rod(**first), against=stoss.Rod(**second), speed=0.1, cutoff=1500)
    assert hit.restitution == pytest.approx(value, abs=2e-3)


def test_rods_in_si():
    steel = stoss.materials["structural steel"]
    long, short = (stoss.Rod(length=length, area=1e-4, material=steel, loss_time=0) for length in (0.4, 0.2))
    hit = stoss.impact(short, against=long, speed=1.0, cutoff=1000)
    assert hit.restitution == pytest.approx(0.5, abs=2e-3)
    # The force ends when the wave of the short rod is back. Then this rod stops, unloaded, next to the long one.
    assert hit.contact_time_si == pytest.approx(2 * 0.2 / (2.1e11 / 7850) ** 0.5, rel=1e-2)
    # The force is that of a step, ½ Z v.
    assert hit.trajectory().force.mean() * short.scales.force < hit.max_force_si
    assert short.scales.force == pytest.approx(2.1e11 * 1e-4)


def test_ledger_and_trajectory(pair):
    energies = pair.mode_energies
    first = energies["body"] == 0
    assert set(energies["body"]) == {0, 1} and np.all(np.diff(energies["body"]) >= 0)
    of_each = [energies["after"][each].sum() for each in (first, ~first)]
    assert sum(of_each) == pytest.approx(pair.vibration, abs=1e-12)
    assert pair.lost_to_first >= of_each[0] and pair.lost_to_second >= of_each[1]
    assert pair.lost_to_first + pair.lost_to_second == pytest.approx(pair.vibration + pair.unresolved, abs=1e-12)
    path = pair.trajectory()
    # It starts at most two steps in front of the touch.
    assert -2 * pair.step * pair.speed < path.center[0] + 3.0 < 0 and path.velocity[0] == pair.speed
    assert path.velocity[-1] == pytest.approx(-pair.restitution * pair.speed, rel=1e-14)
    mass = 1 / (1 + 1 / 8)  # reduced, in that of the first
    momentum = np.sum(0.5 * (path.force[1:] + path.force[:-1]) * np.diff(path.time))
    assert momentum == pytest.approx(mass * pair.speed * (1 + pair.restitution), rel=2e-3)
    at_end = pair.energies_at(time=path.time[-1])
    assert at_end["body"].tolist() == energies["body"].tolist()
    assert at_end["energy"] == pytest.approx(energies["after"], abs=1e-12)


def test_field_of_both(pair):
    radius, weight = (0.5 * (x + y) for x, y in zip(np.polynomial.legendre.leggauss(40), (1, 0)))
    angle = np.linspace(-np.pi, np.pi, 1441)[:-1]
    time = np.array([-1.0, 1.0, 0.5 * pair.contact_time, pair.contact_time + 2])
    centers = []
    for of, size in ((0, 1.0), (1, 2.0)):
        field = pair.field(time=time, radius=radius, angle=angle, of=of)
        assert (field.of, field.size) == (of, size)
        mean = (field.x * (radius * weight)[:, None]).sum((-1, -2)) * 2 / angle.size
        assert mean == pytest.approx(field.center, abs=1e-12)
        centers.append(field.center)
    # The common centre of mass is at rest, and their distance is that of the trajectory.
    assert centers[0] + 8 * centers[1] == pytest.approx(np.full(4, -1 + 8 * 2), abs=1e-12)
    path = pair.trajectory()
    apart = np.interp(field.time[1:3], path.time, path.center)
    assert (centers[0] - centers[1])[1:3] == pytest.approx(apart, abs=1e-12)
    # Before, they fly as they were made.
    before = pair.field(time=-1.0, radius=[1.0], angle=[0.0], of=1)
    ahead = -3.0 - pair.trajectory().center[0]  # of the touch, at the start
    assert before.x[0, 0] == pytest.approx((0.2 + ahead) / 9, abs=1e-12) and before.von_mises.max() == 0


def test_both_surfaces_meet_and_press_alike(pair):
    time = 0.5 * pair.contact_time
    first = pair.field(time=time, radius=1, angle=np.linspace(0, 0.5, 41))
    second = pair.field(time=time, radius=1, angle=np.linspace(0, 0.4, 2001), of=1)
    inside = first.y[0] < 0.8 * first.contact_half_width
    there = np.interp(first.y[0], second.y[0], second.x[0])
    assert np.abs(first.x[0] - there)[inside].max() < 1e-3  # the radiating tail's inertia is left out
    assert second.stress_rr[0, 0] == pytest.approx(first.stress_rr[0, 0], rel=3e-3)
    # Each carries the whole force: pressure on its own edge, with the same unit.
    for of, size in ((0, 1.0), (1, 2.0)):
        edge = pair.field(time=time, radius=1, angle=np.linspace(-0.7, 0.7, 4001), of=of)
        pressed = edge.stress_rp[0] * np.sin(edge.angle) - edge.stress_rr[0] * np.cos(edge.angle)
        force = size * np.sum(0.5 * (pressed[1:] + pressed[:-1]) * np.diff(edge.angle)) / np.pi
        assert force == pytest.approx(edge.force, rel=1e-2)


def test_a_pair_is_a_value(pair, tmp_path):
    again = pickle.loads(pickle.dumps(pair))
    assert again.to_dict() == pair.to_dict() and again.against == TWO
    assert pair.to_dict()["against"]["radius"] == 2.0 and pair.to_dict()["lost_to_second"] == pair.lost_to_second
    pair.to_csv(tmp_path / "pair.csv")
    text = (tmp_path / "pair.csv").read_text()
    assert f"# against: {TWO!r}\n" in text and ",lost_to_first,lost_to_second," in text
    assert "Disk(poisson=0.33) against Disk(poisson=0.2, radius=2, young=3, density=2)" in repr(pair)
    far = stoss.restitution(ONE, against=TWO, speed=[0.1, 0.2], tolerance=1e-2)
    assert "against Disk(poisson=0.2, radius=2, young=3, density=2)" in repr(far)


def test_refusals():
    steel = stoss.Disk(radius=0.01, material=stoss.materials["structural steel"])
    for first, second, hint in (
        (ONE, steel, "two bodies with a material, or two without"), (steel, ONE, "two bodies with a material"),
        (ONE, stoss.Rod(), "a disk meets disks"), (stoss.Rod(), ONE, "a disk meets disks"),
        (steel, stoss.Disk(radius=0.01, material=steel.material, plane="strain"), "the same plane"),
        (ONE, "equal", "None, 'same', a stoss.HardWall"),
    ):  # fmt: skip
        for call in (stoss.restitution, stoss.impact):
            with pytest.raises(stoss.InvalidInput, match="^against: got .*" + hint):
                call(first, against=second, speed=0.1)
    for call in (stoss.restitution, stoss.impact):
        with pytest.raises(stoss.InvalidInput, match="^radius ratio: got 0.0001, allowed"):
            call(ONE, against=stoss.Disk(poisson=0.3, radius=1e-4), speed=0.1)
    with pytest.raises(stoss.InvalidInput, match="^body: got number 1 .*, allowed 0 .*near side"):
        stoss.impact(ONE, against=stoss.Disk(poisson=0.3, radius=900.0), speed=0.1, cutoff=6).field(time=1, of=1)
    with pytest.raises(stoss.InvalidInput, match="^of: got 1, allowed 0 .a wall has no field"):
        stoss.impact(ONE, speed=0.1, cutoff=6).field(time=1, of=1)
    with pytest.raises(stoss.InvalidInput, match="^of: got 2, allowed 0 or 1"):
        stoss.impact(ONE, against="same", speed=0.1, cutoff=6).field(time=1, of=2)
    with pytest.raises(stoss.InvalidInput, match="^keep: got a selection"):
        stoss.impact(ONE, against="same", speed=0.1, cutoff=6, keep=[True])


def test_pictures_show_both(pair, closed, tmp_path):
    axes = stoss.plot.disk(pair.field(time=0.5 * pair.contact_time))
    left, right = axes.get_xlim()
    assert left < -1.9 and right > 3.9
    assert len(axes.collections) == 2  # two grids, and no wall
    behind = stoss.plot.disk(pair.field(time=0.5 * pair.contact_time, of=1))
    for one, other in zip(axes.collections, behind.collections):
        assert all(np.array_equal(a, b) for a, b in zip(one.get_segments(), other.get_segments()))
    colours = stoss.plot.stress(pair.field(time=0.5 * pair.contact_time, radius=np.linspace(0, 1, 9)))
    assert len(colours.collections) == 2
    assert stoss.plot.velocity(pair.trajectory()).get_ylabel() == "velocity of approach / c"
    rows = stoss.plot.sequence(pair, count=4, columns=2)
    assert len(rows.collections) == 8 and not rows.patches
    points = np.concatenate([segment for grid in rows.collections for segment in grid.get_segments()])
    (low, high), (bottom, top) = rows.get_xlim(), rows.get_ylim()
    assert low < points[:, 0].min() and points[:, 0].max() < high
    assert bottom < points[:, 1].min() and points[:, 1].max() < top
    heights = [sorted(bar.get_height() for group in stoss.plot.ledger(pair, of=of).containers for bar in group)
               for of in (0, 1)]  # fmt: skip
    strongest = [pair.mode_energies["after"][pair.mode_energies["body"] == of].max() for of in (0, 1)]
    assert [each[-1] for each in heights] == strongest
    for quantity in (None, "von_mises"):
        stoss.animate(pair, tmp_path / "pair.gif", frames=3, quantity=quantity)
        assert (tmp_path / "pair.gif").stat().st_size > 3000
