"""`stoss.fit` and `stoss fit`: what they find, print, write and refuse."""

import importlib.util
import os
import subprocess
import sys
import types
from pathlib import Path

import numpy as np
import pytest
from glass_ball import BALL, RANGE, fitted

import stoss


@pytest.mark.long
def test_misfits_are_those_of_the_law_against_stoss():
    fit = stoss.fit(BALL, against="same", law="tsuji", speed=RANGE, friction=0.2)
    curve = stoss.restitution(BALL, against="same", speed=fit.speed, tolerance=3e-3)
    assert fit.restitution == pytest.approx(curve.restitution, abs=1e-12)
    assert fit.contact_time == pytest.approx(curve.contact_time_si)
    along = fit.sliding * 0.2 * fit.speed[4]
    angled = stoss.oblique(BALL, against="same", speed=fit.speed[4], tangential=along, friction=0.2)
    assert fit.tangential_restitution[4] == pytest.approx(angled.tangential_restitution, abs=1e-9)
    deviations = {
        "restitution": fit.fitted.restitution(fit.speed) - curve.restitution,
        "contact_time": fit.fitted.contact_time(fit.speed) / curve.contact_time_si - 1,
        "tangential_restitution":
            fit.fitted.tangential_restitution(fit.speed, fit.sliding) - fit.tangential_restitution,
    }  # fmt: skip
    assert list(fit.misfit) == list(deviations)
    for name, each in deviations.items():
        assert fit.misfit[name] == pytest.approx((np.abs(each).max(), np.sqrt(np.mean(each**2))), rel=1e-6)


@pytest.mark.parametrize("law", ["linear", "viscoelastic", "hunt-crossley", "thornton", "walton"])
def test_no_neighbouring_constant_is_nearer(law):
    fit = fitted(law)
    for name in ("damping", "yield_speed", "e"):
        if hasattr(fit.fitted, name):
            for factor in (0.99, 1.01) if name != "e" else (0.9999, 1.0001):
                other = type(fit.fitted)(**{**vars(fit.fitted), name: factor * getattr(fit.fitted, name)})
                wrong = other.restitution(fit.speed) - fit.restitution
                assert np.sqrt(np.mean(wrong**2)) > fit.misfit["restitution"].rms


def test_laws_of_balls_on_a_block_and_without_a_material():
    block = stoss.HalfSpace(material=stoss.materials["structural steel"], loss_time=0)
    bare = stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], loss_time=0)
    assert stoss.fit(bare, against=block, law="viscoelastic", speed=RANGE).fitted.pair.radius == BALL.radius
    # Ratios: the same bodies in SI and in their own units.
    glass, eta = BALL.material, 1.6e-8
    lossy = stoss.Sphere(radius=BALL.radius, material=glass, loss_time=eta)
    own = stoss.Sphere(poisson=glass.poisson, loss_time=eta / lossy.scales.time)
    c = lossy.scales.speed
    ours = stoss.fit(lossy, law="linear", speed=RANGE)
    theirs = stoss.fit(own, law="linear", speed=(RANGE[0] / c, RANGE[1] / c))
    assert theirs.fitted.stiffness == pytest.approx(ours.fitted.stiffness / (glass.young * BALL.radius), rel=1e-6)
    assert theirs.speed[0] == pytest.approx(RANGE[0] / c)
    # And with other numbers: c = 2.
    twice = stoss.Sphere(poisson=own.poisson, loss_time=own.loss_time / 2, young=4.0)
    other = stoss.fit(twice, law="linear", speed=(RANGE[0] / c, RANGE[1] / c))
    assert other.fitted.stiffness == pytest.approx(4 * theirs.fitted.stiffness, rel=1e-6)
    assert other.misfit["restitution"] == pytest.approx(theirs.misfit["restitution"], rel=1e-4)


def test_the_misfit_comes_first_and_stays_in_files(tmp_path):
    fit = stoss.fit(BALL, law="tsuji", speed=RANGE, program="lammps")
    first, second, *_, last = str(fit).splitlines()
    assert first.split() == ["#", "misfit", "maximum", "rms"]
    assert second.split()[:2] == ["#", "restitution"]
    assert float(second.split()[2]) == pytest.approx(fit.misfit["restitution"].maximum, rel=0.05)
    assert last == fit.lines[-1]
    fit.write(tmp_path / "law.in")
    assert (tmp_path / "law.in").read_text(encoding="utf-8") == f"{fit}\n"
    rows = stoss.fit(BALL, law="table", speed=RANGE, program="acutrace")  # whose files know no comments
    rows.write(tmp_path / "table")
    read = np.loadtxt(tmp_path / "table")
    assert np.abs(np.interp(fit.speed, *read.T) - fit.restitution).max() <= rows.misfit["restitution"].maximum + 1e-9
    assert "misfit" in str(rows).splitlines()[0]
    rubbing = stoss.fit(BALL, law="thornton", speed=RANGE, friction=0.2)
    assert "tangential_restitution   not fitted" in str(rubbing).splitlines()
    fit.to_csv(tmp_path / "law.csv")
    assert stoss.read_csv(tmp_path / "law.csv")["law_restitution"] == pytest.approx(fit.law_restitution)


