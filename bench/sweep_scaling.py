"""How stoss.sweep scales: cases per second of one process and of as many as there are cores, by each executor.

Run:     build/venv/bin/python bench/sweep_scaling.py [--processes N] [--cases N] [--only local,mpi,dask]
Prints:  the table of docs/sweeps.md.

Each row is two sweeps into new stores, by a process of their own: one of so many spheres on a wall, one of three times
as many, which takes longer by what the additional cases cost. The time for which processes start and import is not in
it; it is in a column of its own. Rows of one and of several processes are measured by turns.

`elapsed` is 1 where N processes do N times as many cases in a second as one. It means nothing where others use the
machine. `efficiency` is the same by processor time, in which there is no other load: t₁/(t_N + (N − 1) h), with the
processor times t of a case, of all processes together, and h of the process that hands out, reads and collects, for
which the others are taken to wait. It does not see the wait for a disk.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

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


def measured(executor: str, processes: int, cases: int, folder: Path) -> tuple[float, float, float]:
    """Of a sweep: seconds, processor seconds of all processes, and of the one that hands out."""
    words = [sys.executable, str(folder / "script.py")]
    if executor == "mpi":  # one more hands out
        words = ["mpiexec", "-n", str(processes + 1), sys.executable, "-m", "mpi4py.futures", str(folder / "script.py")]
    allowed = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe")
    single = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")
    with tempfile.TemporaryDirectory(dir=folder) as store:
        before = os.times()
        done = subprocess.run([*words, executor, str(processes), str(cases), store], cwd=folder, check=True, text=True,
                              env={**os.environ, **dict.fromkeys((*allowed, *single), "1")}, stdout=subprocess.PIPE)  # fmt: skip
        after = os.times()
    own = next(line for line in done.stdout.splitlines() if line.startswith("TIMES")).split()
    spent = after.children_user + after.children_system - before.children_user - before.children_system
    return float(own[1]), spent, float(own[2])


def slope(executor: str, processes: int, cases: int, folder: Path) -> tuple[float, float, float, float]:
    """Seconds, processor seconds and those of the one that hands out, of a case; processor seconds to begin with."""
    few, many = (measured(executor, processes, number, folder) for number in (cases, 3 * cases))
    elapsed, spent, handing = ((b - a) / (2 * cases) for a, b in zip(few, many))
    return elapsed, spent, handing, few[1] - cases * spent


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--processes", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--only", default="local,mpi,dask")
    given = parser.parse_args()
    folder, begin = Path(tempfile.mkdtemp(prefix="sweep-scaling-")), time.monotonic()
    (folder / "script.py").write_text(SCRIPT, encoding="utf-8")
    try:
        print(f"{2 * given.cases} cases of 10 speeds; load of the machine before: {os.getloadavg()[0]:.1f}\n")
        print("| executor | processes | cases/s | cases/processor s | elapsed | efficiency | to begin, s |")
        print("|---|---|---|---|---|---|---|")
        for executor in given.only.split(","):
            one = slope(executor, 1, given.cases, folder)
            several = slope(executor, given.processes, given.cases, folder)
            for count, (elapsed, spent, handing, start) in ((1, one), (given.processes, several)):
                efficiency = one[1] / (spent + (count - 1) * handing)
                row = [executor, str(count), f"{1 / elapsed:.3g}", f"{1 / spent:.3g}", f"{one[0] / elapsed / count:.2f}",
                       f"{efficiency:.2f}", f"{start:.1f}"]  # fmt: skip
                print(f"| {' | '.join(row)} |", flush=True)
    finally:
        shutil.rmtree(folder)
    print(f"\nafter {time.monotonic() - begin:.0f} s; load of the machine: {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
