"""Two processes do nearly twice as much as one, by processor time, which other load does not change."""

import subprocess
import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).parents[3] / "bench/sweep_scaling.py"


def efficiencies(interpreter, *words):
    """What bench/sweep_scaling.py prints, by executor and number of processes."""
    command = [sys.executable, str(BENCH), *words]
    done = subprocess.run(command, env=interpreter.environment, capture_output=True, text=True, timeout=3000)
    assert done.returncode == 0, done.stderr
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in done.stdout.splitlines() if line[:1] == "|"]
    assert rows[0][:2] == ["executor", "processes"] and rows[0][5] == "efficiency"
    return {(row[0], int(row[1])): float(row[5]) for row in rows[2:]}


def test_the_bench_prints_a_row_for_each(interpreter):
    found = efficiencies(interpreter, "--cases", "2", "--processes", "2", "--only", "apart,local")
    assert list(found) == [("apart", 1), ("apart", 2), ("local", 1), ("local", 2)]
    assert found["apart", 1] == found["local", 1] == 1.0


@pytest.mark.long
@pytest.mark.parametrize("executor, module", [("local", "stoss"), ("mpi", "mpi4py")])
def test_two_processes_cost_a_tenth_at_most(interpreter, executor, module):
    """Not of Dask, whose processes spend processor time by the clock: other load changes it."""
    pytest.importorskip(module)
    found = efficiencies(interpreter, "--cases", "60", "--processes", "2", "--only", f"apart,{executor}")
    assert found[executor, 2] >= 0.9 * min(1.0, found["apart", 2])
