"""Bodies of few modes and thin hollow ones, in every subcommand: a value, or in one line why there is none."""

import json
import math

import pytest

pytestmark = pytest.mark.numbers

R, YOUNG, DENSITY, POISSON = 0.02, 210e9, 7850.0, 0.3


def written(folder, name, mass, frequencies, shapes, compliance, complete_to, bends=0.0):
    modes = {"frequency": frequencies, "displacement": shapes, "displacement_curvature": [bends * u for u in shapes]}
    modes |= {f"{key}_error": [1e-4 * abs(each) for each in modes[key]] for key in ("frequency", "displacement")}
    body = {
        "format": "stoss modal body 1", "name": name, "mass": mass, "curvature": [1 / R, 1 / R], "young": YOUNG,
        "poisson": POISSON, "density": DENSITY, "compliance": compliance, "compliance_error": 1e-3 * compliance,
        "complete_to": complete_to, "modes": modes,
    }  # fmt: skip
    path = folder / f"{name}.json"
    path.write_text(json.dumps(body))
    return path


def shell(folder, thickness):
    """A thin hollow sphere by its membrane and bending stiffness, the share of the radius; its c₀ is the sum of modes."""
    mass, frequencies, shapes, compliance = 4 * math.pi * R**3 * thickness * DENSITY, [], [], 0.0
    for n in range(2, round(30 / thickness)):
        membrane = (n - 1) * (n + 2) / (n * n + n + 1 - POISSON)
        bending = thickness**2 / 12 / (1 - POISSON**2) * (n - 1) * n * (n + 1) * (n + 2)
        omega = math.sqrt(YOUNG / DENSITY * (membrane + bending)) / R
        compliance += (2 * n + 1) / (mass * omega**2)
        if n <= 4 / math.sqrt(thickness):
            frequencies.append(omega / (2 * math.pi)), shapes.append(math.sqrt(2 * n + 1))
    return written(folder, f"shell {thickness}", mass, frequencies, shapes, compliance, 1.01 * frequencies[-1])


def made(folder, which):
    if which.startswith("shell"):
        return shell(folder, float(which.split()[1]))
    mass = 4 / 3 * math.pi * R**3 * DENSITY
    soft = 1 / (mass * (2 * math.pi * 10.0) ** 2)
    frequencies, compliance = {
        "1 mode": ([66e3], 0.0), "2 modes": ([66e3, 90e3], 1e-10), "5 modes": ([50e3, 66e3, 80e3, 90e3, 110e3], 1e-10),
        "10 Hz": ([10.0], soft), "10 Hz and 66 kHz": ([10.0, 66e3], soft), "soft": ([66e3], 1e-6),
    }[which]  # fmt: skip
    return written(folder, which, mass, frequencies, [2.0] * len(frequencies), compliance, 125e3)


PARTNERS = ["wall", "half-space,material=glass", "sphere,material=glass,radius=0.01"]
WORDS = {
    "restitution": "--speed 0.01,1 --format json", "impact": "--speed 0.1 --format json", "predict": "--speed 0.1 --format json",
    "distribution": "--speed 0.1 --temperature 0.1 --samples 3 --format json",
    "bounce": "--speed 0.1 --count 3 --flight-time 1 --format json", "table": "--speed 0.01:0.1 --error 1e-2 --format json",
    "oblique": "--speed 0.1 --friction 0.1 --angle 20 --format json",
}  # fmt: skip
BODIES = ["1 mode", "shell 0.01"]
BODIES += [pytest.param(which, marks=pytest.mark.long) for which in ("5 modes", "10 Hz", "2 modes", "10 Hz and 66 kHz", "soft", "shell 0.003")]


@pytest.mark.parametrize("which", BODIES)
def test_every_subcommand_has_a_value_or_says_why_not(stoss, tmp_path, which):
    path = made(tmp_path, which)
    for against in PARTNERS:
        for command, words in WORDS.items():
            result = stoss.run(command, f"--body '@{path}' --against {against} {words}")
            assert result.returncode in (0, 1, 3), (command, against, result.stderr)
            of_others = () if command == "impact" else ("fewer nodes", "smaller step", "larger step")
            for wrong in (*of_others, "tolerance of 0 or", "nan"):
                assert wrong not in result.stderr, (command, against, result.stderr)
            if result.returncode == 3 or not result.stdout:
                assert result.stderr.count("\n") == 1, (command, against, result.stderr)
                continue
            for row in json.loads(result.stdout).get("records", []):
                value = row.get("restitution", 0.0)
                assert isinstance(value, float) or row.get("reason"), (command, against, row)


@pytest.mark.parametrize("command", ["restitution", "table"])
@pytest.mark.parametrize("thickness", [0.01, pytest.param(0.003, marks=pytest.mark.long)])
def test_thin_hollow_bodies_have_values_on_a_half_space(stoss, tmp_path, command, thickness):
    """All gave up, as a half-space was made for contacts of Hertz's duration: a hollow ball stays five times as long."""
    words = WORDS[command].replace("0.01,1", "0.1 --tolerance 0.4")
    result = stoss.run(command, f"--body '@{shell(tmp_path, thickness)}' --against half-space,material=glass {words}")
    assert "echo" not in result.stderr and "more waves" not in result.stderr, result.stderr
    assert result.returncode in (0, 1) and result.stdout
    for row in json.loads(result.stdout).get("records", []):
        assert 0.5 < row.get("restitution", 0.9) < 1.0


def test_a_warm_ball_vibrates_as_high_as_what_it_meets_is_known(stoss, tmp_path):
    """By default it vibrated higher, and each sample was refused: "got mode (0, 1) of the second body"."""
    ball = "sphere,material=glass,radius=0.1"
    result = stoss.run(f"distribution --body '@{made(tmp_path, '5 modes')}' --against {ball}", WORDS["distribution"], "--error 0.1")
    assert result.returncode in (0, 1) and "got mode" not in result.stderr, result.stderr
    assert all(isinstance(row["restitution"], float) for row in json.loads(result.stdout)["records"])
