"""Whatever is in a file, reading it gives what it holds or InvalidInput in one line: no other exception, no crash, no
hang, no more memory than a file of its size may ask for."""

import contextlib
import io
import json
import os
import resource
import time
import zipfile

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import stoss

# Always the same examples.
# All of them in make test-long.
EXAMPLES = int(os.environ.get("STOSS_EXAMPLES", "100"))
FUZZ = settings(derandomize=True, database=None, deadline=None, max_examples=EXAMPLES,
                suppress_health_check=list(HealthCheck))  # fmt: skip
ROOM = 1 << 30  # bytes beyond what the process has

BALL = {
    "format": "stoss modal body 1", "name": "ball", "mass": 0.5, "curvature": [10.0, 8.0], "young": 1e11,
    "poisson": 0.3, "density": 8000.0, "compliance": -2e-12, "complete_to": 30000.0,
    "tangent": {"direction": [1.0, 0.0, 0.0], "compliance": -1e-12, "inertia": 0.1, "arm": 0.2},
    "modes": {"frequency": [20000.0, 30000.0], "displacement": [0.1, 0.2], "tangential_displacement": [0.1, 0.0]},
}  # fmt: skip
GRID = """tolerance = 1e-2
speed = "log:1e-2:0.1:2"
[[bodies]]
kind = "sphere"
poisson = [0.2, 0.3]
[[against]]
kind = "plate"
layers = [{thickness = 0.5, young = 1, density = 1, poisson = 0.3}, {young = 2, density = 1, poisson = 0.2}]
[[against]]
kind = "wall"
"""


@contextlib.contextmanager
def little_room():
    """Allocations beyond ROOM fail."""
    with open("/proc/self/statm", encoding="ascii") as stream:
        used = int(stream.read().split()[0]) * resource.getpagesize()
    before = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + ROOM, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


def refuses_or_reads(read, *arguments):
    begin = time.process_time()
    with little_room():
        try:
            read(*arguments)
        except stoss.InvalidInput as refusal:
            line = str(refusal)
            assert line and line.isprintable() and len(line) < 2000
    assert time.process_time() - begin < 5


# Text that a parser may take for something, and bytes that none should take.
WORDS = [b"[", b"]", b"{", b"}", b'"', b",", b"\n", b"\r\n", b"#", b"=", b"-", b"e9", b"1e400", b"nan", b"inf", b"null",
         b"true", b"9" * 30, b"9" * 5000, b"[" * 3000, b"{\"a\":" * 3000, b"\0", b"\xff", b"\xc3", b"\xe2\x80\xa8", b"\xed\xa0\x80",
         b"0.3", b"1e300", b"lin:0:1:1000000", b"log:1e-9:1:999", b"PK\x03\x04", b"kind", b"structural steel", b"modal"]  # fmt: skip
words = st.one_of(st.sampled_from(WORDS), st.binary(max_size=8))


@st.composite
def damaged(draw, whole):
    """The bytes of a whole file, some of which are replaced, left out, repeated or followed by others."""
    content = whole
    for _ in range(draw(st.integers(1, 4))):
        begin = draw(st.integers(0, len(content)))
        end = draw(st.integers(begin, min(len(content), begin + 40)))
        new = draw(st.one_of(words, st.just(content[begin:end] * 2), st.just(b"")))
        content = content[:begin] + new + content[end:]
    return content[: draw(st.integers(0, len(content)))] if draw(st.integers(0, 9)) == 0 else content


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("damaged")


@given(damaged(GRID.encode()))
@FUZZ
def test_grid(folder, content):
    (folder / "grid.toml").write_bytes(content)
    refuses_or_reads(stoss.Grid.from_toml, folder / "grid.toml")


@pytest.mark.parametrize("key", ["9" * 5000, '"\\u0000"', '"\\u2028 = 1"', '"' + "x" * 5000 + '"', '""'],
                         ids=["long", "control", "separator", "word", "empty"])  # fmt: skip
@pytest.mark.parametrize("value", ["'sphere'", "1", "[]", "{}"])
@pytest.mark.parametrize("before", ["", '[[bodies]]\nkind = "sphere"\n', '[[against]]\nkind = "wall"\n'])
def test_grid_with_strange_keys(folder, key, value, before):
    (folder / "grid.toml").write_text(f"{before}{key} = {value}\n", encoding="utf-8")
    refuses_or_reads(stoss.Grid.from_toml, folder / "grid.toml")


@given(damaged(json.dumps(BALL).encode()))
@FUZZ
def test_body_as_json(folder, content):
    (folder / "body.json").write_bytes(content)
    refuses_or_reads(stoss.ModalBody.read, folder / "body.json")


def packed(document):
    """As `save` writes it, but not compressed, so that what is replaced is something that is read."""
    flat = {name: value for name, value in document.items() if not isinstance(value, dict)}
    for name in ("tangent", "modes"):
        flat |= {f"{name}_{inner}": value for inner, value in document[name].items()}
    stream = io.BytesIO()
    np.savez(stream, **{name: np.asarray(value) for name, value in flat.items()})
    return stream.getvalue()


@given(damaged(packed(BALL)))
@FUZZ
def test_body_as_npz(folder, content):
    (folder / "body.npz").write_bytes(content)
    refuses_or_reads(stoss.ModalBody.read, folder / "body.npz")


