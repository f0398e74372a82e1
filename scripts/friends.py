"""Runs the groups of tests that need other people's programs (tests/friends/groups.toml), if their inputs have changed
since they last passed: tests/friends/passed.toml says of which inputs that was, and is written by a run that passes.

    friends.py [--all] [--jobs N] [GROUP ...]    in the top folder, whose build/release is configured with tests
"""

import argparse
import datetime
import hashlib
import json
import re
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
GROUPS = tomllib.loads((ROOT / "tests/friends/groups.toml").read_text(encoding="utf-8"))
PASSED = ROOT / "tests/friends/passed.toml"
TREE = ROOT / "build/release"


def git(*words, text=""):
    done = subprocess.run(["git", *words], cwd=ROOT, input=text, capture_output=True, text=True, check=True)
    return done.stdout


def digest(lines):
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def inputs(group, commit=None):
    """A hash of the names and contents of a group's inputs, as they are in this folder or were in a commit."""
    paths = GROUPS[group]["inputs"]
    if commit is not None:
        listed = git("ls-tree", "-r", commit, "--", *paths).splitlines()
        return digest(sorted(f"{name} {line.split()[2]}" for line, name in (each.split("\t") for each in listed)))
    listed = git("ls-files", "-co", "--exclude-standard", "--", *paths).splitlines()
    names = sorted(name for name in set(listed) if (ROOT / name).is_file())
    hashes = git("hash-object", "--stdin-paths", text="".join(f"{name}\n" for name in names)).split()
    return digest(sorted(f"{name} {each}" for name, each in zip(names, hashes, strict=True)))


def passed():
    """What has passed, by group."""
    return tomllib.loads(PASSED.read_text(encoding="utf-8")) if PASSED.exists() else {}


def seal(group, record):
    """A digest over a record, so that no part of it is changed alone."""
    tests = [f"{name} {seconds}" for name, seconds in sorted(record["tests"].items())]
    return digest([group, record["inputs"], record["date"].isoformat(), *tests])


def write(records):
    lines = ["# Written by scripts/friends.py when a group of tests has passed: of which inputs, and which tests took how many",
             "# seconds. tests/friends/test_passed.py refuses what no run has written."]  # fmt: skip
    for group, record in sorted(records.items()):
        lines += ["", f"[{group}]", f'inputs = "{record["inputs"]}"', f"date = {record['date'].isoformat()}"]
        lines += [f'seal = "{seal(group, record)}"', f"[{group}.tests]"]
        lines += [f'"{name}" = {seconds}' for name, seconds in sorted(record["tests"].items())]
    PASSED.write_text("\n".join(lines) + "\n", encoding="utf-8")


def tests(group):
    """The names of its tests in CTest."""
    return [name for name in known() if name == f"friends.{group}" or name.startswith(f"friends.{group}.")]


def known():
    """The names of all tests in CTest."""
    words = ["ctest", "--test-dir", TREE, "--show-only=json-v1"]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    return [test["name"] for test in json.loads(done.stdout)["tests"]]


def run(group, jobs):
    """The record of a run that has passed, None for one that has not."""
    before, names, results = inputs(group), tests(group), TREE / f"{group}.xml"
    pattern = "^(" + "|".join(map(re.escape, names)) + ")$"
    words = ["ctest", "--preset", "friends", "-R", pattern, "-j", str(jobs), "--output-junit", results]
    if subprocess.run(words, cwd=ROOT).returncode != 0:
        return None
    cases = {case.get("name"): case for case in ElementTree.parse(results).iter("testcase")}
    for name in names:
        output = cases[name].findtext("system-out") or ""
        if cases[name].get("status") != "run" or re.search(r"skipped", output, re.IGNORECASE):
            print(f"friends: {group}: not recorded as passed, as {name} has skipped some\n{output}", file=sys.stderr)
            return None
    now = datetime.datetime.now(datetime.timezone.utc).replace(microsecond=0)
    seconds = {name: round(float(cases[name].get("time")), 2) for name in names}
    return {"inputs": before, "date": now, "tests": seconds}


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--all", action="store_true", help="also those whose inputs are as they were")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("groups", nargs="*", metavar="GROUP", help=f"some of them: {', '.join(GROUPS)}")
    given = parser.parse_args()
    if unknown := set(given.groups) - set(GROUPS):
        parser.error(f"GROUP: got {', '.join(sorted(unknown))}, allowed {', '.join(GROUPS)}")
    records, due = passed(), []
    for group in given.groups or GROUPS:
        same = records.get(group, {}).get("inputs") == inputs(group)
        if same and not given.all:
            print(f"friends: {group}: passed on {records[group]['date']:%Y-%m-%d}, and its inputs are as they were then")
        else:
            due.append(group)
    if not due:
        return 0
    print(f"friends: to run: {', '.join(due)}", flush=True)
    subprocess.run(["scripts/install-dependencies.sh", "python", "test", *due], cwd=ROOT, check=True)
    # The programs may have come just now.
    subprocess.run(["cmake", "--preset", "release"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "--preset", "release", "-j", str(given.jobs)], cwd=ROOT, check=True)
    failed = []
    for group in due:
        record = run(group, given.jobs)
        if record is None:
            failed.append(group)
        else:
            records[group] = record
            write(records)
    if failed:
        print(f"friends: failed: {', '.join(failed)}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
