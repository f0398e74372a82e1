"""The fields of results are the quantities that the core lists, in its order and in its units."""

import dataclasses
import math
import re

import pytest
import stoss

QUANTITIES = {
    kind: [column for name, _, has_error, _ in table for column in ((name, f"{name}_error") if has_error else (name,))]
    for kind, table in stoss._core.quantities.items()
}
Q = stoss.quasistatic
STEEL = "--young 2.1e11 --density 7850"
HARD = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)

# Kind of result, its class, quantities that the class has in another form, fields that are no
# quantities.
RESULTS = [
    ("impact", stoss.Impact, set(), {"body", "against", "speed", "tail", "mode_energies", "keep", "state", "_handle"}),
    ("restitution", stoss.Restitution, set(),
     {"body", "bodies", "against", "poisson", "speed", "reason", "tolerance", "absolute", "state"}),
    ("oblique", stoss.ObliqueRestitution, set(),
     {"body", "against", "speed", "tangential", "spin", "second_spin", "friction", "reason", "tolerance", "state",
      "energy"}),
    ("oblique impact", stoss.ObliqueImpact, set(),
     {"body", "against", "speed", "tangential", "spin", "second_spin", "friction", "energy", "state", "_handle"}),
    ("oblique ledger", stoss.ObliqueLedger, set(), set()),
    ("oblique snapshot", stoss.ObliqueTrajectory, set(),
     {"impact", "x", "y", "second_x", "second_y", "place", "measure", "point_pressure", "point_friction", "slip",
      "grip"}),
    ("bounce", stoss.Bounces, set(), {"body", "against", "cutoff", "tail", "gravity", "decay_time", "state"}),
    ("sample", stoss.RestitutionDistribution, set(),
     {"body", "against", "speed", "temperature", "highest", "spectrum", "seed", "error", "mean", "mean_error",
      "numerical_error", "spread", "above_one", "reason"}),
    ("prediction", stoss.Prediction, {"yield"},
     {"body", "against", "yielding", "influences", "warnings", "yield_speed", "impression_speed", "sticking_speed",
      "adhesion_speed", "work_of_adhesion", "uncertainties", "tolerance"}),
    ("snapshot", stoss.Trajectory, set(), {"impact"}),
    ("mode", stoss.Modes, {"family"}, {"body", "poisson", "cutoff"}),  # radial_family
    ("sphere mode", stoss.Modes, set(), {"body", "poisson", "cutoff"}),
    ("extrapolation", stoss.Extrapolation, set(), {"poisson", "speed", "hard_wall"}),
    ("slow impact", Q.SlowImpact, set(), {"law", "poisson", "speed", "body"}),
    ("rayleigh", Q.RayleighEstimate, set(), {"law", "cutoff", "poisson", "speed", "mode_energies", "body"}),
    ("point slow impact", Q.PointSlowImpact, set(), {"law", "poisson", "speed", "body"}),
    ("point rayleigh", Q.PointRayleighEstimate, set(),
     {"law", "cutoff", "poisson", "speed", "mode_energies", "body"}),
    ("soft static contact", Q.SoftStaticContact, set(), {"poisson", "compression", "cutoff", "against"}),
]  # fmt: skip


@pytest.mark.parametrize("kind, result, otherwise, others", RESULTS, ids=[case[0] for case in RESULTS])
def test_fields_are_the_quantities_of_the_core(kind, result, otherwise, others):
    declared = [field.name for field in dataclasses.fields(result) if field.name not in others]
    assert declared == [name for name in QUANTITIES[kind] if name not in otherwise]


@pytest.mark.parametrize("kind, result, otherwise, others", RESULTS, ids=[case[0] for case in RESULTS])
def test_every_quantity_is_documented(kind, result, otherwise, others):
    entries = re.findall(r"^    (\w+(?:,\s+\w+)*)(?=[ :])", result.__doc__, re.MULTILINE)
    documented = {name for entry in entries for name in re.findall(r"\w+", entry)}
    assert set(QUANTITIES[kind]) - otherwise <= documented


