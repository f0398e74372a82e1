"""Bad input: one clear line, the right exit code, nothing on stdout."""

import pytest

BAD_VALUES = [
    ("modes --body disk --poisson 1", "poisson", "1"),
    ("modes --body disk --poisson -1", "poisson", "-1"),
    ("modes --body disk --poisson 1.5", "poisson", "1.5"),
    ("modes --poisson nan", "poisson", "nan"),
    ("modes --poisson inf", "poisson", "inf"),
    ("impact --speed 0.1 --body disk --poisson 1", "poisson", "1"),
    ("restitution --speed 0.1 --poisson nan", "poisson", "nan"),
    ("modes --body disk --poisson 0.33 --cutoff 0.5", "cutoff", "0.5"),
    ("modes --body disk --poisson 0.33 --cutoff 0", "cutoff", "0"),
    ("modes --body disk --poisson 0.33 --cutoff -3", "cutoff", "-3"),
    ("modes --body disk --poisson 0.33 --cutoff nan", "cutoff", "nan"),
    ("modes --body disk --poisson 0.33 --cutoff 1e9", "cutoff", "1000000000"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --cutoff 0.5", "cutoff", "0.5"),
    ("impact --body disk --poisson 0.33 --speed 0.1,0.2", "speed", "2 numbers"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --every 0", "every", "0"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --every 3", "every", "--every without --trajectory"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --against wall,hardness=100", "against", "hardness"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --against exponential,hardness=0", "against hardness", "0"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --against exponential,hardness=inf", "against hardness", "inf"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --against exponential,strength=-1", "against strength", "-1"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --against exponential --tail static", "tail", "exponential"),
    ("restitution --body disk --poisson 0.33 --speed 0.1,nan", "speed", "nan"),
    ("restitution --body disk --poisson 0.33 --speed 0.1,,0.2", "speed", "0.1,,0.2"),
    ("restitution --body disk --poisson 0.33 --speed 0.1,", "speed", "0.1,"),
    ("restitution --body disk --poisson 0.33 --speed 0.1,x", "speed", "x"),
    ("restitution --body disk --poisson 0.33 --speed 0.1m/s", "speed", "0.1m/s"),
    ("restitution --body disk --poisson 0.33 --speed log:0.1:0.2", "speed", "log:0.1:0.2"),
    ("restitution --body disk --poisson 0.33 --speed log:0:0.2:5", "speed", "log:0:0.2:5"),
    ("restitution --body disk --poisson 0.33 --speed log:0.1:0.2:0", "speed", "log:0.1:0.2:0"),
    ("restitution --body disk --poisson 0.33 --speed log:0.1:0.2:1e12", "speed", "log:0.1:0.2:1e12"),
    ("restitution --body disk --poisson 0.33 --speed log:.1:.2:1000000000", "speed", "n is 1000000000, not a whole number from 1"),
    ("restitution --body disk --poisson lin:0:0.5:1001 --speed lin:0.1:0.2:1000", "speed",
     "1000 speeds for each of 1001 Poisson's ratios, 1001000 values, allowed up to 1000000"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --nodes " + "1" * 5000, "nodes", "(5000 bytes)"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --mode -1,0,energy=0.1", "vibration", "mode (-1, 0) of the first"),
    ("restitution --body disk --poisson 0.33 --speed 0.1 --mode 2,-1,energy=0.1", "vibration", "mode (2, -1) of the first"),
    ("distribution --body disk --poisson 0.33 --speed 0.1 --spectrum -1,0,energy=0.1", "vibration", "mode (-1, 0)"),
    ("bounce --body rod --speed 0.1 --flight-time 9 --mode 5,0,energy=0.1", "vibration", "allowed order 0 (a flat end"),
    ("restitution --body disk --poisson 0.33 --speed 0.1,0.2,inf", "speed", "inf"),
    ("restitution --body disk --poisson 0.33 --speed lin:0.1:nan:3", "speed", "lin:0.1:nan:3"),
    ("restitution --body disk --poisson 0.33 --speed lin:0.5:1.5:3", "speed", "1.5"),
    ("restitution --speed 0.1 --poisson abc", "poisson", "abc"),
    ("restitution --speed 0.1 --body disk --poisson 0.33,nan", "poisson", "nan"),
    ("restitution --speed 0.1 --body disk --poisson 0.33,1", "poisson", "1"),
    ("restitution --speed 0.1 --body disk --poisson 0.33,", "poisson", "0.33,"),
    ("restitution --speed 0.1 --poisson lin:-1:0.5:4", "poisson", "-1"),
    ("restitution --speed 0.1 --poisson log:-0.5:0.5:4", "poisson", "log:-0.5:0.5:4"),
    ("restitution --body disk --poisson 0.33 --speed 0.1 --threads -1", "threads", "-1"),
    ("restitution --body disk --poisson 0.33 --speed 0.1 --threads 5000", "threads", "5000"),
    ("restitution --body disk --poisson 0.3,0.2 --speed 1 --young 1e9 --density 1000 --radius 1", "poisson", "2 numbers"),
    ("restitution --body disk --poisson 0.33 --speed 1 --young 1e9", "material", "disk without density"),
    ("restitution --body disk --poisson 0.33 --speed 1 --plane strain", "material", "disk without young"),
    ("modes --body disk --poisson 0.5 --young 1e9 --density 1000 --radius 1", "poisson", "0.5"),
    ("modes --body disk --poisson 0.3 --young -1e9 --density 1000 --radius 1", "young", "-1000000000"),
    ("modes --body disk --poisson 0.3 --young 1e9 --density 0 --radius 1", "density", "0"),
    ("modes --body disk --poisson 0.3 --young 1e9 --density 1000 --radius nan", "radius", "nan"),
    ("restitution --body disk --poisson 0.3 --young 2e11 --density 7850 --radius 1 --speed 10000", "speed", "10000, allowed 5.04"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --trajectory x -o x", "trajectory", "--output"),
    ("modes --poisson abc", "poisson", "'abc'"),
    ("modes --body disk --poisson 0.33,0.3", "poisson", "0.33,0.3"),
    ("impact --body disk --poisson 0.33 --speed 0.1 --nodes 1e99", "nodes", "1e99"),
    ("restitution --body disk --poisson 0.33 --speed 0.1 --threads two", "threads", "two"),
    ("restitution --body disk --poisson 0.33 --speed 1.0000000001", "speed", "1.0000000001, allowed"),
    ("modes --body disk --poisson 0.9950000000001", "poisson", "0.9950000000001, allowed"),
]


@pytest.mark.parametrize("arguments, name, got", BAD_VALUES)
def test_value_out_of_range(stoss, arguments, name, got):
    result = stoss.run(arguments)
    assert result.returncode == 3
    assert result.stdout == ""
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ")
    assert got in line
    assert "allowed" in line


@pytest.mark.parametrize("bad", ["--speed 2", "--speed 0.1 --tolerance 7", "--speed 0.1 --threads -1"])
def test_refused_curve_leaves_the_output_alone(stoss, tmp_path, bad):
    path = tmp_path / "curve.csv"
    path.write_text("precious")
    assert stoss.run(f"restitution --body disk --poisson 0.33 -o {path}", bad).returncode == 3
    assert stoss.run(f"restitution --body disk --poisson 0.33,7 --speed 0.1 -o {path}").returncode == 3
    assert path.read_text() == "precious"


def test_motion_that_the_step_does_not_resolve(stoss):
    result = stoss.run("impact --body disk --poisson 0.95 --speed 0.4 --cutoff 50 --tail static --step 0.02")
    assert result.returncode == 1
    assert "energy" in result.stderr and "smaller step" in result.stderr


@pytest.mark.parametrize("word", ["rebound", "--colour", "-V"])
def test_unknown_word_is_named(stoss, word):
    assert f"unknown argument: {word}" in stoss.run(word).stderr
    assert f"unknown argument: {word}" in stoss.run("restitution --body disk --poisson 0.33", word).stderr


BAD_USAGE = [
    "",
    "rebound",
    "modes",
    "modes --poisson",
    "modes --body disk --poisson 0.33 --colour red",
    "modes --body disk --poisson 0.33 extra",
    "modes --body disk --poisson 0.33 --format xml",
    "impact --body disk --poisson 0.33",
    "impact --body disk --poisson 0.33 --speed",
    "impact --body disk --poisson 0.33 --speed 0.1 --wall exponential",
    "impact --speed 0.1",
    "restitution --speed 0.1",
    "restitution --body ball --poisson 0.33 --speed 0.1",
    "impact --body disk --poisson 0.33 --speed 0.1 --tail none",
    "restitution --body disk --poisson 0.33",
    "restitution --body disk --poisson 0.33 --speed 0.1 --resume",
    "restitution --body disk --poisson 0.3 --young 1 --density 1 --radius 1 --plane middle --speed 1",
]


@pytest.mark.parametrize("arguments", BAD_USAGE)
def test_usage(stoss, arguments):
    result = stoss.run(arguments)
    assert result.returncode == 2
    assert result.stdout == ""
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: ")
    assert "--help" in line


def test_range_ends_are_allowed(stoss):
    for poisson in ("-0.95", "0.995"):
        assert stoss.run(f"modes --body disk --poisson {poisson} --cutoff 5").returncode == 0
    for speed in ("1e-8", "1"):
        assert stoss.run(f"impact --body disk --poisson 0.33 --cutoff 12.5 --quiet --speed {speed}").returncode == 0
