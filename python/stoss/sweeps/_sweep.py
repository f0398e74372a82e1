"""Sweeps: many cases, on as many machines as there are."""

from __future__ import annotations

import concurrent.futures
import contextlib
import os
import warnings
from pathlib import Path
from typing import Any, Iterator, Mapping, Sequence

import numpy as np

from stoss import _core
from stoss._arguments import instance, integer, refusal
from stoss._errors import Interrupted, InvalidInput, StossWarning
from stoss.bodies._bodies import speed_unit
from stoss.bodies._encounter import refinable
from stoss.bodies._state import choose_state
from stoss.sweeps import _store
from stoss.sweeps._grid import Case, Grid
from stoss.sweeps._store import Worker
from stoss.sweeps._values import Sweep, open_sweep


def sweep(
    grid: Grid | Mapping[str, Any] | str | os.PathLike[str],
    executor: concurrent.futures.Executor | int | None = None,
    *,
    store: str | os.PathLike[str],
) -> Sweep:
    """Compute the coefficient of restitution of all cases of a grid that the store does not have yet.

    A task is one body with what it meets, at all speeds, for which its modes are computed once.
    Each worker appends each value to its own file in the store when it is done: nothing that was
    finished is lost, whoever is killed, and the same call again computes the rest, with any
    executor. Results do not depend on the executor. A store of another grid or version is refused.

    Parameters:
        grid (Grid, mapping or path): What to compute; a mapping of the arguments of `Grid`, or the
            name of a TOML file.
        executor (None, int or concurrent.futures.Executor, optional): None: this process, on all
            cores. A number: so many processes of this machine. Else whatever computes the tasks: an
            `mpi4py.futures.MPIPoolExecutor`, the executor of a Dask client, …; its workers must see
            the store under the same name.
        store (path): Directory, made where it is not there yet.

    Examples:
        >>> import tempfile
        >>> grid = stoss.Grid(bodies={"kind": "sphere", "poisson": [0.1, 0.3]}, speed=[0.01, 0.1])
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     result = stoss.sweep(grid, store=folder)
        >>> result.restitution[:, 0].round(4)
        array([[0.9991, 0.9904],
               [0.9986, 0.9913]])
    """
    chosen = as_grid(grid)
    path = _store.create(store, chosen).resolve()
    jobs = list(missing(chosen, path, chosen.cases()))
    try:
        if executor is None:
            for job in jobs:
                compute(*job)
        else:
            with _opened(executor) as pool:
                _distribute(pool, jobs)
    except KeyboardInterrupt:
        result = open_sweep(path)
        done = f"{np.count_nonzero(result.computed)} of {result.computed.size}"
        raise Interrupted(f"sweep: interrupted after {done} values (they are in the store)", result) from None
    result = open_sweep(path)
    if not result.complete:
        raise InvalidInput(f"store: got '{path}', which not all workers see, allowed a directory that they share")
    doubtful = result.computed.size - np.count_nonzero(result.converged)
    if doubtful:
        text = f"{doubtful} of {result.computed.size} values not as accurate as asked for (see .converged)"
        warnings.warn(text, StossWarning, stacklevel=2)
    return result


def as_grid(given: Any) -> Grid:
    """A grid, of whatever makes one."""
    if isinstance(given, (str, os.PathLike)):
        return Grid.from_toml(given)
    return Grid.from_dict(given) if isinstance(given, Mapping) else instance("grid", given, (Grid,))  # type: ignore


Job = tuple[str, dict[str, Any], str, list[float], int]
"""Store, inputs and key of a case, speeds, threads: what `compute` takes, all of which can be pickled."""


def missing(grid: Grid, path: Path, cases: Sequence[Case], threads: int = 0) -> Iterator[Job]:
    """What is still to be computed of these cases."""
    there = _store.read(path, {case.key for case in grid.cases()})
    for case in cases:
        speeds = [speed for speed in grid.speed.tolist() if (case.key, speed) not in there]
        if speeds:
            yield str(path), case.inputs, case.key, speeds, threads


def compute(
    store: str, inputs: dict[str, Any], key: str, speeds: list[float], threads: int = 1, name: str | None = None
) -> int:
    """Compute one body with what it meets at some speeds and append the values to the file of this worker."""
    tolerance, absolute = inputs["tolerance"], inputs["absolute"]
    alone = Grid(bodies=inputs["body"], against=inputs["against"], speed=speeds, tolerance=tolerance, absolute=absolute)
    (case,) = alone.cases()
    if case.key != key:
        raise InvalidInput(f"grid: got case {case.key} of a worker, allowed {key} (all must have the same stoss)")
    rows = np.zeros(len(speeds), dtype=_core.restitution_row)
    own = np.array(speeds) / speed_unit(case.body)
    done = 0
    with Worker(Path(store), name) as worker:

        def keep() -> None:
            nonlocal done
            worker.append(key, inputs, speeds[done], rows[done].item())
            done += 1

        contact = refinable(case.body, case.against)
        try:
            _core.restitution_curve(contact, own, tolerance, absolute, threads, choose_state(None), rows, [], keep)
        finally:
            worker.flush()
    return done


@contextlib.contextmanager
def _opened(given: Any) -> Iterator[Any]:
    """The executor; of a number one that ends with the sweep."""
    if hasattr(given, "submit"):
        yield given
        return
    count = integer("executor", given)
    if not 1 <= count <= 1024:
        raise refusal("executor", given, "None, 1 to 1024 processes, or an executor")
    with concurrent.futures.ProcessPoolExecutor(count) as pool:
        yield pool


def _distribute(pool: Any, jobs: list[Job]) -> None:
    """One task for each case, on one core each; the first failure ends the sweep."""
    futures = [pool.submit(compute, *job[:4], 1) for job in jobs]
    try:
        for future in futures:
            future.result()
    except BaseException:
        for future in futures:
            future.cancel()
        raise
