"""What the command will refuse it refuses before it computes, in one line, however expensive the job is."""

import os
from pathlib import Path

import pytest
from judged import REFUSAL, run

PROGRAM = str(Path(os.environ["STOSS"]).resolve())
BALL = "--body sphere --poisson 0.3"
GLASS = "--body sphere --material glass --radius 0.005 --against half-space,material=glass"
JOBS = {
    "table": f"table {BALL} --speed 1e-6:0.3 --error 1e-6",
    "rule": f"table {BALL} --against same --oblique --speed 1e-5:1e-3 --tolerance 1e-3",
    "pairs": f"table {BALL} --against same --ratio 1:3 --speed 1e-4:0.3 --error 1e-5",
    "real": f"table {GLASS} --predict --speed 1e-4:10 --error 1e-4",
    "predict": f"predict {GLASS} --speed log:1e-4:10:40 --tolerance 1e-9",
    "distribution": f"distribution {BALL} --speed 1e-3 --temperature 0.01 --highest 100 --samples 1e5 --error 1e-6",
    "impact": f"impact {BALL} --speed 1e-3 --against half-space,young=1e-3,density=1e3",
    "curve": f"restitution {BALL} --speed log:1e-5:0.1:100 --tolerance 1e-6 --against half-space",
    "oblique": f"oblique {BALL} --speed log:1e-4:0.1:100 --tangential 0.01 --friction 0.1 --tolerance 1e-4",
    "modes": f"modes {BALL} --cutoff 1000",
    "bounce": f"bounce {BALL} --speed 1e-5 --flight-time 30 --count 1e5 --cutoff 100",
}
TABLES = ("table", "rule", "pairs", "real")
WRONG = [(job, wrong) for job in JOBS for wrong in ("-o /nowhere/x", "-o .", "-o fifo", "--against strip,thickness=1")
         if (job, wrong) != ("modes", "--against strip,thickness=1")]
# Where root may write, by its modes, but nothing can be: a folder that the kernel makes up.
WRONG += [(job, "-o /proc/x") for job in JOBS] + [("impact", "--trajectory /proc/x"), ("impact", "--trajectory link/x")]
WRONG += [(job, "-o link/x") for job in JOBS]
WRONG += [(job, f"--error={value}") for job in (*TABLES, "distribution") for value in ("0", "2", "nan")]
WRONG += [(job, f"--tolerance={value}") for job in ("rule", "predict") for value in ("0", "2", "nan")]
WRONG += [(job, "--name=a-b") for job in TABLES] + [("rule", "--format netcdf -o /nowhere/x.nc")]
WRONG += [("bounce", "--cutoff=nan"), ("distribution", "--samples=0"), ("predict", "--uncertainty x=1")]


@pytest.mark.parametrize("job, wrong", WRONG)
def test_is_refused_before_anything_is_computed(job, wrong, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    os.mkfifo("fifo")
    os.symlink("/sys", "link")
    words = JOBS[job].split()
    name = wrong.replace("=", " ").split()[0]
    if name in words:  # in its place
        del words[words.index(name):words.index(name) + 2]
    code, used, interrupted, _, text = run([PROGRAM, *words, *wrong.split()])
    assert interrupted is None and code in (2, 3, 4), text
    assert len(text.splitlines()) == 1 and text.startswith("stoss: error: "), text
    assert used < REFUSAL
