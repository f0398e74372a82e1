"""What the tests of the studies share. They need an installed stoss and matplotlib."""

import csv

import pytest

from study_runs import ROOT, run, states


@pytest.fixture(scope="session")
def study(tmp_path_factory):
    """The quick study, as a function that reads a table: a list of rows, numbers where they are numbers."""
    folder = tmp_path_factory.mktemp("paper") / "out"
    process = run("--quick", "--output", folder)
    assert process.returncode == 0, process.stderr

    def number(text):
        try:
            return float(text)
        except ValueError:
            return text

    def read(item, table):
        with open(folder / "data" / item / f"{table}.csv", encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
        assert rows
        return [{key: number(text) for key, text in row.items()} for row in rows]

    read.folder, read.states = folder, states(process)
    return read


@pytest.fixture(scope="session")
def hard_wall():
    """Converged 1 − ε² by (ν, v), with its uncertainty, from tests/data."""
    with open(ROOT / "tests/data/restitution_hard_wall.csv", encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    return {
        (float(row["poisson"]), float(row["speed"])): (float(row["lost_fraction"]), float(row["uncertainty"]))
        for row in rows
    }