def test_arrays_have_the_quantities_of_the_core():
    hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=10)
    slow = Q.rayleigh(poisson=0.33, speed=1e-3, cutoff=10)
    limits = stoss.extrapolated_restitution(
        poisson=0.33, speed=0.2, cutoffs=[8, 10, 12], hardnesses=[100, 150, 200]
    )  # fmt: skip
    for kind, array in (
        ("mode energy", hit.mode_energies), ("driven mode", slow.mode_energies), ("soft impact", limits.impacts)
    ):  # fmt: skip
        assert sorted(array.dtype.names) == sorted(QUANTITIES[kind])


def header(result, path):
    result.to_csv(path)
    return next(line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")).split(",")


def test_columns_are_in_the_order_of_the_core_with_its_units(tmp_path):
    columns = header(stoss.restitution(poisson=0.33, speed=[0.1]), tmp_path / "curve.csv")
    assert [column.split("[")[0] for column in columns] == ["poisson", "speed", *QUANTITIES["restitution"]]
    assert {"speed[c]", "contact_time_error[R/c]", "max_force[piRE]", "cutoff[c/R]", "restitution"} <= set(columns)


def test_rods_have_their_own_units_at_every_instant(tmp_path):
    steel = stoss.materials["structural steel"]
    rod = stoss.Rod(length=2.0, area=1e-4, material=steel)
    hit = stoss.impact(rod, speed=1.0, cutoff=100)
    assert "max_force_si[N]" in header(hit, tmp_path / "impact.csv") and "contact time 2" in repr(hit)
    path = hit.trajectory(every=10)
    expected = "time[L/c],center[L],velocity[c],force[EA],translation,vibration,stored,dissipated,unresolved"
    assert header(path, tmp_path / "path.csv") == [
        *expected.split(","), "contact_half_width[L]",
        "time_si[s]", "center_si[m]", "velocity_si[m/s]", "force_si[N]", "contact_half_width_si[m]",
    ]  # fmt: skip
    assert path.time_si[-1] == path.time[-1] * rod.scales.time and path.velocity_si[0] == pytest.approx(1.0, rel=1e-12)
    with pytest.raises(AttributeError, match="no material"):
        _ = stoss.impact(poisson=0.33, speed=0.1, cutoff=6).trajectory().time_si
    assert "R/c" not in repr(path)


@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
@pytest.mark.parametrize(
    "arguments, result",
    [
        ("restitution --poisson 0.33 --speed 0.1", lambda: stoss.restitution(poisson=0.33, speed=0.1)),
        ("restitution --body rod --speed 0.1 --tolerance 0.01 --against rod,length=2.5",
         lambda: stoss.restitution(stoss.Rod(), speed=0.1, tolerance=0.01, against=stoss.Rod(length=2.5))),
        ("restitution --body sphere --poisson 0.3 --speed 0.1",
         lambda: stoss.restitution(stoss.Sphere(poisson=0.3), speed=0.1)),
        ("oblique --poisson 0.33 --speed 0.1 --tangential 0.1 --friction 0.3 --tolerance 0.1",
         lambda: stoss.oblique(stoss.Disk(poisson=0.33), speed=0.1, tangential=0.1, friction=0.3, tolerance=0.1)),
        ("quasistatic --poisson 0.33 --speed 1e-3", lambda: Q.rayleigh(poisson=0.33, speed=1e-3)),
        ("quasistatic --body sphere --poisson 0.3 --speed 1e-3",
         lambda: Q.rayleigh(stoss.Sphere(poisson=0.3), speed=1e-3)),
        ("predict --body sphere --poisson 0.3 --radius 0.01 --yield 1e9 --speed 1 " + STEEL,
         lambda: stoss.predict(stoss.Sphere(radius=0.01, material=HARD), speed=1.0)),
        ("bounce --poisson 0.33 --speed 0.1 --count 2 --flight-time 9",
         lambda: stoss.bounce(poisson=0.33, speed=0.1, count=2, flight_time=9)),
        (f"quasistatic --body sphere --poisson 0.3 --radius 0.01 --yield 1e9 --speed 0.01 {STEEL}",
         lambda: Q.rayleigh(stoss.Sphere(radius=0.01, material=HARD), speed=0.01)),
    ],
    ids=["disk", "rod", "sphere", "oblique", "rayleigh", "rayleigh-sphere", "predict", "bounce", "rayleigh-sphere-si"],
)  # fmt: skip
def test_order_and_units_are_those_of_the_command(command, tmp_path, arguments, result):
    document = command(arguments)
    units = document["units"]
    columns = [f"{name}[{units[name]}]" if name in units else name for name in document["records"][0]]
    ours = header(result(), tmp_path / "python.csv")
    early = ("poisson", "speed_si[m/s]")  # the command has this SI value next to its own, Python with all others
    others = ("ledger", "influences", "warnings")
    assert [name for name in ours if name not in early] == [n for n in columns if n not in (*early, *others)]


@pytest.mark.parametrize(
    "arguments, result",
    [
        (f"restitution --poisson 0.3 --radius 0.01 --speed 1 {STEEL}",
         lambda disk, rod: stoss.restitution(disk, speed=1.0)),
        (f"restitution --body rod --length 0.5 --area 1e-4 --speed 1 --tolerance 0.05 {STEEL} "
         "--against rod,length=1,area=1e-4,young=2.1e11,density=7850",
         lambda disk, rod: stoss.restitution(
             rod, speed=1.0, tolerance=0.05, against=stoss.Rod(length=1.0, area=1e-4, material=rod.material))),
        (f"impact --poisson 0.3 --radius 0.01 --speed 1 --cutoff 20 {STEEL}",
         lambda disk, rod: stoss.impact(disk, speed=1.0, cutoff=20)),
        (f"impact --body rod --length 0.5 --area 1e-4 --speed 1 --cutoff 20 {STEEL}",
         lambda disk, rod: stoss.impact(rod, speed=1.0, cutoff=20)),
        (f"restitution --body sphere --poisson 0.3 --radius 0.01 --yield 1e9 --speed 0.01 {STEEL}",
         lambda *_: stoss.restitution(stoss.Sphere(radius=0.01, material=HARD), speed=0.01)),
        (f"impact --body sphere --poisson 0.3 --radius 0.01 --yield 1e9 --speed 1 --cutoff 20 {STEEL} "
         "--against sphere,radius=0.02,young=2.1e11,density=7850,yield=1e9",
         lambda *_: stoss.impact(stoss.Sphere(radius=0.01, material=HARD), speed=1.0, cutoff=20,
                                 against=stoss.Sphere(radius=0.02, material=HARD))),
        (f"quasistatic --body sphere --poisson 0.3 --radius 0.01 --yield 1e9 --speed 0.01 {STEEL}",
         lambda *_: Q.rayleigh(stoss.Sphere(radius=0.01, material=HARD), speed=0.01)),
    ],
    ids=["disk", "rods", "impact", "impact-rod", "sphere", "impact-sphere", "rayleigh-sphere"],
)  # fmt: skip
def test_si_columns_are_those_of_the_command(command, tmp_path, arguments, result):
    steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
    ours = result(stoss.Disk(radius=0.01, material=steel), stoss.Rod(length=0.5, area=1e-4, material=steel))
    document = command(arguments)
    units, (record,) = document["units"], document["records"]
    theirs = [f"{name}[{units[name]}]" for name in record if "_si" in name]
    assert [column for column in header(ours, tmp_path / "python.csv") if "_si" in column] == theirs
    for column in theirs:
        name = column.partition("[")[0]
        assert getattr(ours, name) == pytest.approx(math.inf if record[name] == "unknown" else record[name], rel=1e-9)
