"""Computes the items, draws their figures and writes the report.

    python -m gerl_zippelius_1999 [--quick] [--output DIR] [ITEM ...]

    DIR/report.html               the report, with all figures inside
    DIR/figures/<item>.png|svg    the figures
    DIR/data/<item>/<table>.csv   what is in them

Finished items are kept, and computed again only when what makes them changes (`store`). Each item
runs in a process of its own, two at a time: an impact uses only one core, so this halves the time,
and an item that fails or crashes does not end the others. Two runs give the same report byte by
byte.
"""

from __future__ import annotations

import argparse
import fcntl
import importlib
import multiprocessing
import os
import re
import signal
import sys
import threading
import time
import traceback
from multiprocessing.connection import Connection, wait
from multiprocessing.context import ForkServerProcess
from pathlib import Path
from typing import cast

import matplotlib
import stoss
from matplotlib.figure import Figure

from gerl_zippelius_1999 import report, store
from gerl_zippelius_1999.common import PRINT
from gerl_zippelius_1999.report import Outcome

# In the order in which the paper comes to them.
ITEMS = (
    "figure_01", "figure_02", "figure_03", "figure_04", "figure_05", "mode_statistics", "figure_06", "table_1",
    "figure_07", "figure_08", "figure_09", "figure_10", "figure_11", "figure_12",
)  # fmt: skip

FAILED, USAGE, INPUT_OUTPUT, INTERRUPTED = 1, 2, 4, 130
PROCESSES = 2

# What matplotlib would else fill with a date and with random names.
REPEATABLE = {"svg.hashsalt": "stoss", "svg.fonttype": "path"}


def main(arguments: list[str] | None = None) -> int:
    """Runs the study; returns the exit code.

    0; 1 if an item failed; 2 for usage; 4 if nothing can be written; 130 when interrupted.
    """
    parser = argparse.ArgumentParser(
        prog="gerl_zippelius_1999", description="Reproduces Gerl and Zippelius, Phys. Rev. E 59, 2361 (1999).",
        epilog="The report shows all items whose results are there; ITEMs limit what is computed.",
    )  # fmt: skip
    parser.add_argument("items", nargs="*", metavar="ITEM", help="such as figure_05, 5, table_1 (default: all)")
    parser.add_argument("--quick", action="store_true", help="coarser, in half the time")
    parser.add_argument("--output", metavar="DIR", type=Path, help="default: out/paper, with --quick out/paper-quick")
    options = parser.parse_args(arguments)
    there = [item for item in ITEMS if (store.PACKAGE / f"{item}.py").is_file()]
    wanted = [_full_name(name) for name in options.items] or there
    for given, name in zip(options.items, wanted):
        if name not in there:
            parser.error(f"ITEM: got {given}, allowed {', '.join(there)}")
    folder = options.output or Path("out") / ("paper-quick" if options.quick else "paper")
    try:
        for part in ("figures", "data"):
            (folder / part).mkdir(parents=True, exist_ok=True)
        with open(folder / ".lock", "w") as lock:  # goes with the process, however it ends
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                print(f"output: another run writes to {folder} (wait for it, or use another --output)", file=sys.stderr)
                return INPUT_OUTPUT
            store.sweep(folder)
            return _run(there, wanted, options.quick, folder)
    except OSError as error:
        print(f"output: {error}", file=sys.stderr)
        return INPUT_OUTPUT
    except KeyboardInterrupt:
        print("interrupted; finished items are kept", file=sys.stderr)
        return INTERRUPTED


def _full_name(name: str) -> str:
    """'5', 'figure_5' and 'figure_05' are the same."""
    number = re.fullmatch(r"(?:figure_)?(\d{1,2})", name)
    return f"figure_{int(number[1]):02}" if number else name


def _run(there: list[str], wanted: list[str], quick: bool, folder: Path) -> int:
    shown = [item for item in there if item in wanted or _kept(item, quick, folder) is not None]
    start = time.monotonic()
    outcomes = _work(shown, quick, folder)
    page = report.html([(item, outcomes[item]) for item in shown], quick, folder)
    store.write(folder / "report.html", page.encode())
    failed = [item for item in shown if outcomes[item].failure]
    print(f"{folder / 'report.html'} ({time.monotonic() - start:.0f} s)", file=sys.stderr)
    if failed:
        print(f"failed: {', '.join(failed)}", file=sys.stderr)
    return FAILED if failed else 0


