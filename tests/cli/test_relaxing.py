"""Materials that relax: options and keys, what they are refused for, and the command that reads measured moduli."""

import json
import math

import pytest

BALL = "impact --body sphere --poisson 0.3 --speed 0.1 --cutoff 20"


def restitution(stoss, arguments):
    return float(stoss.data(arguments)[0]["restitution"])


def test_options_are_those_of_a_partner(stoss):
    own = restitution(stoss, f"{BALL} --relaxation 0.5:1+0.2:10 --against sphere,rigid=1")
    c = math.sqrt(2e6 / 1100)
    ball = f"--radius 0.01 --poisson 0.3 --density 1100 --speed {0.1 * c!r} --against sphere,rigid=1,radius=0.01"
    ball += ",young=2e6,density=1100,poisson=0.3"
    times = f"0.5:{0.01 / c!r}+0.2:{0.1 / c!r}"
    in_si = f"impact --body sphere --cutoff 20 {ball}"
    assert own < 0.9
    assert restitution(stoss, f"{in_si} --young 2e6 --relaxation {times}") == pytest.approx(own, rel=1e-9)
    of_relaxed = f"{in_si} --young 6e5 --young-is relaxed --relaxation {times}"
    assert restitution(stoss, of_relaxed) == pytest.approx(own, rel=1e-9)
    turned = f"{BALL} --rigid-body --against sphere,relaxation=0.5:1+0.2:10"
    assert restitution(stoss, turned) == pytest.approx(own, rel=1e-9)


def test_a_quality_is_the_same_at_all_speeds(stoss):
    rows = stoss.data("restitution --body sphere --poisson 0.3 --quality 100 --speed 1e-5,1e-4,1e-3 --tolerance 1e-2")
    for row in rows:  # 2.3853/Q of a slow ball with Q = 100 (docs/theory/loss.md)
        assert float(row["lost_fraction"]) == pytest.approx(0.023853, rel=0.02)


@pytest.mark.parametrize(
    "options, line",
    [
        ("--relaxation 0.5:", "relaxation: got '0.5:', allowed SHARE:TIME+SHARE:TIME..., as in 0.5:1+0.2:10"),
        ("--relaxation 0.5", "relaxation: got '0.5', allowed SHARE:TIME"),
        ("--relaxation 0.75:1+0.5:2", "relaxation: got shares of 1.25 in sum, allowed at most 1"),
        ("--relaxation 0.5:0", "relaxation: got 0, allowed times above 0"),
        ("--relaxation 0.5:-1", "relaxation: got -1, allowed times above 0"),
        ("--relaxation -0.5:1", "relaxation: got -0.5, allowed shares of E(0) above 0"),
        ("--relaxation 0.5:1 --loss-time 0.1", "relaxation: got a relaxation beside a loss_time, allowed one of them"),
        ("--relaxation 0.5:1 --quality 10", "relaxation: got a relaxation beside a quality, allowed one of them"),
        ("--quality 10 --loss-time 0.1", "quality: got a quality beside a loss_time, allowed one of them"),
        ("--quality 1", "quality: got 1, allowed 3 to 1e9"),
        ("--young-is relaxed", "young_is: there is no relaxation"),
        ("--relaxation 1:1 --young-is relaxed", "young_is: got relaxed, with shares of 1 in sum"),
        ("--rigid-body --relaxation 0.5:1 --against sphere", "relaxation: got 0.5:1, allowed none of a rigid body"),
        ("--against sphere,relaxation=0.5:", "against relaxation: got '0.5:', allowed SHARE:TIME"),
        ("--against sphere,relaxation=0.5:1,loss_time=1", "against relaxation: got a relaxation beside a loss_time"),
        ("--against sphere,relaxation=0.5:1,rigid=1", "against relaxation: got 0.5:1, allowed none of a rigid body"),
        ("--against sphere,young_is=relaxed", "against young_is: there is no relaxation"),
        ("--against sphere,relaxation=0.5:1,young_is=E0", "against young_is: got 'E0', allowed instantaneous, relaxed"),
        ("--against plate,thickness=1/thickness=1,relaxation=0.5:1", "against: got 'relaxation', allowed thickness"),
        ("--against wall,relaxation=0.5:1", "against: got 'relaxation', allowed roughness, u0 with wall"),
    ],
)
def test_refusals(stoss, options, line):
    done = stoss.run(f"{BALL} {options}")
    assert done.returncode == 3
    assert done.stderr.startswith(f"stoss: error: {line}"), done.stderr
    assert done.stderr.count("\n") == 1


def test_predict_takes_the_loss_of_the_impact(stoss):
    ball = "--body sphere --material 'bearing steel' --radius 0.005 --relaxation 0.1:1e-4 --speed 0.01 --format json"
    made, computed = (json.loads(stoss.run(f"{each} {ball}").stdout)["records"][0] for each in ("predict", "restitution"))
    assert made["restitution"] == pytest.approx(computed["restitution"], abs=1e-5)
    assert made["material"] == pytest.approx(computed["dissipated"], rel=1e-3) and made["material"] > 0.01


