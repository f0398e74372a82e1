"""The store of a sweep: what is damaged, foreign, torn or full."""

import shutil
import subprocess
import sys

import numpy as np
import pytest

import stoss
from stoss.sweeps._rows import Layout, with_checksum
from stoss.sweeps._tasks import Worker

GRID = {"bodies": {"kind": "sphere", "poisson": [0.1, 0.3]}, "speed": [0.01, 0.1], "tolerance": 1e-2}


def opened(store, name=None):
    """The file of a worker of such a sweep."""
    return Worker(store, Layout(stoss.Grid(**GRID).computation), name)


def another_digit(line, place):
    return f"{line[:place]}{'1' if line[place] != '1' else '2'}{line[place + 1 or len(line) :]}"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    store = tmp_path_factory.mktemp("sweep") / "store"
    return stoss.sweep(GRID, store=store), store


@pytest.fixture
def store(made, tmp_path):
    """A copy of the complete store, whose only file is a.csv."""
    copy = tmp_path / "store"
    shutil.copytree(made[1], copy)
    (file,) = copy.glob("*.csv")
    file.rename(copy / "a.csv")
    return copy


def test_torn_last_line_is_computed_again(made, store):
    file = store / "a.csv"
    content = file.read_bytes()
    last = content.rindex(b"\n", 0, len(content) - 1) + 1
    for length in (last, last + 1, last + 18, last + 40, len(content) - 1):
        file.write_bytes(content[:length])
        assert np.count_nonzero(~stoss.open_sweep(store).computed) == 1
        for name in (None, "a"):  # by another worker, and by the one that was killed
            with opened(store, name):
                pass
        again = stoss.sweep(GRID, store=store)
        assert again.rows.tobytes() == made[0].rows.tobytes()
        for worker in store.glob("worker*.csv"):
            worker.unlink()


def test_any_length_of_a_file_can_be_continued(store):
    """Cut anywhere, also within the header: its worker goes on, and nothing is damaged."""
    content = (store / "a.csv").read_bytes()
    for length in [*range(0, 500, 7), *range(500, len(content), 101)]:
        (store / "a.csv").write_bytes(content[:length])
        with opened(store, "a"):
            pass
        result = stoss.open_sweep(store)
        rows = [line for line in content[:length].split(b"\n")[:-1] if line[:1] != b"#"][1:]
        assert np.count_nonzero(result.computed) == len(rows)


