"""What the first use of stoss takes: the command from its start to its end, and the import of the package.

Run:     build/venv/bin/python bench/first_use.py [--times N]
Prints:  a table: processor time and wall time, medians of N processes, in ms.

Values, to the default tolerance, include the modes and all set-up. The command is that of the build; STOSS=... for
another one.
"""

import argparse
import os
import statistics
import sys
import time
from pathlib import Path

STOSS = os.environ.get("STOSS", str(Path(__file__).resolve().parent.parent / "build/release/cli/stoss"))
RESTITUTION = (STOSS, "restitution", "--speed", "0.1", "--poisson")
TASKS = {
    "a program that does nothing": ("/bin/true",),
    "stoss --help": (STOSS, "--help"),
    "disk, v = 0.1": (*RESTITUTION, "0.33"),
    "sphere, v = 0.1": (*RESTITUTION, "0.3", "--body", "sphere"),
    "sphere on a half-space, v = 0.1": (*RESTITUTION, "0.3", "--body", "sphere", "--against", "half-space"),
    "python": (sys.executable, "-c", ""),
    "python, import numpy": (sys.executable, "-c", "import numpy"),
    "python, import stoss": (sys.executable, "-c", "import stoss"),
    "python, its first value": (sys.executable, "-c", "import stoss; stoss.restitution(stoss.Disk(poisson=0.33), speed=0.1)"),
}


def measured(words: tuple[str, ...]) -> tuple[float, float]:
    """Processor and wall time of a process, in ms."""
    begin = time.perf_counter()
    actions = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
    _, status, used = os.wait4(os.posix_spawn(words[0], words, os.environ, file_actions=actions), 0)
    wall = time.perf_counter() - begin
    if status != 0:
        raise SystemExit(f"failed: {' '.join(words)}")
    return 1e3 * (used.ru_utime + used.ru_stime), 1e3 * wall


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--times", type=int, default=21)
    times = parser.parse_args().times
    rounds = [{name: measured(words) for name, words in TASKS.items()} for _ in range(times)]  # by turns
    print("| first use | processor time, ms | wall time, ms |\n|---|---:|---:|")
    for name in TASKS:
        spent, wall = (statistics.median(of[name][i] for of in rounds) for i in (0, 1))
        print(f"| {name} | {spent:.1f} | {wall:.1f} |")


if __name__ == "__main__":
    main()
