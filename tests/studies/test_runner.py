"""What the runner of the study promises: the same bytes, nothing computed twice, failures told, whole files."""

import os
import shutil
import signal
import subprocess
import sys
import time

import pytest

from study_runs import STUDIES, environment, run, states

FRAMEWORK = ("__init__", "__main__", "common", "equations", "report", "runner", "store", "words")


@pytest.mark.long
def test_two_runs_elsewhere_give_the_same_bytes(tmp_path):
    folders = [tmp_path / name for name in ("one", "two")]
    for folder in folders:
        assert run("--quick", "--output", folder, "2", "figure_4", "figure_09").returncode == 0
    files = [sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file()) for folder in folders]
    assert files[0] == files[1] and len(files[0]) > 15
    for path in files[0]:
        assert (folders[0] / path).read_bytes() == (folders[1] / path).read_bytes(), path


ITEM = '''
import os
import time
import numpy as np
from matplotlib.figure import Figure
from gerl_zippelius_1999 import {helper}
TITLE, CAPTION = "Item {number}: a test", "A line. And more."
def compute(quick):
    with open(os.environ["COUNT"], "a") as stream:
        stream.write("{name} ")
    {extra}
    return {{"line": {{"x[R]": np.array([0.1, 1 / 3]), "n": np.array([1, 2]), "word": np.array(["a,b", 'c"\\n']),
                       "flag": np.array([True, False])}}}}
def draw(tables):
    figure = Figure()
    figure.subplots().plot(tables["line"]["x[R]"])
    return figure
def numbers(tables):
    table = tables["line"]
    assert table["x[R]"][1] == 1 / 3 and table["n"].dtype == np.int64 and list(table["flag"]) == [True, False]
    assert list(table["word"]) == ["a,b", 'c"\\n']
    return [("quantity <b>", "1", "–", "{{:.3f}}".format(table["x[R]"][1]))]
def meaning(tables):
    return "Meaning {{}}.".format({helper}.NONE)
'''


class Fake:
    """A study of three small items in a folder of its own."""

    def __init__(self, folder):
        self.studies, self.output, self.count = folder / "studies", folder / "out", folder / "count"
        self.package = self.studies / "gerl_zippelius_1999"
        self.package.mkdir(parents=True)
        for name in FRAMEWORK:
            shutil.copy(STUDIES / "gerl_zippelius_1999" / f"{name}.py", self.package)
        (self.package / "helper.py").write_text('NONE = "none"\n')
        for name in ("figure_02", "figure_03", "table_1"):
            self.item(name)

    def item(self, name, extra="pass"):
        helper = "helper" if name == "figure_02" else "common"
        text = ITEM.format(name=name, number=name[-1], extra=extra, helper=helper)
        (self.package / f"{name}.py").write_text(text, encoding="utf-8")

    def command(self, *arguments):
        return [sys.executable, "-m", "gerl_zippelius_1999", "--output", str(self.output), *arguments]

    def run(self, *arguments):
        command = self.command(*arguments)
        return subprocess.run(command, env=self.environment(), capture_output=True, text=True, timeout=60)

    def start(self):
        # A session of its own, so that a signal can go to the whole group, as Ctrl-C does.
        return subprocess.Popen(self.command(), env=self.environment(), stderr=subprocess.PIPE, start_new_session=True)

    def environment(self):
        return environment(self.studies) | {"COUNT": str(self.count)}

    def counted(self):
        """The items computed since the last call."""
        words = sorted(self.count.read_text().split()) if self.count.exists() else []
        self.count.unlink(missing_ok=True)
        return words

    def wait_for(self, words):
        end = time.monotonic() + 30.0
        while time.monotonic() < end:
            if self.count.exists() and len(self.count.read_text().split()) >= words:
                return
            time.sleep(0.05)
        raise TimeoutError


@pytest.fixture
def fake(tmp_path):
    return Fake(tmp_path)


ALL = ["figure_02", "figure_03", "table_1"]


def test_finished_items_are_kept_until_what_makes_them_changes(fake):
    assert fake.run().returncode == 0 and fake.counted() == ALL
    page = (fake.output / "report.html").read_bytes()
    assert b"Meaning none." in page and b"quantity &lt;b&gt;" in page

    again = fake.run()
    assert fake.counted() == [] and states(again) == dict.fromkeys(ALL, "kept")
    assert (fake.output / "report.html").read_bytes() == page

    # What only one item imports; a file cut short; a list that is missing.
    (fake.package / "helper.py").write_text('NONE = "other"\n')
    table = fake.output / "data" / "figure_03" / "line.csv"
    table.write_bytes(table.read_bytes()[:-5])
    assert fake.run().returncode == 0 and fake.counted() == ["figure_02", "figure_03"]
    (fake.output / "data" / "table_1" / "item.json").unlink()
    # One item is asked for, the others are shown if they are there.
    assert fake.run("3").returncode == 0 and fake.counted() == []
    text = (fake.output / "report.html").read_text(encoding="utf-8")
    assert "Meaning other." in text and "Item 3: a test" in text and "Item 1: a test" not in text
    assert fake.run("--quick").returncode == 0 and fake.counted() == ALL


def test_an_item_that_fails_or_crashes_does_not_end_the_others(fake):
    fake.item("figure_03", extra='raise RuntimeError("no <luck>")')
    fake.item("table_1", extra="os._exit(3)")
    process = fake.run()
    assert process.returncode == 1
    assert states(process) == {"figure_02": "computed", "figure_03": "failed", "table_1": "failed"}
    text = (fake.output / "report.html").read_text(encoding="utf-8")
    assert "RuntimeError: no &lt;luck&gt;" in text and "ended with code 3" in text and "Meaning none." in text
    fake.item("figure_03")
    fake.item("table_1")
    assert fake.run().returncode == 0
    assert fake.counted() == ["figure_02", "figure_03", "figure_03", "table_1", "table_1"]


@pytest.mark.parametrize("how", ["interrupt", "kill"])
def test_a_run_that_is_ended_leaves_what_is_finished(fake, how):
    fake.item("figure_03", extra="time.sleep(60)")
    process = fake.start()
    fake.wait_for(3)  # figure_02 is finished, table_1 has begun
    if how == "interrupt":
        os.killpg(process.pid, signal.SIGINT)
        assert process.wait(20) == 130
    else:
        process.kill()
        process.wait(20)
    process.stderr.close()
    fake.counted()
    fake.item("figure_03")
    end = time.monotonic() + 20.0
    while (result := fake.run()).returncode == 4 and time.monotonic() < end:  # until the orphans have noticed
        time.sleep(0.2)
    assert result.returncode == 0 and "figure_02" not in fake.counted()
    assert not list(fake.output.rglob(".part-*"))


def test_usage_and_output_are_checked(fake):
    wrong = fake.run("figure_99")
    assert wrong.returncode == 2 and "figure_02, figure_03, table_1" in wrong.stderr
    fake.output.write_text("in the way")
    blocked = fake.run()
    assert blocked.returncode == 4 and "Traceback" not in blocked.stderr
    assert fake.counted() == []