@pytest.mark.parametrize(
    "damage",
    [
        lambda line: line.replace(",", ";", 1),
        lambda line: line[: len(line) // 2] + "\n",
        lambda line: line.replace("true", "maybe").replace("false", "maybe"),
        lambda line: "\0" * len(line.strip()) + "\n",
        lambda line: line.replace(line.split(",")[2], "0.1.2"),
        lambda line: "0123456789abcdef" + line[16:],
        lambda line: "\n",
        lambda line: line.rstrip("\n") + ",1\n",
        lambda line: line.rstrip("\n") + "\r\n",
        lambda line: another_digit(line, 4),
        lambda line: another_digit(line, -2),
        lambda line: another_digit(line, line.index(",") - 1),
        lambda line: line.replace(",true", ",false", 1),
        lambda line: "# case 12: {\n",
    ],
)
def test_damaged_line_is_named(store, damage):
    lines = (store / "a.csv").read_text().splitlines(keepends=True)
    lines[4] = damage(lines[4])
    (store / "a.csv").write_bytes("".join(lines).encode())
    with pytest.raises(stoss.InvalidInput, match=r"as line 5 of '.*a\.csv'") as error:
        stoss.sweep(GRID, store=store)
    assert "\n" not in str(error.value)


def test_foreign_file(store):
    (store / "b.csv").write_text("a,b\n1,2\n")
    with pytest.raises(stoss.InvalidInput, match="got 'a,b' as line 1"):
        stoss.open_sweep(store)


def test_other_version(made, store):
    file = store / "a.csv"
    file.write_text(file.read_text().replace(f"stoss {stoss.__version__}", "stoss 0.0.9"))
    for call in (lambda: stoss.sweep(GRID, store=store), lambda: stoss.open_sweep(store)):
        with pytest.raises(stoss.InvalidInput, match="of stoss 0.0.9, allowed"):
            call()
    with pytest.raises(stoss.InvalidInput, match="use another store"):
        opened(store, "a")
    mixed = stoss.open_sweep(store, mix=True)
    assert mixed.versions == ("0.0.9",) and mixed.rows.tobytes() == made[0].rows.tobytes()


def test_other_grid(made, store):
    with pytest.raises(stoss.InvalidInput, match="of another grid"):
        stoss.sweep({**GRID, "speed": [0.01, 0.1, 0.2]}, store=store)
    other = store.parent / "other"
    stoss.sweep({**GRID, "tolerance": 2e-2, "speed": 0.01}, store=other)
    for file in other.glob("*.csv"):
        shutil.copy(file, store / "b.csv")
    with pytest.raises(stoss.InvalidInput, match="inputs in '.*b.csv' that are not in its grid"):
        stoss.open_sweep(store)
    assert stoss.open_sweep(store, mix=True).rows.tobytes() == made[0].rows.tobytes()


def test_same_value_twice(store):
    lines = (store / "a.csv").read_text().splitlines(keepends=True)
    shutil.copy(store / "a.csv", store / "b.csv")
    assert stoss.open_sweep(store).complete
    names, cells = lines[1].rstrip().split(","), lines[3].split(",")[:-1]
    for name, changed, allowed in (
        ("restitution", lambda x: x - 0.1, False), ("restitution", lambda x: x * (1 + 1e-15), True),
        ("contact_time", lambda x: 1.5 * x, False), ("cutoff", lambda x: 2 * x, False), ("cutoff", lambda x: x * (1 + 1e-15), True),
    ):  # fmt: skip
        own = list(cells)
        own[names.index(name)] = repr(changed(float(own[names.index(name)])))
        assert own != cells
        (store / "b.csv").write_text("".join(lines[:3]) + with_checksum(",".join(own)) + "\n")
        if allowed:
            assert stoss.open_sweep(store).complete
            continue
        for call in (lambda: stoss.open_sweep(store), lambda: stoss.sweep(GRID, store=store)):
            with pytest.raises(stoss.InvalidInput, match="got another value of case"):
                call()
    own = list(cells)
    own[names.index("converged")] = "false"
    (store / "b.csv").write_text("".join(lines[:3]) + with_checksum(",".join(own)) + "\n")
    with pytest.raises(stoss.InvalidInput, match="got another value of case"):
        stoss.open_sweep(store)


@pytest.mark.parametrize("change", ["removed", "replaced", "truncated", "appended", "folder"])
def test_a_file_that_goes_under_its_worker(store, change):
    """No row is written where nobody finds it."""
    file = store / "a.csv"
    key, cells = file.read_text().splitlines()[2].split()[2].rstrip(":"), stoss.open_sweep(store).rows[0, 0, 0].item()
    with opened(store, "a") as worker:
        if change == "removed":
            file.unlink()
        elif change == "replaced":
            (store / "b").write_text("precious")
            (store / "b").rename(file)
        elif change == "truncated":
            file.write_text("")
        elif change == "appended":
            with open(file, "a") as stream:
                stream.write("precious")
        else:
            shutil.rmtree(store)
        with pytest.raises(OSError, match="another process has removed, replaced or changed it") as error:
            worker.append(key, {}, (0.01,), cells)
        assert error.value.filename == str(file)
        if change == "replaced":
            assert file.read_text() == "precious"


def test_rows_without_checksums_are_read_but_not_continued(made, store):
    """As stoss 1.0 has written them."""
    lines = (store / "a.csv").read_text().splitlines()
    old = [line if line.startswith("#") else line.rpartition(",")[0] for line in lines]
    (store / "a.csv").write_text("\n".join(old) + "\n")
    assert stoss.open_sweep(store).rows.tobytes() == made[0].rows.tobytes()
    with pytest.raises(stoss.InvalidInput, match="without checksums, allowed one with them"):
        opened(store, "a")
    (store / "a.csv").write_text("\n".join(old[:-1]) + "\n")
    assert stoss.sweep(GRID, store=store).rows.tobytes() == made[0].rows.tobytes()  # a worker of its own


@pytest.mark.parametrize("content", ["", "{", "[]", '{"speed": [0.01], "speed": [0.01, 0.1]}', '{"speed": 1}', '{"bodies": {"kind": "sphere"}, "speed": 0.1}'])
def test_damaged_grid(store, content):
    (store / "grid.json").write_text(content)
    with pytest.raises(stoss.InvalidInput):
        stoss.open_sweep(store)


def test_no_store(tmp_path):
    for path in (tmp_path, tmp_path / "none"):
        with pytest.raises(stoss.InvalidInput, match="allowed the directory of a sweep"):
            stoss.open_sweep(path)
    (tmp_path / "a.csv").write_text("")
    with pytest.raises(stoss.InvalidInput, match="no grid.json"):
        stoss.sweep(GRID, store=tmp_path)
    with pytest.raises(OSError):
        stoss.sweep(GRID, store=tmp_path / "a.csv")


def test_two_writers_of_one_file(store):
    with opened(store, "a"):
        with pytest.raises(BlockingIOError, match="another process is writing it"):
            opened(store, "a")
    with opened(store) as one, opened(store) as other:
        assert one.file != other.file
    with opened(store, "a"):
        pass


FULL = """
import resource, signal, sys, stoss
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (1400, resource.RLIM_INFINITY))
try:
    stoss.sweep({grid!r}, store={store!r})
except OSError as error:
    print(error)
    sys.exit(7)
"""


def test_full_disk_keeps_whole_rows(made, interpreter, tmp_path):
    """A limit of the size of a file, as a full disk: the row that does not fit is taken back."""
    done = interpreter.run(FULL.format(grid=GRID, store=str(tmp_path)))
    assert done.returncode == 7 and "worker" in done.stdout, done.stderr
    (file,) = tmp_path.glob("*.csv")
    content = file.read_bytes()
    assert content.endswith(b"\n") and 0 < len(content) <= 1400
    assert 0 < np.count_nonzero(stoss.open_sweep(tmp_path).computed) < 4
    assert stoss.sweep(GRID, store=tmp_path).rows.tobytes() == made[0].rows.tobytes()


def test_unwritable_directory(tmp_path, interpreter):
    """As a user who is not root; root is asked to write where nobody can."""
    with pytest.raises(OSError):
        stoss.sweep(GRID, store="/proc/stoss")
    command = [sys.executable, "-m", "stoss", "sweep", "--store=/proc/stoss", str(tmp_path / "grid.toml")]
    (tmp_path / "grid.toml").write_text('speed = 0.1\nbodies = {kind = "sphere", poisson = 0.3}\n')
    done = subprocess.run(command, env=interpreter.environment, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr.count("\n")) == (4, 1) and "/proc/stoss" in done.stderr
