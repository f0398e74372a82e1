"""One grammar for the numbers of all options, and what is said of a word that is none."""

import subprocess

import pytest

IMPACT = "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 12.5 --quiet"
SLOW = "quasistatic --body disk --poisson 0.33"
CURVE = "restitution --body disk --poisson 0.33 --speed 0.1"
STEEL = "modes --body disk --poisson 0.3 --young 2e11 --density 7850 --radius 0.01"
# Every option with a number: a base without it.
NUMERIC = [
    ("modes", "--poisson"), ("modes --body disk --poisson 0.3", "--cutoff"), ("restitution --speed 0.1", "--poisson"),
    ("restitution --body disk --poisson 0.3", "--speed"), (CURVE, "--tolerance"), (CURVE, "--threads"),
    (STEEL.replace("--young 2e11", ""), "--young"), (STEEL.replace("--density 7850", ""), "--density"),
    (STEEL.replace("--radius 0.01", ""), "--radius"), (IMPACT.replace("--speed 0.1", ""), "--speed"),
    (IMPACT.replace("--body disk --poisson 0.33", ""), "--poisson"), (IMPACT.replace("--cutoff 12.5", ""), "--cutoff"),
    (IMPACT, "--step"), (IMPACT, "--nodes"), (IMPACT, "--every"), (SLOW, "--speed"), (SLOW, "--compression"),
    (f"{SLOW} --speed 0.1", "--cutoff"),
]  # fmt: skip
OTHER = [
    ("modes --body disk --poisson 0.3", "--output"), ("modes --poisson 0.3", "--format"), (STEEL, "--plane"),
    (IMPACT, "--trajectory"), (IMPACT, "--against"), (IMPACT, "--body"), (IMPACT, "--tail"), (CURVE, "--resume"),
    (f"{SLOW} --speed 0.1", "--law"),
]  # fmt: skip
NO_NUMBERS = [" ", "0x1p-3", "1e-400", "1e400", "nan", "inf", "-inf", "+-1", "--1", "1e", ".", "1_0", "1 2", "1\t", "1,"]


def call(stoss, base, *words):
    return subprocess.run([stoss.path, *base.split(), *words], capture_output=True, text=True, timeout=60)


def assert_refused(result, name):
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name.removeprefix('--')}: got '") and "allowed" in line


@pytest.mark.parametrize("base, name", NUMERIC + OTHER)
def test_empty_value(stoss, base, name):
    assert_refused(call(stoss, base, name, ""), name)
    assert_refused(call(stoss, base, f"{name}="), name)


@pytest.mark.parametrize("base, name", NUMERIC)
def test_what_is_no_number(stoss, base, name):
    for text in NO_NUMBERS:
        assert_refused(call(stoss, base, f"{name}={text}"), name)


@pytest.mark.parametrize("text", ["0.25", " 0.25 ", "+.25", "25e-2", "2.5E-1", "0.250000"])
def test_ways_to_write_a_number(stoss, text):
    for base in ("modes --cutoff 3", "restitution --speed 0.1"):
        expected = call(stoss, base, "--poisson=0.25")
        assert call(stoss, base, f"--poisson={text}").stdout == expected.stdout != ""


def test_whole_numbers(stoss):
    expected = call(stoss, IMPACT, "--nodes=100").stdout
    assert call(stoss, IMPACT, "--nodes=1e2").stdout == call(stoss, IMPACT, "--nodes= 100.0").stdout == expected != ""
    for text in ("64.5", "1e99", "-1e99"):
        assert_refused(call(stoss, IMPACT, f"--nodes={text}"), "nodes")


@pytest.mark.parametrize(
    "words, meant",
    [
        ("restituton --body disk --poisson 0.3", "restitution"),
        ("mode", "modes"),
        ("quasi --body disk --poisson 0.3", "quasistatic"),
        ("impact --poison 0.3 --speed 0.1", "--poisson"),
        ("impact --body disk --poisson 0.3 --sped=0.1", "--speed"),
        ("restitution --body disk --poisson 0.3 --speed 0.1 --tol 1e-4", "--tolerance"),
        ("modes --body disk --poisson 0.3 cutoff 3", "--cutoff"),
    ],
)
def test_did_you_mean(stoss, words, meant):
    result = stoss.run(words)
    assert result.returncode == 2
    (line,) = result.stderr.splitlines()
    assert f", did you mean {meant}?" in line


def test_no_guess_for_another_word(stoss):
    for words in ("bounce", "modes --body disk --poisson 0.3 --colour red", "modes --poisson 0.3 -x"):
        assert "did you mean" not in stoss.run(words).stderr


@pytest.mark.parametrize("option", ["--poisson", "--speed", "--format", "--output", "--resume", "--wrong"])
def test_long_values_are_shortened(stoss, option):
    result = call(stoss, CURVE.replace(f"{option} 0.", ""), option, 100_000 * "1")
    (line,) = result.stderr.splitlines()
    assert result.returncode in (2, 3, 4) and len(line) < 500


def test_control_characters_are_visible(stoss):
    for words in (["\x1b[2J\n"], ["modes", "--poisson", "\x1b[2J\n"], ["modes", "--poisson=0", "--format", "\x1b[2J\n"]):
        result = call(stoss, "", *words)
        (line,) = result.stderr.splitlines()
        assert line.isprintable() and "\\x1b[2J\\n" in line
