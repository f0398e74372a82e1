"""scripts/run_examples.py runs a program again if what it reads has changed."""

import run_examples


def test_runs_again_after_a_change(monkeypatch, tmp_path):
    files = tmp_path / "examples/any_body"
    files.mkdir(parents=True)
    (files / "body.json").write_text("1")
    program = tmp_path / "examples/adds.py"
    program.write_text("open('runs', 'a').write('x')")
    monkeypatch.setattr(run_examples, "EXAMPLES", program.parent)
    monkeypatch.setattr(run_examples, "KEPT", tmp_path / "kept")

    def runs():
        return len((run_examples.run("adds") / "runs").read_text())

    assert [runs(), runs()] == [1, 1]
    (files / "body.json").write_text("2")
    assert [runs(), runs()] == [2, 2]
    (files / "other.json").write_text("2")
    assert runs() == 3
    program.write_text(program.read_text() + "\n")
    assert [runs(), runs()] == [4, 4]
