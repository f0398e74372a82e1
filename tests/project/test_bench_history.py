"""What `make bench` keeps of a commit, and how `make bench-compare` compares two of them."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import compare  # noqa: E402
import history  # noqa: E402

PROTOCOL = history.REFERENCE
HERE, THERE = "a processor, 2 cores", "another processor, 8 cores"


def row(name, time, **more):
    return {"run_name": name, "run_type": "aggregate", "aggregate_name": "median", "time_unit": "ms",
            "cpu_time": time, "real_time": 10 * time, **more}  # fmt: skip


RESULTS = {"benchmarks": [
    row(PROTOCOL, 15.0),
    row(PROTOCOL, 99.0, aggregate_name="mean"),
    row("modes", 1.5e6, time_unit="ns"),
    row("curve/real_time", 0.3),
    row("once", 3.0, run_type="iteration", aggregate_name=None, repetitions=1),
    row("broken", 0.0, error_occurred=True),
]}  # fmt: skip


def made(commit, times, release=None, machine=HERE):
    results = {"benchmarks": [row(name, time) for name, time in times.items()]}
    return history.line(results, {"commit": commit, "date": "2026-01-01", "release": release}, machine)


def stored(folder, *lines):
    file = folder / "history.jsonl"
    file.write_text("".join(json.dumps(each) + "\n" for each in lines), encoding="utf-8")
    return file


def run(file, *options):
    words = [sys.executable, ROOT / "bench/compare.py", *options, file]
    return subprocess.run(words, capture_output=True, text=True, timeout=60)


def test_a_line_has_medians_and_ratios():
    line = history.line(RESULTS, {"commit": "a"}, HERE)
    assert line["benchmarks"] == {
        PROTOCOL: {"ms": 15.0, "ratio": 1.0},
        "modes": {"ms": 1.5, "ratio": 10.0},
        "curve": {"ms": 3.0, "ratio": 5.0},  # wall time
        "once": {"ms": 3.0, "ratio": 5.0},
    }
    assert line["commit"] == "a" and line["machine"] == HERE


def test_a_commit_has_one_line(tmp_path):
    file, results = tmp_path / "history.jsonl", tmp_path / "results.json"
    file.write_text(json.dumps(made("older", {"modes": 1.0})) + "\n", encoding="utf-8")
    results.write_text(json.dumps(RESULTS), encoding="utf-8")
    for _ in range(2):
        history.main(results, file)
    lines = history.read(file)
    assert len(lines) == 2 and lines[0]["commit"] == "older"
    assert set(lines[1]) == {"commit", "date", "release", "machine", "benchmarks"}
    results.write_text('{"benchmarks": []}', encoding="utf-8")
    with pytest.raises(SystemExit, match="got no benchmark"):
        history.main(results, file)


OLD = {PROTOCOL: 15.0, "modes": 1.0, "impact": 2.0, "gone": 1.0}


def test_what_is_slower_than_the_threshold_ends_with_one(tmp_path):
    slow = made("b" * 40, {PROTOCOL: 15.0, "modes": 1.25, "impact": 2.8, "new": 1.0})
    file = stored(tmp_path, made("a" * 40, OLD, release="1.0.0"), made("c" * 40, {"modes": 9.0}), slow)
    done = run(file)
    assert done.returncode == 1 and "bbbbbbbbb against 1.0.0, 2 benchmarks" in done.stdout
    assert "  1.40  impact  <- slower\n" in done.stdout and "  1.25  modes\n" in done.stdout
    assert "gone  gone" in done.stdout and "1 slower by more than 1.3" in done.stdout
    assert run(file, "--threshold", "1.5").returncode == 0
    assert run(file, "--threshold", "1.2").stdout.count("<- slower") == 2
    # Of another commit: three times as fast as there.
    done = run(file, "--against", "ccc")
    assert done.returncode == 0 and "  0.14  modes" in done.stdout


def test_another_machine_is_compared_by_ratios():
    old, new = made("a", OLD), made("b", {name: 3 * time for name, time in OLD.items()}, machine=THERE)
    assert compare.factors(old, new) == pytest.approx({"modes": 1.0, "impact": 1.0, "gone": 1.0})
    # Without the reference only on the same machine.
    alone = made("a", {"modes": 1.0})
    assert compare.factors(alone, made("b", {"modes": 2.0})) == {"modes": 2.0}
    assert compare.factors(alone, made("b", {"modes": 2.0}, machine=THERE)) == {}


def test_without_a_release_there_is_nothing_to_compare_with(tmp_path):
    for lines in ([], [made("a", OLD, release="1.0.0")], [made("a", OLD), made("b", OLD)]):
        done = run(stored(tmp_path, *lines))
        assert done.returncode == 2 and done.stdout == "" and done.stderr.count("\n") == 1, done.stderr
    assert "allowed a line of abc" in run(stored(tmp_path, made("b", OLD)), "--against", "abc").stderr


def test_make_bench_keeps_a_line_and_another_target_compares():
    text = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert "--benchmark_out=build/bench.json --benchmark_out_format=json" in text
    assert "bench/history.py build/bench.json" in text and "bench/compare.py" in text