@pytest.mark.parametrize("law", ["linear", "walton", "mujoco", "table"])
def test_the_misfit_of_friction_is_never_hidden(law):
    """Constants along the surface come with the misfit of ε_t; a law without says that it fits none."""
    fit = stoss.fit(BALL, against="same", law=law, speed=RANGE, friction=0.2)
    said = next(line.split()[1:] for line in str(fit).splitlines() if line.startswith("tangential_restitution"))
    if {"tangential_ratio", "beta0"} & set(fit.constants):
        assert [float(each) for each in said] == pytest.approx(fit.misfit["tangential_restitution"], rel=0.05)
    else:
        assert said == ["not", "fitted"] and "tangential_restitution" not in fit.misfit


def test_the_table_of_the_page_is_made_so():
    root = Path(__file__).parents[3]
    found = importlib.util.spec_from_file_location("make", root / "studies/laws/make.py")
    study = importlib.util.module_from_spec(found)
    found.loader.exec_module(study)
    rows = (root / "docs/results/laws.csv").read_text(encoding="utf-8").splitlines()
    assert study.row("bearing steel", "table") in rows


@pytest.mark.parametrize(
    "changed, said",
    [
        ({"law": "hooke"}, "law: got 'hooke', allowed 'linear', "),
        ({"program": "edem"}, "program: got 'edem', allowed 'lammps', "),
        ({"law": "thornton", "program": "lammps"}, "law: got thornton for lammps, allowed linear, tsuji, viscoelastic"),
        ({"program": "yade"}, "allowed a stoss.Sphere for yade"),
        ({"against": stoss.Disk(poisson=0.3)}, "against: got Disk"),
        ({"body": stoss.Disk(poisson=0.3)}, "body: got Disk"),
    ],
)
def test_refusals_are_one_line(changed, said):
    given = {"body": BALL, "law": "tsuji", "speed": RANGE, **changed}
    with pytest.raises(stoss.InvalidInput) as error:
        stoss.fit(given.pop("body"), **given)
    assert said in str(error.value) and "\n" not in str(error.value)


def test_impacts_without_a_value_are_not_fitted(monkeypatch):
    """As of a ball with a loss time of 1000 R/c, which takes minutes to say so."""
    none = types.SimpleNamespace(restitution=np.append(np.ones(8), np.nan), contact_time=np.ones(9))
    monkeypatch.setattr("stoss.laws._elastic.restitution", lambda *_, **__: none)
    with pytest.raises(stoss.NotConverged, match="^fit: 1 of 9 impacts have no ε "):
        stoss.fit(stoss.Sphere(poisson=0.31), law="linear", speed=RANGE)


def test_without_scipy_one_line_says_so(interpreter):
    done = interpreter.run(
        "import sys; sys.modules['scipy'] = None\n"
        "import stoss\n"
        "try: stoss.fit(stoss.Sphere(poisson=0.3), law='linear', speed=(0.01, 0.1))\n"
        "except ImportError as error: print(error)"
    )
    assert done.stdout == "fit needs SciPy: pip install scipy, or apt install python3-scipy\n", done.stderr


@pytest.mark.skipif("STOSS" not in os.environ, reason="needs the command in STOSS")
class TestCommand:
    def run(self, interpreter, *words):
        path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
        return subprocess.run(
            [os.environ["STOSS"], "fit", *words], env={**interpreter.environment, "PATH": path}, capture_output=True,
            encoding="utf-8", timeout=60,
        )  # fmt: skip

    def test_it_prints_what_python_finds(self, interpreter, tmp_path):
        words = "--body sphere --material glass --radius 0.005 --against sphere,radius=0.01,material=granite"
        file = tmp_path / "law"
        done = self.run(
            interpreter, *words.split(), *"--speed 0.01:0.1 --law linear --program lammps -o".split(), str(file)
        )
        rock = stoss.Sphere(radius=0.01, material=stoss.materials["granite"])
        fit = stoss.fit(BALL, against=rock, law="linear", speed=RANGE, program="lammps")
        assert (done.returncode, done.stdout) == (0, ""), done.stderr
        assert all("taken as sound" in line for line in done.stderr.splitlines())
        assert file.read_text(encoding="utf-8") == f"{fit}\n"

    @pytest.mark.parametrize(
        "words, code, said",
        [
            ("--body sphere --poisson 0.3 --law tsuji --speed 0.1", 3, "speed: got '0.1', allowed LOW:HIGH"),
            ("--body disk --poisson 0.3 --law tsuji --speed 0.1:0.2", 3, "body: got disk, allowed sphere"),
            ("--body sphere --poisson 0.3 --law table --speed 0.1:0.2 --program yade", 3, "for yade, allowed linear"),
            ("--body sphere --poisson 0.3 --law tsuij --speed 0.1:0.2", 2, "tsuij"),
            ("--body sphere --poisson 0.3 --law tsuji --speed 0.1:0.2 --program edem", 2, "edem"),
        ],
    )
    def test_refusals(self, interpreter, words, code, said):
        done = self.run(interpreter, *words.split())
        assert (done.returncode, done.stdout, done.stderr.count("\n")) == (code, "", 1)
        assert done.stderr.startswith("stoss: error: ") and said in done.stderr
