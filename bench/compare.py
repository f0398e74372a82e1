"""Compares the last line of bench/history.jsonl with that of the last release before it.

compare.py [--threshold FACTOR] [--against COMMIT] [HISTORY]

What has become slower by more than the threshold (1.3: the same program varies by up to 1.2 on a shared machine) is
listed and ends it with exit code 1. Ratios to the paper's protocol are compared, which was timed in the same run; a
benchmark without one by its time, on the same machine only. Exit code 2: there is nothing to compare with.
"""

import argparse
import sys
from pathlib import Path

from history import HISTORY, REFERENCE, read


def factors(old, new):
    """By how much each benchmark of both lines has become slower."""
    same_machine = old["machine"] == new["machine"]
    found = {}
    for name, row in new["benchmarks"].items():
        before = old["benchmarks"].get(name)
        if before is None or name == REFERENCE:
            continue
        if "ratio" in row and "ratio" in before:
            found[name] = before["ratio"] / row["ratio"]
        elif same_machine:
            found[name] = row["ms"] / before["ms"]
    return found


def base(lines, against=None):
    """The line to compare the last one with: that of a commit, or of the last release before it."""
    for each in reversed(lines[:-1]):
        if each["commit"].startswith(against) if against else each["release"]:
            return each
    return None


def main(arguments):
    parser = argparse.ArgumentParser(prog="compare", description=__doc__.partition("\n")[0])
    parser.add_argument("history", nargs="?", default=HISTORY, type=Path, metavar="HISTORY")
    parser.add_argument("--threshold", type=float, default=1.3, metavar="FACTOR")
    parser.add_argument("--against", metavar="COMMIT")
    given = parser.parse_args(arguments)
    lines = read(given.history)
    old = base(lines, given.against)
    if old is None:
        wanted = f"a line of {given.against}" if given.against else "a line of a release (make bench at its tag)"
        print(f"compare: {given.history}: got {len(lines)} lines, allowed {wanted} and a later one", file=sys.stderr)
        return 2
    new = lines[-1]
    found = factors(old, new)
    slower = {name: factor for name, factor in found.items() if factor > given.threshold}
    gone = [name for name in old["benchmarks"] if name not in new["benchmarks"]]
    print(f"{new['commit'][:9]} against {old['release'] or old['commit'][:9]}, {len(found)} benchmarks: new time / old")
    for name, factor in sorted(found.items(), key=lambda each: -each[1]):
        print(f"  {factor:6.2f}  {name}{'  <- slower' if name in slower else ''}")
    for name in gone:
        print(f"    gone  {name}")
    print(f"{len(slower)} slower by more than {given.threshold:g}")
    return 1 if slower or not found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
