"""Bodies by their modes at a point: files, values, refusals, and a sphere given so against the sphere itself."""

import json
import pickle

import numpy as np
import pytest
import stoss

STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
SPHERE = stoss.Sphere(radius=0.01, material=STEEL)
BLOCK = stoss.HalfSpace(material=STEEL)
COMPLIANCE = -2.409003500541093e-10  # c₀ of this sphere, from its exact modes (docs/theory/any_body.md)
CUTOFF = 12.0


def ball(**changes):
    """The sphere by its modes at the struck point, whose displacements are those at the pole over √m."""
    modes = stoss.modes(SPHERE, cutoff=CUTOFF)
    rising = np.argsort(modes.omega)
    mass = 4.0 / 3.0 * np.pi * 0.01**3 * STEEL.density
    given = {
        "mass": mass, "curvature": 100.0, "young": STEEL.young, "poisson": STEEL.poisson, "density": STEEL.density,
        "compliance": COMPLIANCE, "complete_to": CUTOFF * SPHERE.scales.frequency / (2 * np.pi), "name": "ball",
        "frequency": modes.omega[rising] * SPHERE.scales.frequency / (2 * np.pi),
        "displacement": modes.radial[rising] / np.sqrt(mass),
    }  # fmt: skip
    return stoss.ModalBody(**{**given, **changes})


@pytest.fixture(scope="module")
def body():
    return ball()


def test_a_sphere_by_its_modes_is_the_sphere(body):
    assert body.scales == pytest.approx(SPHERE.scales, rel=1e-12)
    for against in (None, BLOCK, stoss.Sphere(radius=0.02, material=STEEL)):
        found, exact = (stoss.restitution(each, against=against, speed=0.5) for each in (body, SPHERE))
        allowed = found.restitution_error + exact.restitution_error
        assert abs(found.restitution - exact.restitution) <= allowed
        assert abs(found.contact_time_si / exact.contact_time_si - 1) < 2e-3
    met, itself = (stoss.restitution(each, against="same", speed=0.5) for each in (body, SPHERE))
    assert abs(met.lost_fraction - itself.lost_fraction) <= met.lost_fraction_error + itself.lost_fraction_error
    second = stoss.restitution(stoss.Sphere(radius=0.02, material=STEEL), against=body, speed=0.5)
    assert second.restitution == pytest.approx(found.restitution, abs=1e-6)
    assert repr(second).startswith("Restitution(Sphere(poisson=0.3, radius=0.02 m) against ModalBody('ball', ")


def test_it_is_a_value(body):
    assert body == ball() and hash(body) == hash(ball()) and body != ball(name="other") and body != SPHERE
    assert pickle.loads(pickle.dumps(body)) == body
    assert stoss.ModalBody.from_dict(body.to_dict()) == body
    assert body.material == STEEL and body.frequency_error.tolist() == [0.0] * body.frequency.size
    with pytest.raises(ValueError, match="read-only"):
        body.frequency[0] = 1.0
    with pytest.raises(AttributeError):
        body.mass = 1.0
    assert repr(body) == f"ModalBody('ball', {body.frequency.size} modes to {body.frequency[-1]:.6g} Hz)"
    assert ball(complete_to=None).complete_to == body.frequency[-1]
    assert ball(loss_time=1e-9).material.loss_time == 1e-9


TURNING = {"inertia": np.diag([1e-6, 1e-6, 2e-6]), "point": [0.002, 0.0, 0.01], "normal": [0.0, 0.0, 1.0]}


@pytest.mark.parametrize("suffix", ["json", "npz"])
def test_files_give_back_the_body(tmp_path, suffix):
    path = tmp_path / f"ball.{suffix}"
    whole = ball(curvature=(100.0, 90.0), loss_time=1e-10, compliance_error=1e-13, origin="modes of a sphere",
                 displacement_curvature=np.ones(ball().frequency.size), rotation=TURNING)  # fmt: skip
    for each in (ball(), whole):
        each.save(path)
        assert stoss.ModalBody.read(path) == each
    if suffix == "npz":
        with np.load(path, allow_pickle=False) as file:
            assert file["modes_frequency"].tolist() == whole.frequency.tolist() and str(file["name"]) == "ball"


def rough_ball(**changes):
    """The ball with tangential data of its modes n = 0 and of none along the surface, which is enough to turn."""
    tangent = {"compliance": -1e-10, "compliance_error": 1e-12, "inertia": 0.4 * ball().mass * 1e-4, "arm": 0.01}
    still = np.zeros(ball().frequency.size)
    return ball(**{"tangent": tangent, "tangential_displacement": still, **changes})


@pytest.mark.parametrize("suffix", ["json", "npz"])
def test_files_give_back_what_friction_asks(tmp_path, suffix):
    path = tmp_path / f"ball.{suffix}"
    size = ball().frequency.size
    turned = {"direction": [0.0, 1.0, 0.0], "compliance": 1e-10}
    central = {**TURNING, "point": [0.0, 0.0, 0.01]}
    for each in (rough_ball(), rough_ball(rotation=central, tangent=turned,
                 tangential_displacement_curvature=np.ones(size), tangential_displacement_error=np.ones(size))):
        each.save(path)
        same = stoss.ModalBody.read(path)
        assert same == each and same.tangent.keys() == each.tangent.keys()
        assert pickle.loads(pickle.dumps(each)) == each


def test_points_join_the_names_in_an_npz_file_too(tmp_path, body):
    flat = body.to_dict()
    modes = flat.pop("modes")
    path = tmp_path / "ball.npz"
    np.savez(path, **flat, **{f"modes.{name}": each for name, each in modes.items()})
    assert stoss.ModalBody.read(path) == body


