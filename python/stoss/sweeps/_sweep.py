"""Sweeps: many cases, on as many machines as there are."""

from __future__ import annotations

import contextlib
import os
import warnings
from typing import TYPE_CHECKING, Any, Callable, Iterator, Mapping

import numpy as np

from stoss._arguments import boolean, instance, integer, refusal
from stoss._errors import Interrupted, InvalidInput, StossWarning
from stoss.results._progress import bar
from stoss.sweeps import _store
from stoss.sweeps._computation import material_warnings
from stoss.sweeps._grid import Grid
from stoss.sweeps._tasks import Task, compute, flush, missing, parts_of, tasks_of
from stoss.sweeps._values import Sweep, values_of

if TYPE_CHECKING:
    import concurrent.futures


def sweep(
    grid: Grid | Mapping[str, Any] | str | os.PathLike[str],
    executor: concurrent.futures.Executor | int | None = None,
    *,
    store: str | os.PathLike[str],
    progress: bool = False,
) -> Sweep:
    """Compute all values of a grid that the store does not have yet.

    A task is one body with what it meets, at some hundred speeds, angles or samples, for which its
    modes are computed once. Each worker appends each value to its own file in the store when it is
    done: nothing that was finished is lost, whoever is killed, and the same call again computes the
    rest, with any executor. Results do not depend on the executor. A store of another grid, body or
    version is refused.

    Parameters:
        grid (Grid, mapping or path): What to compute; a mapping of the arguments of `Grid`, or the
            name of a TOML file.
        executor (None, int or concurrent.futures.Executor, optional): None: this process, on all
            cores. A number: so many processes of this machine. Else whatever computes the tasks: an
            `mpi4py.futures.MPIPoolExecutor`, the executor of a Dask client, …; its workers must see
            the store under the same name.
        store (path): Directory, made where it is not there yet.
        progress (bool, optional): Show on stderr a bar of the values; with an executor it moves with each task.

    Examples:
        >>> import tempfile
        >>> grid = stoss.Grid(bodies={"kind": "sphere", "poisson": [0.1, 0.3]}, speed=[0.01, 0.1])
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     result = stoss.sweep(grid, store=folder)
        >>> result.restitution[:, 0].round(4)
        array([[0.9991, 0.9904],
               [0.9986, 0.9913]])
        >>> warm = stoss.Grid(bodies=stoss.Sphere(poisson=0.3), speed=0.01, temperature=[0.01, 0.1], samples=50)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     ensembles = stoss.sweep(warm, 2, store=folder)
        >>> ensembles.summary()["mean"].shape
        (1, 1, 1, 2)
    """
    chosen, shows = as_grid(grid), boolean("progress", progress)
    path = _store.create(store, chosen).resolve()
    pieces = list(missing(chosen, path, parts_of(chosen)))
    try:
        with bar(sum(len(each.points) for each in pieces), shows, "sweep") as seen:
            tick = _nothing if seen is None else seen.update
            if executor is None:
                for task in tasks_of(chosen, path, pieces, most=1):
                    compute(task, threads=0, tick=tick)
            else:
                with _opened(executor) as pool:
                    _distribute(pool, tasks_of(chosen, path, pieces), tick)
    except KeyboardInterrupt:
        result = values_of(chosen, path)
        done = f"{np.count_nonzero(result.computed)} of {result.computed.size}"
        raise Interrupted(f"sweep: interrupted after {done} values (they are in the store)", result) from None
    finally:
        flush(path)
    result = values_of(chosen, path)
    if not result.complete:
        raise InvalidInput.out_of_range("store", f"'{path}', which not all workers see", "a directory that they share")
    doubtful = result.computed.size - np.count_nonzero(result.converged)
    if doubtful:
        text = f"{doubtful} of {result.computed.size} values not as accurate as asked for (see .converged)"
        warnings.warn(text, StossWarning, stacklevel=2)
    for said in material_warnings(chosen.cases(), float(chosen.speed.max())):
        warnings.warn(said, StossWarning, stacklevel=2)
    return result


def as_grid(given: Any) -> Grid:
    """A grid, of whatever makes one."""
    if isinstance(given, (str, os.PathLike)):
        return Grid.from_toml(given)
    return Grid.from_dict(given) if isinstance(given, Mapping) else instance("grid", given, (Grid,))  # type: ignore


@contextlib.contextmanager
def _opened(given: Any) -> Iterator[Any]:
    """The executor; of a number one that ends with the sweep."""
    if hasattr(given, "submit"):
        yield given
        return
    count = integer("executor", given)
    if not 1 <= count <= 1024:
        raise refusal("executor", given, "None, 1 to 1024 processes, or an executor")
    from concurrent.futures import ProcessPoolExecutor  # slow to import

    with ProcessPoolExecutor(count) as pool:
        yield pool


def _nothing(done: int = 1) -> None:
    """Where no bar is shown."""


def _distribute(pool: Any, tasks: list[Task], tick: Callable[[int], object]) -> None:
    """Each task on one core; the first failure ends the sweep."""
    futures = [pool.submit(compute, task) for task in tasks]
    try:
        for future in futures:
            tick(future.result())
    except BaseException:
        for future in futures:
            future.cancel()
        raise
