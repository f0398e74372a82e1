"""The manual explains every key of the records."""

import json
import re
from pathlib import Path

import pytest

MANUAL = Path(__file__).resolve().parents[2] / "cli/stoss.1.in"
SUMMARY = {f"{name}_{kind}_error" for name in ("restitution", "lost_fraction") for kind in ("statistical", "numerical")}
QUANTITIES = {"energy_error", "momentum_error", *SUMMARY}
EVERYWHERE = {"poisson", "speed"}  # explained as options


def keys(value):
    """All keys of nested records, without what _si and _error add."""
    if isinstance(value, list):
        return {key for each in value for key in keys(each)}
    if not isinstance(value, dict):
        return set()
    here = {key if key in QUANTITIES else re.sub(r"(_si)?(_error)?$", "", key) for key in value}
    return here | keys(list(value.values()))


@pytest.mark.parametrize(
    "arguments",
    [
        "restitution --poisson 0.33 --speed 0.1",
        "restitution --poisson 0.33 --speed 0.1 --method extrapolate",
        "impact --poisson 0.33 --speed 0.1 --cutoff 12",
        "bounce --poisson 0.33 --speed 0.1 --count 2 --flight-time 9 --cutoff 12",
        "distribution --poisson 0.33 --speed 0.1 --temperature 0.1 --samples 1",
        "quasistatic --poisson 0.33 --speed 1e-3",
        "quasistatic --poisson 0.33 --compression 0.01",
        "quasistatic --body sphere --poisson 0.3 --young 1e9 --density 1e3 --radius 1 --yield 1e6 --speed 0.1",
        "quasistatic --body sphere --poisson 0.3 --compression 0.01",
        "modes --poisson 0.33 --cutoff 3",
        "table --poisson 0.33 --speed 0.1:0.2",
        "modes --body sphere --poisson 0.3 --cutoff 3",
        "impact --body sphere --poisson 0.3 --young 1e9 --density 1e3 --radius 1 --yield 1e6 --speed 1 --cutoff 12",
    ],
)
def test_every_key_is_explained(stoss, arguments):
    document = json.loads(stoss.run(arguments, "--format json").stdout)
    words = set(re.findall(r"[a-z]+(?:_[a-z]+)*", MANUAL.read_text(encoding="utf-8").replace("\\f", " ")))
    found = keys([document["records"], document.get("modes", []), document.get("summary", {})])
    assert found and found - EVERYWHERE <= words
