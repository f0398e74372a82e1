"""How stoss.sweep scales: cases per second of one process, of as many as there are cores, and of twice as many.

Run:     build/venv/bin/python bench/sweep_scaling.py [--processes N,…] [--cases N] [--only apart,local,mpi,dask]
Prints:  a table of eight columns, five of which are in docs/developer/sweeps.md, from runs with other --cases.

Each row is two sweeps into new stores, by a process of their own: one of so many spheres on a wall (--cases, without
which they are 60 for each core), one of three times as many, which takes longer by what the additional cases cost. A
row so rests on twice --cases. The time for which processes start and import is not in it; it is in a column of its own.

`elapsed` is 1 where N processes do N times as many cases in a second as one. It means nothing where others use the
machine. `efficiency` is the same by processor time, in which there is no other load: t₁/(t_N + (N − 1) h), with the
processor times t of a case, of all processes together, and h of the process that hands out, reads and collects, for
which the others are taken to wait; N is the number of cores where there are more processes. It does not see the wait
for a disk. `alone` is h. `apart` are N processes that know nothing of each other: what the machine itself allows, whose
cores share caches and, where they are threads of one core, its units.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

SCRIPT = """
import contextlib, resource, sys, time
import stoss

def opened(executor, count):
    if executor == "mpi":
        from mpi4py.futures import MPIPoolExecutor
        return MPIPoolExecutor()
    if executor == "dask":
        from distributed import Client
        return Client(n_workers=count, threads_per_worker=1, dashboard_address=None)
    return contextlib.nullcontext(count)

if __name__ == "__main__":
    executor, count, cases, store = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
    bodies = {"kind": "sphere", "poisson": f"lin:0:0.45:{cases}"}
    grid = stoss.Grid(bodies=bodies, speed="log:1e-3:0.1:10")
    with opened(executor, count) as pool:
        begin, spent = time.monotonic(), time.process_time()
        stoss.sweep(grid, pool.get_executor() if executor == "dask" else pool, store=store)
        print("TIMES", time.monotonic() - begin, time.process_time() - spent)
"""


ALLOWED = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe")
SINGLE = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")
NAMES = ("executor", "processes", "cases/s", "cases/processor s", "elapsed", "efficiency", "alone, ms", "to begin, s")


def measured(executor: str, processes: int, cases: int, folder: Path) -> np.ndarray:
    """Of a sweep, or of several apart: seconds, processor seconds of all, and of the one that hands out."""
    words = [sys.executable, str(folder / "script.py")]
    if executor == "mpi":  # one more hands out
        words = ["mpiexec", "-n", str(processes + 1), sys.executable, "-m", "mpi4py.futures", str(folder / "script.py")]
    several, each = (processes, cases // processes) if executor == "apart" else (1, cases)
    environment = {**os.environ, **dict.fromkeys((*ALLOWED, *SINGLE), "1")}
    before, running = os.times(), []
    for _ in range(several):
        store = tempfile.mkdtemp(dir=folder)
        inputs = ["local", "1"] if executor == "apart" else [executor, str(processes)]
        running.append(subprocess.Popen([*words, *inputs, str(each), store], cwd=folder, env=environment, text=True,
                                        stdout=subprocess.PIPE))  # fmt: skip
    own = []
    for process in running:
        said = process.communicate()[0]
        if process.returncode:
            sys.exit(f"{executor}: ended with exit code {process.returncode}")
        own.append([float(word) for line in said.splitlines() if line.startswith("TIMES") for word in line.split()[1:]])
    after = os.times()
    spent = after.children_user + after.children_system - before.children_user - before.children_system
    elapsed, handing = np.max(own, axis=0)
    return np.array([elapsed, spent, 0.0 if executor == "apart" else handing])


def slope(executor: str, processes: int, cases: int, folder: Path) -> tuple[float, float, float, float]:
    """Seconds, processor seconds and those of the one that hands out, of a case; processor seconds to begin with."""
    few, many = (measured(executor, processes, number, folder) for number in (cases, 3 * cases))
    elapsed, spent, handing = (many - few) / (2 * cases)
    return elapsed, spent, handing, few[1] - cases * spent


def main() -> None:
    cores = len(os.sched_getaffinity(0))
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--processes", default=f"{cores},{2 * cores}")
    parser.add_argument("--cases", type=int, default=60 * cores)
    parser.add_argument("--only", default="apart,local,mpi,dask")
    given = parser.parse_args()
    counts = [int(each) for each in given.processes.split(",")]
    if any(count < 1 or given.cases % count for count in counts):
        sys.exit(f"cases: got {given.cases}, allowed a multiple of each number of processes, {given.processes}")
    folder, begin = Path(tempfile.mkdtemp(prefix="sweep-scaling-")), time.monotonic()
    (folder / "script.py").write_text(SCRIPT, encoding="utf-8")
    try:
        print(f"{2 * given.cases} cases of 10 speeds; load of the machine before: {os.getloadavg()[0]:.1f}\n")
        print(f"| {' | '.join(NAMES)} |\n|{'---|' * len(NAMES)}")
        for executor in given.only.split(","):
            one = slope(executor, 1, given.cases, folder)
            for count in (1, *counts):
                elapsed, spent, handing, start = one if count == 1 else slope(executor, count, given.cases, folder)
                used = min(count, cores)
                efficiency = one[1] / (spent + (used - 1) * handing)
                row = [1 / elapsed, 1 / spent, one[0] / elapsed / used, efficiency, 1e3 * handing, start]
                shown = [f"{value:{kind}}" for value, kind in zip(row, (".3g", ".3g", ".2f", ".2f", ".2f", ".1f"))]
                print(f"| {' | '.join([executor, str(count), *shown])} |", flush=True)
    finally:
        shutil.rmtree(folder)
    print(f"\nafter {time.monotonic() - begin:.0f} s; load of the machine: {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
