"""Where output goes: what a file holds stays until what replaces it is on the disk, whatever goes wrong."""

import os
import resource
import stat
import subprocess

import pytest

NU = "--body disk --poisson 0.33 --speed 0.1"
TABLE = "table --body disk --poisson 0.33 --speed 0.01:0.1 --error 0.1"
# Every way to write a file.
WAYS = [
    *[f"{job} --format {form} -o" for form, job in zip(("table", "csv", "json", "csv", "table", "csv", "json"), (
        "modes --body disk --poisson 0.33 --cutoff 3", f"impact {NU} --cutoff 12.5",
        f"bounce {NU} --cutoff 4 --flight-time 30 --count 2", f"restitution {NU} --tolerance 0.1",
        f"distribution {NU} --spectrum 2,0,energy=0.1 --samples 2 --error 0.1",
        "quasistatic --body disk --poisson 0.33 --speed 0.01 --cutoff 9", "quasistatic --poisson 0.33 --compression 0.01",
    ), strict=True)],
    f"impact {NU} --cutoff 12.5 --trajectory", f"restitution {NU} --tolerance 0.1 --resume", f"{TABLE} -o",
]  # fmt: skip
# Rows of CSV, rows at the end, what is no row, an instant each, and rows that are continued.
KINDS = [WAYS[1], WAYS[2], *WAYS[7:]]


def fails(result, *words):
    """Exit status 4 and one line."""
    assert (result.returncode, result.stdout) == (4, ""), result
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: output: cannot write ") and all(str(word) in line for word in words), line


def limited(size):
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


@pytest.mark.parametrize("way", WAYS)
def test_a_file_is_replaced_as_a_whole_or_left(stoss, tmp_path, way):
    """Behind a link, with the rights that it had; on a full disk not at all; in a folder that is not there neither."""
    path = tmp_path / "x"
    fails(stoss.run(way, str(path), preexec_fn=limited(100)), path, "File too large")
    assert os.listdir(tmp_path) == []
    (tmp_path / "link").symlink_to("x")
    assert stoss.run(way, "link", cwd=tmp_path).returncode == 0  # makes what the link names
    text = path.read_text()
    if "--resume" not in way:
        path.write_text(10 * text + "behind")
        fails(stoss.run(way, str(path), preexec_fn=limited(100)), path, "File too large")
        assert path.read_text() == 10 * text + "behind"
    path.chmod(0o640)
    assert stoss.run(way, "link", cwd=tmp_path).returncode == 0
    assert (tmp_path / "link").is_symlink() and sorted(os.listdir(tmp_path)) == ["link", "x"]
    assert path.read_text() == text and stat.S_IMODE(path.stat().st_mode) == 0o640
    fails(stoss.run(way, f"{tmp_path}/none/x"), "No such file")


# Of 45 MB, of which 16 are kept in memory.


@pytest.mark.numbers
@pytest.mark.parametrize("size", [2000, 20_000_000])
def test_full_disk_keeps_the_old_trajectory(stoss, tmp_path, size):
    """Rows of it were written before the disk was full."""
    path = tmp_path / "t.csv"
    path.write_text("precious")
    trajectory = f"impact {NU} --cutoff 2 --nodes 16 --step 2e-5 --trajectory"
    fails(stoss.run(trajectory, str(path), preexec_fn=limited(size)), "t.csv", "File too large")
    assert os.listdir(tmp_path) == ["t.csv"] and path.read_text() == "precious"


@pytest.mark.parametrize("way", KINDS)
def test_places_that_cannot_be_written(stoss, tmp_path, way):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    (tmp_path / "loop").symlink_to("loop")
    places = [tmp_path / "pipe", tmp_path / "link", *([] if "--trajectory" in way else ["/dev/stdout"])]
    if os.geteuid() == 0:  # one of our own, which may be harmed
        places.append(tmp_path / "null")
        os.mknod(places[-1], stat.S_IFCHR | 0o666, os.makedev(1, 3))
    for place in places:
        fails(stoss.run(way, str(place)), f"'{place}'", "not a regular file", "leave the option out")
    fails(stoss.run(way, str(tmp_path)), f"'{tmp_path}'", "directory")
    fails(stoss.run(way, str(tmp_path / "loop")), "loop")
    assert not any(path.is_file() for path in tmp_path.iterdir() if path.name != "loop")

    def in_removed_folder():
        resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
        (tmp_path / "gone").mkdir()
        os.chdir(tmp_path / "gone")
        (tmp_path / "gone").rmdir()

    fails(stoss.run(way, "./x", preexec_fn=in_removed_folder), "'./x'", "its folder has been removed")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
@pytest.mark.parametrize("way", KINDS)
def test_what_may_not_be_written_or_read(stoss, tmp_path, way):
    path = tmp_path / "x"
    path.write_text("precious")
    path.chmod(0o400)
    fails(stoss.run(way, str(path)), "Permission denied")
    (tmp_path / "folder").mkdir(0o500)
    fails(stoss.run(way, str(tmp_path / "folder/x")), "Permission denied")


