"""A sweep of 10⁵ cases on a cluster: what it would cost, and the sweep, which may be killed and continued.

Estimate: python3 cases.py grid.toml --estimate 50        (on one core, some seconds)
Run:      mpirun -n 33 python3 -m mpi4py.futures cases.py grid.toml STORE        (or: sbatch cases.sbatch)
Expect:   of the estimate, the processor time of so many cases that were measured, and the core hours of the whole grid,
          which are extrapolated; of the run, what there is in the store, and STORE.nc with all values.

One of the processes hands out the tasks; the others compute, each on one core. Values are in the store as soon as they
are done: after the wall-time limit the same job continues. The cases of the estimate are drawn at random; it errs by
the spread of their costs, which is said with it, and by what other processors do faster or slower, which is not.
"""

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

import stoss

CORES = 32


def estimate(path: Path, count: int) -> None:
    """What the grid would cost, from so many of its cases."""
    grid = stoss.Grid.from_toml(path)
    cases, given, spent, read = grid.cases(), grid.to_dict(), [], []
    for k in np.random.default_rng(1).choice(len(cases), min(count, len(cases)), replace=False):
        with tempfile.TemporaryDirectory() as store:
            times = [time.process_time()]
            stoss.sweep({**given, "bodies": cases[k].body, "against": cases[k].against}, store=store)
            times.append(time.process_time())
            stoss.open_sweep(store)
            times.append(time.process_time())
        spent.append(times[1] - times[0])
        read.append(times[2] - times[1])
    mean = np.mean(spent)
    error = np.std(spent, ddof=1) / np.sqrt(len(spent)) if len(spent) > 1 else np.inf
    core, error_of_core, alone = len(cases) / 3600 * np.array([mean, error, np.mean(read)])
    print(f"measured: {len(spent)} cases, {stoss.with_error(mean, error)} s of a core each, all speeds together")
    print(f"extrapolated, not measured: {len(cases)} cases, {stoss.with_error(core, error_of_core)} core hours;")
    print(f"on {CORES} cores like this one {core / CORES + alone:.2g} hours, of which one core checks the grid and")
    print(f"reads the values for {60 * alone:.2g} minutes at most while the others wait")


def run(path: Path, store: Path) -> None:
    """The sweep, by all processes but one of mpirun."""
    from mpi4py.futures import MPIPoolExecutor

    begin = time.monotonic()
    with MPIPoolExecutor() as pool:
        result = stoss.sweep(path, pool, store=store)
    print(result)
    result.to_netcdf(f"{store}.nc")
    print(f"written: {store}.nc, after {time.monotonic() - begin:.0f} s")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("grid", type=Path)
    parser.add_argument("store", type=Path, nargs="?", default=Path("values"))
    parser.add_argument("--estimate", type=int, metavar="CASES", help="only compute so many, and say what all would cost")
    given = parser.parse_args()
    if given.estimate is None:
        run(given.grid, given.store)
    else:
        estimate(given.grid, given.estimate)


if __name__ == "__main__":
    main()