TERMS = [(0.3, 1e-3), (0.4, 1e-1)]


def measured(path, header, row, frequencies):
    lines = [header]
    for f in frequencies:
        modulus = 0.3 + sum(share * 2j * math.pi * f * time / (1 + 2j * math.pi * f * time) for share, time in TERMS)
        lines.append(row(f, 2e6 * modulus))
    path.write_text("\n".join(["# made", *lines, ""]))
    return path


FREQUENCIES = [10 ** (k / 4 - 2) for k in range(21)]


@pytest.mark.parametrize(
    "header, row",
    [
        ("f,E',E''", lambda f, its: f"{f!r},{its.real!r},{its.imag!r}"),
        ("tan_delta;E' [MPa];omega", lambda f, its: f"{its.imag / its.real!r};{its.real / 1e6!r};{2 * math.pi * f!r}"),
        ("Frequency [kHz]\tstorage\tloss [Pa]", lambda f, its: f"{f / 1e3!r}\t{its.real!r}\t{its.imag!r}"),
    ],
)
def test_measured_moduli_become_terms(stoss, tmp_path, header, row):
    path = measured(tmp_path / "rubber.csv", header, row, FREQUENCIES)
    found = json.loads(stoss.run(f"relaxation {path} --format json").stdout)
    assert found["storage_misfit"] < 0.02
    assert found["loss_misfit"] < 0.05
    assert found["young"] == pytest.approx(2e6, rel=0.02)
    assert found["relaxed"] == pytest.approx(0.6e6, rel=0.05)
    given = stoss.data(f"{BALL} --relaxation {found['relaxation']}")
    assert float(given[0]["restitution"]) < 1.0
    table = stoss.run(f"relaxation {path}").stdout
    assert f"--relaxation {found['relaxation']}" in table
    assert "misfit" in table


def test_times_shift_with_the_temperature(stoss, tmp_path):
    path = measured(tmp_path / "m.csv", "f,E',E''", lambda f, its: f"{f!r},{its.real!r},{its.imag!r}", FREQUENCIES)
    here, warm = (
        [float(row["time[s]"]) for row in stoss.data(f"relaxation {path} {options}")]
        for options in ("", "--wlf 17.4:51.6:20 --temperature 30")
    )
    factor = 10 ** (-17.4 * 10 / 61.6)
    assert warm == pytest.approx([time * factor for time in here], rel=1e-6)


@pytest.mark.parametrize(
    "lines, said",
    [
        (["f,E',E''", "1,2,3", "0.5,2,3", "2,2,3"], "line 3: got a frequency that does not rise, allowed rising"),
        (["f,E',E''", "1,2,3", "1,2,3", "2,2,3"], "line 3: got a frequency that does not rise"),
        (["f,tan_delta", "1,0.1"], "line 1 E': missing, a column of storage moduli"),
        (["f,E'", "1,2"], "line 1 E'': missing, a column of E'' or tan_delta"),
        (["E',E''", "1,2"], "line 1 f: missing, a column of frequencies"),
        (["f,E',E'',tan_delta", "1,2,3,4"], "line 1 E'': missing, E'' or tan_delta, one of both"),
        (["f,E',E''", "1,2,3", "2,-2,3"], "line 3: got -2, allowed numbers above 0"),
        (["f,E',E''", "1,2"], "line 2: got 2 values, allowed 3, as in the header"),
        (["f,E',G''", "1,2,3"], "line 1: got 'G''', allowed f or omega"),
        (["f [min],E',E''", "1,2,3"], "line 1: got 'f [min]', allowed Hz, kHz or rad/s"),
        (["f,E',E''", "1,2,x"], "line 2: got 'x'"),
        (["f,E',E''", "1,2,3"], "frequency: got 1 of them, allowed 3 or more"),
        ([""], "missing, a header"),
    ],
)
def test_damaged_measurements_are_refused(stoss, tmp_path, lines, said):
    path = tmp_path / "m.csv"
    path.write_text("\n".join([*lines, ""]))
    done = stoss.run(f"relaxation {path}")
    assert done.returncode == 3
    assert "m.csv" in done.stderr
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "options, said",
    [
        ("--temperature 20", "wlf: missing, C1:C2:REFERENCE"),
        ("--wlf 17:51:20", "temperature: missing"),
        ("--wlf 17:51 --temperature 20", "wlf: got '17:51', allowed C1:C2:REFERENCE"),
        ("--wlf 17:51:20 --temperature -40", "temperature: got -40, allowed above -31"),
    ],
)
def test_shifts_are_refused(stoss, tmp_path, options, said):
    path = measured(tmp_path / "m.csv", "f,E',E''", lambda f, its: f"{f!r},{its.real!r},{its.imag!r}", FREQUENCIES)
    done = stoss.run(f"relaxation {path} {options}")
    assert done.returncode == 3
    assert done.stderr.startswith(f"stoss: error: {said}"), done.stderr