@pytest.mark.parametrize("made, changes, line", [
    (ball, {"mass": -1.0}, "mass: got -1"), (ball, {"mass": np.nan}, "mass: got nan, allowed finite numbers"),
    (ball, {"mass": "heavy"}, "mass: got 'heavy', allowed a number"), (ball, {"curvature": [1.0, 2.0, 3.0]},
     "curvature: got"),
    (ball, {"displacement": [1.0]}, "modes displacement: got"), (ball, {"frequency": [[1.0]]}, "frequency: got"),
    (ball, {"rotation": {"point": [0.0, 0.0, 1.0]}}, "rotation inertia: missing"), (ball, {"name": 3},
     "name: got 3, allowed a text"),
    (rough_ball, {"tangent": None}, "modes tangential_displacement: got one without a tangent"),
    (rough_ball, {"tangential_displacement": None}, "modes tangential_displacement: got none"),
    (rough_ball, {"tangent": 3.0}, "tangent: got 3.0, allowed a mapping with direction and compliance"),
    (rough_ball, {"tangent": {"compliance": 1e-10}}, "tangent inertia: missing"),
])  # fmt: skip
def test_refusals_are_one_line(made, changes, line):
    with pytest.raises(stoss.InvalidInput) as refused:
        made(**changes)
    assert str(refused.value).startswith(line) and "\n" not in str(refused.value)


def test_refusals_of_files_name_them(tmp_path, body):
    path = tmp_path / "some.json"
    unknown = {**body.to_dict(), "colour": "red"}
    for text, line in [("{", "body: not a JSON document"),
                       ('{"mass": 1, "mass": 2}', "body: not a JSON document (the key 'mass' is there twice)"),
                       ('{"modes": {"frequency": [1], "frequency": [2]}}',
                        "body: not a JSON document (the key 'frequency'"),
                       ("[1]", "body: got [1], allowed a mapping"),
                       (json.dumps(unknown), "body: got"), ("{}", "format: got")]:  # fmt: skip
        path.write_text(text)
        with pytest.raises(stoss.InvalidInput) as refused:
            stoss.ModalBody.read(path)
        assert str(refused.value).startswith(f"{path}: {line}") and "\n" not in str(refused.value)
    (tmp_path / "some.npz").write_bytes(b"PK, but no archive")
    with pytest.raises(stoss.InvalidInput, match="not an NPZ file"):
        stoss.ModalBody.read(tmp_path / "some.npz")
    with pytest.raises(FileNotFoundError):
        stoss.ModalBody.read(tmp_path / "none.json")


def test_what_only_other_bodies_can_do_is_refused(body):
    hit = stoss.impact(body, speed=0.5)
    refused = {
        "no field": lambda: hit.field(time=0),
        "a stoss.Disk or a stoss.Sphere": lambda: stoss.modes(body, cutoff=3),
        "without tangential data": lambda: stoss.oblique(body, speed=0.5, angle=10, friction=0.1),
        "leave friction out": lambda: stoss.oblique_impact(body, speed=0.5, angle=10, friction=0.1),
        "two elastic": lambda: stoss.pair_table(body, ratio=(1, 2), speed=(0.01, 0.1)),
        "with a material": lambda: stoss.restitution(stoss.Sphere(poisson=0.3), against=body, speed=0.5),
        "modal bodies": lambda: stoss.restitution(body, against=stoss.Rod(length=1, area=1, material=STEEL), speed=1),
        "higher modes are not known": lambda: stoss.impact(body, speed=0.5, cutoff=50),
    }
    for words, ask in refused.items():
        with pytest.raises(stoss.InvalidInput, match=words):
            ask()


def test_what_works_on_any_pair(body):
    hit = stoss.impact(body, against=BLOCK, speed=0.5, cutoff=CUTOFF)
    path = hit.trajectory()
    assert path.force.max() * hit.body.scales.force == pytest.approx(hit.max_force_si, rel=0.02)
    own = hit.mode_energies[hit.mode_energies["body"] == 0]
    assert own.size == body.frequency.size and hit.energies_at(time=3.0).size == hit.modes
    assert own["omega"] * body.scales.frequency == pytest.approx(2 * np.pi * body.frequency)
    assert hit.state_after(flight=10.0).size == own.size
    curve = stoss.restitution(body, speed=[0.1, 0.5])
    epsilon = stoss.restitution_function(body, speed=(0.1, 0.5))
    assert epsilon(0.3) == pytest.approx(stoss.restitution(body, speed=0.3).restitution, abs=1e-4)
    assert curve.plot() is not None and curve.to_dict()["body"]["mass"] == body.mass
    assert stoss.bounce(body, speed=0.5, count=2, gravity=9.81).restitution.size == 2


def test_sweeps_take_it(tmp_path, body):
    grid = stoss.Grid(bodies=[body, {"kind": "modal", "body": body.to_dict() | {"name": "other"}}],
                      against=["wall", {"kind": "half-space", "material": "structural steel"}],
                       speed=[0.5])  # fmt: skip
    assert stoss.Grid.from_dict(json.loads(json.dumps(grid.to_dict()))) == grid
    made = stoss.sweep(grid, store=tmp_path / "store")
    assert made.restitution.shape == (2, 2, 1) and np.all(made.restitution[0] == made.restitution[1])
    frame = made.to_csv(tmp_path / "sweep.csv")
    assert frame is None and "modal,other" in (tmp_path / "sweep.csv").read_text()