def _kept(item: str, quick: bool, folder: Path) -> object:
    return store.load(folder / "data" / item, store.item_key(item, quick))


def _work(items: list[str], quick: bool, folder: Path) -> dict[str, Outcome]:
    """All items, two at a time, each in a process of its own; a line for each on stderr."""
    # Forks of a server that has only imported start at once, and break no thread.
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([__name__, "matplotlib.backends.backend_agg", "matplotlib.backends.backend_svg"])
    waiting, outcomes = list(items), dict[str, Outcome]()
    running: dict[Connection, tuple[str, ForkServerProcess, float]] = {}
    try:
        while waiting or running:
            while waiting and len(running) < PROCESSES:
                item = waiting.pop(0)
                ours, theirs = context.Pipe(duplex=False)
                process = context.Process(target=_child, args=(theirs, item, quick, folder), name=item)
                process.start()
                theirs.close()
                running[ours] = (item, process, time.monotonic())
            for ready in wait(list(running)):
                end = cast(Connection, ready)
                item, process, start = running.pop(end)
                try:
                    done = cast(Outcome, end.recv())
                except EOFError:
                    process.join()
                    done = failure(item, f"its process ended with code {process.exitcode}")
                process.join()
                end.close()
                outcomes[item] = done
                state = f"failed: {done.failure}" if done.failure else "computed" if done.computed else "kept"
                took = f"{time.monotonic() - start:6.1f} s"
                print(f"[{len(outcomes)}/{len(items)}] {item:15} {took}  {state}", file=sys.stderr, flush=True)
    finally:
        for _, process, _ in running.values():
            process.terminate()
        for _, process, _ in running.values():
            process.join()
    return outcomes


def _child(end: Connection, item: str, quick: bool, folder: Path) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent has it too, and ends this process
    threading.Thread(target=_follow_parent, daemon=True).start()
    end.send(one(item, quick, folder))


def _follow_parent() -> None:
    """An orphan ends: nobody waits for it, and the next run may already write here."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def one(item: str, quick: bool, folder: Path) -> Outcome:
    """Computes the item or takes what is kept, and draws it. The outcome tells what went wrong."""
    module = None
    try:
        matplotlib.use("Agg")
        module = importlib.import_module(f"gerl_zippelius_1999.{item}")
        place, key = folder / "data" / item, store.item_key(item, quick)
        tables = store.load(place, key)
        computed = tables is None
        if tables is None:
            head = f"# stoss {stoss.__version__}: {module.TITLE}\n# study: gerl_zippelius_1999{', quick' * quick}\n"
            store.save(place, key, module.compute(quick), head)
            tables = store.load(place, key)  # so that a first run and a later one see the same
            if tables is None:
                raise ValueError("its tables are not what was written")
        with matplotlib.rc_context(PRINT | REPEATABLE):
            figure = module.draw(tables)
            save_figure(figure, folder / "figures", item)
        return Outcome(
            module.TITLE, module.CAPTION, getattr(module, "ALT", module.CAPTION.split(". ")[0] + "."),
            list(module.numbers(tables)), module.meaning(tables), float(figure.get_size_inches()[0]),
            list(tables), computed, "",
        )  # fmt: skip
    except Exception as error:
        traceback.print_exc()
        return failure(item, f"{type(error).__name__}: {error}".splitlines()[0], module)


def failure(item: str, why: str, module: object = None) -> Outcome:
    title = getattr(module, "TITLE", item.replace("_", " ").capitalize())
    return Outcome(title, getattr(module, "CAPTION", ""), "", [], "", 0.0, [], True, why)


def save_figure(figure: Figure, folder: Path, name: str) -> None:
    """As PNG and SVG, the same bytes each time."""
    for kind, metadata in (("png", {"Software": None}), ("svg", {"Date": None, "Creator": None})):
        path = folder / f".part-{name}.{kind}"
        figure.savefig(path, dpi=200, metadata=metadata)
        os.replace(path, folder / f"{name}.{kind}")