@pytest.mark.parametrize("name", ["x", "/dev/stdout", "/dev/stderr"])
def test_a_file_that_is_a_standard_stream_already(stoss, tmp_path, name):
    with open(tmp_path / "x", "w") as stream:
        error = stream if name == "/dev/stderr" else subprocess.PIPE
        out = subprocess.PIPE if name == "/dev/stderr" else stream
        words = [stoss.path, *WAYS[0].split(), name]
        done = subprocess.run(words, cwd=tmp_path, stdout=out, stderr=error, text=True, timeout=60)
    assert done.returncode == 4
    assert f"'{name}': it is std" in (done.stderr or (tmp_path / "x").read_text())


@pytest.mark.parametrize("job", [
    f"bounce {NU} --flight-time 1 --mode 2,99,energy=0.1", f"restitution {NU},7", f"distribution {NU} --spectrum 2,0,energy=-1",
    f"impact {NU} --nodes 1", "modes --body disk --poisson 7", f"{NU.replace('0.1', '9').replace('--body', 'quasistatic --body')}",
    "restitution --body disk --poisson 0.33,7 --speed 0.1", f"oblique {NU} --friction 9", f"{TABLE}7", "predict --speed 1",
])  # fmt: skip
@pytest.mark.parametrize("there", [True, False])
def test_what_is_refused_writes_nothing(stoss, tmp_path, job, there):
    path = tmp_path / "x"
    if there:
        path.write_text("precious")
    result = stoss.run(job, f"-o {path}")
    assert result.returncode in (2, 3) and result.stdout == "" and result.stderr.count("\n") == 1, result
    assert os.listdir(tmp_path) == (["x"] if there else [])
    assert not there or path.read_text() == "precious"


@pytest.mark.parametrize("job", ["modes", "impact --speed 0.1", "restitution --speed 0.1,0.2", "quasistatic --compression 0.01", "table --speed 0.01:0.1"])
@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_full_stdout(stoss, job, form):
    form = {"table": "c", "csv": "two-column"}.get(form, form) if job.startswith("table") else form
    with open("/dev/full", "w") as full:
        words = [stoss.path, *f"{job} --body disk --poisson 0.33 --format {form}".split()]
        result = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        assert subprocess.run([stoss.path, "--help"], stdout=full, stderr=subprocess.PIPE).returncode == 4
    assert result.returncode == 4
    (line,) = result.stderr.splitlines()
    assert "cannot write" in line and "No space left" in line


@pytest.mark.parametrize("one, other", [("./same.csv", "same.csv"), ("same.csv", "{}/same.csv"), ("a/../same.csv", "same.csv"),
                                        ("link/same.csv", "a/same.csv"), ("loose", "./same.csv"), ("loose", "loose"),
                                        ("a/up/same.csv", "same.csv"), ("x", "hard"), ("x", "/proc/self/cwd/x")])  # fmt: skip


def test_two_outputs_in_one_file(stoss, tmp_path, one, other):
    (tmp_path / "a").mkdir()
    (tmp_path / "link").symlink_to("a")
    (tmp_path / "a" / "up").symlink_to("..")
    (tmp_path / "loose").symlink_to("same.csv")
    (tmp_path / "x").write_text("precious")
    os.link(tmp_path / "x", tmp_path / "hard")
    before = sorted(os.listdir(tmp_path))
    for a, b in ((one, other), (other, one)):
        result = stoss.run(f"impact {NU} --trajectory", a.format(tmp_path), "-o", b.format(tmp_path), cwd=tmp_path)
        assert result.returncode == 3 and "one would overwrite the other" in result.stderr
    assert sorted(os.listdir(tmp_path)) == before and (tmp_path / "x").read_text() == "precious"
    with open(tmp_path / "x", "a") as stdout:
        words = f"impact {NU} --trajectory /dev/stdout".split()
        assert subprocess.run([stoss.path, *words], stdout=stdout, stderr=subprocess.DEVNULL).returncode == 3


def test_names_and_places(stoss, tmp_path):
    path = tmp_path / ("n" * 253 + ".h")
    assert stoss.run(TABLE, f"-o {path}").returncode == 0 and path.exists()
    assert stoss.run("modes --body disk --poisson 0.33 --cutoff 3 -o -").stdout.startswith("  order")
    texts = []
    for _ in range(2):
        assert stoss.run(f"restitution {NU} --format json -o x", cwd=tmp_path).returncode == 0
        texts.append((tmp_path / "x").read_text())
    assert texts[0] == texts[1]  # equal runs give equal files


@pytest.mark.numbers
def test_disk_of_a_page(stoss, tmp_path):
    if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=2m", "none", tmp_path]).returncode:
        pytest.skip("needs the right to mount")
    try:
        path = tmp_path / "t.csv"
        path.write_text("precious")
        fails(stoss.run(f"impact {NU} --cutoff 2 --nodes 16 --step 2e-5 --trajectory", str(path)), "No space left")
        assert path.read_text() == "precious" and os.listdir(tmp_path) == ["t.csv"]
    finally:
        subprocess.run(["umount", tmp_path], check=True)
