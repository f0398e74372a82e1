"""What stoss restitution --resume refuses: other inputs, other files, places that cannot be used."""

import os

import pytest
from conftest import SMALL, resume

INTERRUPTED = "# interrupted: the rows above are complete, later ones are missing\n"


@pytest.mark.parametrize(
    "job, name, got, allowed",
    [
        (SMALL.replace("0.33", "0.34"), "poisson", "0.34,-0.2", "0.33,-0.2"),
        (SMALL.replace("0.1,0.2", "0.1,0.2,0.3"), "speed", "0.1,0.2,0.3", "0.1,0.2"),
        (SMALL + " --tolerance 1e-2", "tolerance", "0.01", "0.001"),
        (SMALL + " --method extrapolate", "kind of result", "extrapolation", "restitution"),
        (
            "restitution --poisson 0.33 --young 1e9 --density 1e3 --radius 1 --speed 100",
            "poisson",
            "0.33",
            "0.33,-0.2",
        ),
    ],
)
@pytest.mark.parametrize("part", [1, 0.9])
def test_other_inputs_are_refused(stoss, tmp_path, small, job, name, got, allowed, part):
    path = tmp_path / "curve.csv"
    text = small[: int(part * len(small))]
    path.write_text(text)
    result = resume(stoss, path, job)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got {got}, allowed {allowed} as in '{path}'")
    assert path.read_text() == text


def changed(text, old, new):
    assert old in text
    return text.replace(old, new, 1)


@pytest.mark.parametrize(
    "change, told",
    [
        (lambda text: "precious\n", "precious"),
        (lambda text: "precious", "precious"),
        (lambda text: "\0\1\2\377" * 100 + "\n", "\\x00\\x01\\x02\\xff"),
        (lambda text: '{\n  "schema": "stoss/restitution/2"\n', "{"),
        (lambda text: changed(text, ": restitution\n", ": modes\n"), "allowed modes"),
        (lambda text: changed(text, "# stoss 0.", "# stoss 9."), "version of stoss"),
        (lambda text: changed(text, "# tolerance: 0.001\n", ""), "tolerance: got 0.001, allowed none"),
        (lambda text: changed(text, "# against", "# colour: red\n# against"), "colour: got none, allowed red"),
        (lambda text: changed(text, "# against: ", "# against, "), "# against, wall"),
        (lambda text: changed(text, "max_force[piRE]", "max_force[N]"), "poisson,speed"),
        (lambda text: changed(text, "\n0.33,0.1,", "\n0.33,0.10000001,"), "row 1 of the file, allowed 0.33,0.1"),
        (lambda text: changed(text, "\n-0.2,0.1,", "\n-0.25,0.1,"), "row 3 of the file"),
        (lambda text: changed(text, ",true,false\n", ",true\n"), "as line 11"),
        (lambda text: changed(text, ",true,false\n", ",true,maybe\n"), "as line 11"),
        (lambda text: changed(text, ",true,false\n", ",true,false\n" + INTERRUPTED), "as line 12"),
        (lambda text: changed(text, ",true,false\n", ",true,false\n\n"), "as line 12"),
        (lambda text: text + text.splitlines(True)[-1], "got a row 5"),
    ],
)
def test_damaged_or_foreign_file_is_refused_and_left_alone(stoss, tmp_path, small, change, told):
    path = tmp_path / "curve.csv"
    text = change(small).encode("latin-1")
    path.write_bytes(text)
    result = resume(stoss, path)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: ") and told in line and "allowed" in line
    assert path.read_bytes() == text


def test_unusable_paths(stoss, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    for path in (tmp_path, tmp_path / "no/such/folder/x.csv", tmp_path / "loop", "/dev/full", "/dev/null"):
        result = resume(stoss, path)
        assert (result.returncode, result.stdout) == (4, ""), path
        (line,) = result.stderr.splitlines()
        assert "cannot" in line and str(path) in line


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read and write everything")
@pytest.mark.parametrize("mode", [0o200, 0o400])
def test_unreadable_or_unwritable_file(stoss, tmp_path, small, mode):
    path = tmp_path / "curve.csv"
    path.write_text(small[:-3])
    path.chmod(mode)
    result = resume(stoss, path)
    assert result.returncode == 4
    assert "Permission denied" in result.stderr
    path.chmod(0o600)
    assert path.read_text() == small[:-3]


@pytest.mark.parametrize(
    "more, told",
    [
        ("--format json", "got --format json, allowed csv"),
        ("--format table", "got --format table, allowed csv"),
        ("-o other.csv", "got another file as --output"),
        ("-o -", "got another file as --output"),
    ],
)
def test_other_output_is_refused(stoss, tmp_path, more, told):
    result = resume(stoss, tmp_path / "x.csv", f"{SMALL} {more}")
    assert (result.returncode, result.stdout) == (3, "")
    assert result.stderr.startswith(f"stoss: error: resume: {told}")
    assert not (tmp_path / "x.csv").exists()


def test_stdout_cannot_be_resumed(stoss):
    result = resume(stoss, "-")
    assert result.returncode == 3
    assert "allowed the name of a file" in result.stderr


@pytest.mark.parametrize("part", [1, 0.9, 0.1])
def test_line_ends_of_another_system_are_named(stoss, tmp_path, small, part):
    path = tmp_path / "curve.csv"
    text = small[: int(part * len(small))].replace("\n", "\r\n").encode()
    path.write_bytes(text)
    result = resume(stoss, path)
    assert result.returncode == 3
    (line,) = result.stderr.splitlines()
    assert "got line ends CRLF" in line and str(path) in line and "allowed LF" in line
    assert path.read_bytes() == text


def test_bad_input_leaves_the_file_alone(stoss, tmp_path, small):
    path = tmp_path / "curve.csv"
    path.write_text(small[:-3])
    for bad in ("--tolerance 0", "--threads -1"):
        assert resume(stoss, path, f"{SMALL} {bad}").returncode == 3
        assert path.read_text() == small[:-3]
