"""What the tests of the studies share. They need an installed stoss and matplotlib."""

import csv

import pytest

from study_runs import run, states


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