@st.composite
def archive(draw):
    """A whole archive of files that NumPy may find strange."""
    shapes = st.sampled_from(["()", "(2,)", "(10**11,)", "(100000000000,)", "(2, 3)", "(-1,)", "(0,)", "(1,)*99", "[2]"])
    types = st.sampled_from(["<f8", ">f8", "<f4", "|O", "<U4", "<U900000000", "<c16", "|b1", "<M8[s]", "|V8", "[('a', '<f8')]", "x"])
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as file:
        for name in draw(st.lists(st.sampled_from([*BALL, "modes_frequency", "modes_displacement", "a/b", "mass.npy"]), unique=True)):
            header = f"{{'descr': '{draw(types)}', 'fortran_order': False, 'shape': {draw(shapes)}, }}"
            header += " " * (63 - (len(header) + 10) % 64) + "\n"
            start = b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header.encode()
            file.writestr(f"{name}.npy", start + draw(st.sampled_from([bytes(16), b"", b"\x7f" * 80, bytes(1 << 16)])))
    return stream.getvalue()


@given(archive())
@FUZZ
def test_body_as_other_npz(folder, content):
    (folder / "other.npz").write_bytes(content)
    refuses_or_reads(stoss.ModalBody.read, folder / "other.npz")


def test_body_that_unpacks_to_gigabytes(folder):
    with zipfile.ZipFile(folder / "bomb.npz", "w", zipfile.ZIP_DEFLATED) as file, file.open("mass.npy", "w") as member:
        header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (500000000,), }"
        header += b" " * (63 - (len(header) + 10) % 64) + b"\n"
        member.write(b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header)
        for _ in range(200):
            member.write(bytes(1 << 20))
    assert (folder / "bomb.npz").stat().st_size < 1 << 20
    with little_room(), pytest.raises(stoss.InvalidInput, match="64 MiB"):
        stoss.ModalBody.read(folder / "bomb.npz")


@pytest.fixture(scope="module")
def store(folder):
    grid = {"bodies": {"kind": "rod"}, "speed": [0.01, 0.1], "tolerance": 0.1, "absolute": 0.1}
    stoss.sweep(grid, store=folder / "store")
    (rows,) = (folder / "store").glob("*.csv")
    return folder / "store" / "grid.json", rows


def test_store(store):
    """Its grid, and its rows."""
    for path in store:
        whole = path.read_bytes()

        @given(damaged(whole), st.booleans())
        @FUZZ
        def opened(path, content, mix):
            path.write_bytes(content)
            refuses_or_reads(lambda: stoss.open_sweep(path.parent, mix=mix))

        opened(path)
        path.write_bytes(whole)
        assert stoss.open_sweep(path.parent).complete


def with_cell(text, column, new):
    """A CSV whose last row has something else in a column."""
    *head, last = text.splitlines()
    names = next(line for line in head if not line.startswith("#")).split(",")
    cells = last.split(",")
    cells[names.index(column)] = new
    return "\n".join([*head, ",".join(cells), ""])


def test_store_of_strange_rows(store):
    rows = store[1]
    whole = rows.read_text()
    try:
        for damage in (with_cell(whole, "runs", "9" * 40), with_cell(whole, "runs", "9" * 5000),
                       whole.replace("# stoss ", "# stoss \0"), whole.replace("# stoss 2", "# stoss " + "9" * 5000)):  # fmt: skip
            assert damage != whole
            rows.write_text(damage)
            refuses_or_reads(stoss.open_sweep, rows.parent)
            refuses_or_reads(lambda: stoss.open_sweep(rows.parent, mix=True))
    finally:
        rows.write_text(whole)


def test_csv(folder):
    stoss.restitution(poisson=0.33, speed=[0.05, 0.1], tolerance=0.1).to_csv(folder / "curve.csv")

    @given(damaged((folder / "curve.csv").read_bytes()))
    @FUZZ
    def read(content):
        (folder / "damaged.csv").write_bytes(content)
        refuses_or_reads(stoss.read_csv, folder / "damaged.csv")

    read()


@pytest.mark.parametrize("old, new", [(b"poisson", b"x" * 5000), (b"0.05", b"9" * 200_000), (b"0.05", b"x" * 5000),
                                      (b"stoss 2", b"stoss " + b"9" * 5000), (b"# stoss", b"# stoss 1 :"),
                                      (b",speed", b'"' * 9 + b",speed"), (b"runs", b"runs,runs")],
                         ids=["name", "number", "word", "version", "no version", "quotes", "twice"])  # fmt: skip
def test_csv_of_large_cells(folder, old, new):
    stoss.restitution(poisson=0.33, speed=[0.05, 0.1], tolerance=0.1).to_csv(folder / "whole.csv")
    whole = (folder / "whole.csv").read_bytes()
    assert old in whole
    (folder / "large.csv").write_bytes(whole.replace(old, new))
    refuses_or_reads(stoss.read_csv, folder / "large.csv")


def test_csv_of_large_whole_numbers(folder):
    stoss.restitution(poisson=0.33, speed=[0.05, 0.1], tolerance=0.1).to_csv(folder / "whole.csv")
    (folder / "large.csv").write_text(with_cell((folder / "whole.csv").read_text(), "runs", "9" * 40))
    with pytest.raises(stoss.InvalidInput, match="a number in column runs is too large"):
        stoss.read_csv(folder / "large.csv")
