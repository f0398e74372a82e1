"""The command writes the files that it was told to, and no other: not for a moment, nowhere."""

import os
import re
import shlex
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
from written import Watched  # noqa: E402

NU = "--body disk --poisson 0.33 --speed 0.1"
STEEL = "--body sphere --material 'structural steel' --radius 0.005"
JOBS = [
    "modes --body disk --poisson 0.33 --cutoff 3", f"impact {NU} --cutoff 12.5",
    f"bounce {NU} --cutoff 4 --flight-time 30 --count 2", f"restitution {NU} --tolerance 0.1",
    f"distribution {NU} --spectrum 2,0,energy=0.1 --samples 2 --error 0.1",
    f"oblique {NU} --friction 0.3 --angle 30 --tolerance 0.1", "quasistatic --body disk --poisson 0.33 --speed 0.01",
    "quasistatic --body disk --poisson 0.33 --compression 0.01", f"predict {STEEL} --speed 1", "materials",
]  # fmt: skip
TABLES = [f"table --body disk --poisson 0.33 --speed 0.01:0.1 --error 0.1 --format {form}"
          for form in ("c", "rust", "js", "json", "two-column")]
WRITTEN = [f"{job} --format {form} -o out" for job in JOBS[:7] for form in ("table", "csv", "json")] + [
    *[f"{table} -o out" for table in TABLES], f"impact {NU} --cutoff 12.5 --trajectory out",
    f"restitution {NU} --tolerance 0.1 --resume out",
    f"distribution {NU} --spectrum 2,0,energy=0.1 --samples 2 --error 0.1 --resume out",
]  # fmt: skip
# A file that takes the place of another at the end, in the same folder.
BESIDE = re.compile(r"\.stoss-\w{6}")


@pytest.fixture
def watched(tmp_path):
    return Watched(tmp_path)


@pytest.mark.parametrize("job", [*JOBS, *TABLES, "schema", "--help", "--version", *(f"{job.split()[0]} --help" for job in JOBS)])
def test_nothing_is_written_without_a_name(watched, job):
    done, written = watched.run(os.environ["STOSS"], *shlex.split(job))
    assert (done.returncode, written) == (0, set()), done.stderr


@pytest.mark.parametrize("job", WRITTEN)
def test_only_what_is_named_is_written(watched, job):
    done, written = watched.run(os.environ["STOSS"], *shlex.split(job))
    assert done.returncode == 0, done.stderr
    assert {name for name in written if not BESIDE.fullmatch(name)} == {"out"}
    assert [path.name for path in watched.here.iterdir()] == ["out"]


@pytest.mark.parametrize("job", ["restitution --body disk --poisson 7 --speed 0.1 -o out", "restitution --poisson 0.33 --speed x --resume out",
                                 "table --body disk --poisson 0.33 --speed 0.1 -o out", "modes --poisson 0.33 -o out/of/nowhere"])  # fmt: skip


def test_a_refusal_writes_nothing(watched, job):
    done, written = watched.run(os.environ["STOSS"], *shlex.split(job))
    assert done.returncode in (2, 3, 4) and written == set()
