"""Writes what `make bench` has measured as one line of JSON into bench/history.jsonl, which keeps it over commits.

history.py RESULTS.json [HISTORY]

RESULTS.json is what Google Benchmark writes. A line has the commit, its date, the version if the commit has its tag, the
machine, and of each benchmark the median in ms and its ratio, the time of the paper's protocol over that of the
benchmark, which hardly depends on the machine. A second run of a commit takes the place of the first.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HISTORY = ROOT / "bench/history.jsonl"
REFERENCE = "the paper's protocol"
IN_MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}


def git(*words):
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True)
    return done.stdout.strip() if done.returncode == 0 else ""


def medians(results):
    """Of each benchmark the median in ms: processor time, or wall time where the benchmark says so in its name."""
    found = {}
    for row in results["benchmarks"]:
        alone = row["run_type"] == "iteration" and row.get("repetitions", 1) == 1
        if row.get("error_occurred") or not (alone or row.get("aggregate_name") == "median"):
            continue
        name, _, clock = row["run_name"].partition("/")
        time = row["real_time" if clock in ("real_time", "manual_time") else "cpu_time"]
        found[name] = time * IN_MILLISECONDS[row["time_unit"]]
    return found


def line(results, commit, machine):
    """The line of a run: `commit` has its id, date and release, `machine` a processor and the number of cores."""
    times = medians(results)
    reference = times.get(REFERENCE)
    rows = {name: {"ms": float(f"{ms:.4g}")} for name, ms in times.items()}
    for name, row in rows.items():
        if reference:
            row["ratio"] = float(f"{reference / times[name]:.4g}")
    return {**commit, "machine": machine, "benchmarks": rows}


def this_commit():
    # The history itself is no source of what was measured.
    changed = git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!bench/history.jsonl")
    tag = git("describe", "--tags", "--exact-match", "--match", "v[0-9]*")
    return {
        "commit": git("rev-parse", "HEAD") + (", changed" if changed else ""),
        "date": git("show", "--no-patch", "--format=%cI", "HEAD"),
        "release": tag.removeprefix("v") if tag and not changed else None,
    }


def this_machine():
    lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    models = [text.partition(": ")[2] for text in lines if text.startswith("model name")]
    return f"{models[0] if models else 'unknown processor'}, {max(len(models), 1)} cores"


def read(history):
    return [json.loads(text) for text in history.read_text(encoding="utf-8").splitlines()] if history.exists() else []


def main(results, history=HISTORY):
    made = line(json.loads(Path(results).read_text(encoding="utf-8")), this_commit(), this_machine())
    if not made["benchmarks"]:
        sys.exit(f"history: {results}: got no benchmark, allowed at least one")
    lines = [each for each in read(Path(history)) if each["commit"] != made["commit"]] + [made]
    Path(history).write_text("".join(json.dumps(each, ensure_ascii=False) + "\n" for each in lines), encoding="utf-8")
    print(f"history: {len(made['benchmarks'])} benchmarks of {made['commit'][:9]} are in {history}")


if __name__ == "__main__":
    main(*sys.argv[1:])
