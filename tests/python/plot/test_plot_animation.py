"""Films: whole, small, and of the impact they are said to be of."""

import os
import stat
import subprocess
import sys

import matplotlib
import numpy as np
import pytest
import stoss
from matplotlib import pyplot
from matplotlib.animation import FFMpegWriter
from PIL import Image
from stoss.results import _replay


@pytest.fixture(autouse=True)
def settings():
    before = dict(matplotlib.rcParams)
    yield
    assert dict(matplotlib.rcParams) == before and pyplot.get_fignums() == []


@pytest.fixture(scope="module")
def hit():
    return stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5)


@pytest.mark.parametrize("quantity", [None, "von_mises", "fringes"])
def test_gif(hit, tmp_path, quantity):
    path = tmp_path / "hit.GIF"
    assert stoss.animate(hit, path, frames=6, fps=10, size=(160, 140), quantity=quantity) is path
    assert os.listdir(tmp_path) == ["hit.GIF"]
    with Image.open(path) as film:
        assert (film.n_frames, film.size, film.info["duration"], film.info["loop"]) == (6, (160, 140), 100, 0)
        pictures = []
        for k in range(6):
            film.seek(k)
            pictures.append(np.asarray(film.convert("RGB"), dtype=int))
    disk = [picture[30:110, 40:120] for picture in pictures]
    assert all(np.abs(one - two).max() > 50 for one, two in zip(disk, disk[1:]))
    assert (pictures[0][0, 0] >= 250).all()


def test_default_gif_is_small(hit, tmp_path):
    stoss.animate(hit, tmp_path / "hit.gif", frames=20)
    assert (tmp_path / "hit.gif").stat().st_size < 2e6 / 3


def test_all_fields_come_from_one_call(hit, tmp_path, monkeypatch):
    calls = []
    real = _replay.field

    def counted(self, **named):
        calls.append(np.size(named["time"]))
        return real(self, **named)

    monkeypatch.setattr(_replay, "field", counted)
    stoss.animate(hit, tmp_path / "hit.gif", frames=5, size=(100, 100))
    assert calls == [5]


def test_existing_file_is_replaced_and_keeps_its_mode(hit, tmp_path):
    path = tmp_path / "hit.gif"
    path.write_text("old")
    path.chmod(0o640)
    stoss.animate(hit, str(path), frames=2, size=(100, 100))
    assert path.read_bytes()[:3] == b"GIF" and stat.S_IMODE(path.stat().st_mode) == 0o640


@pytest.mark.parametrize(
    "path, arguments, message",
    [
        ("hit.webm", {}, "path: got 'hit.webm', allowed a path that ends in .gif or .mp4"),
        ("hit", {}, "path: got 'hit', allowed a path that ends in .gif or .mp4"),
        (3, {}, "path: got 3, allowed a path that ends in .gif or .mp4"),
        ("hit.gif", {"frames": 1}, "frames: got 1, allowed 2 to 2000"),
        ("hit.gif", {"fps": 100}, "fps: got 100, allowed 1 to 50"),
        ("hit.gif", {"size": 300}, "size: got 300, allowed two integers"),
        ("hit.gif", {"size": (10, 300)}, "size: got (10, 300), allowed 100 to 4000 pixels"),
        ("hit.gif", {"quantity": "heat"}, "quantity: got 'heat', allowed 'von_mises', "),
        ("hit.gif", {"quantity": "fringes", "fringe": -1}, "fringe: got -1, allowed a stress above 0"),
    ],
)
def test_animation_refusals(hit, tmp_path, monkeypatch, path, arguments, message):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(stoss.InvalidInput) as caught:
        stoss.animate(hit, path, **arguments)
    assert str(caught.value).startswith(message)
    assert os.listdir(tmp_path) == []


def test_missing_folder(hit, tmp_path):
    path = tmp_path / "nowhere" / "hit.gif"
    with pytest.raises(FileNotFoundError) as caught:
        stoss.animate(hit, path)
    assert caught.value.filename == str(path)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_unwritable_folder(hit, tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(PermissionError):
        stoss.animate(hit, tmp_path / "hit.gif")


def test_folder_in_the_way(hit, tmp_path):
    (tmp_path / "hit.gif").mkdir()
    with pytest.raises(IsADirectoryError):
        stoss.animate(hit, tmp_path / "hit.gif")


def test_failure_leaves_no_half_file(hit, tmp_path, monkeypatch):
    def fail(*arguments, **named):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Image.Image, "save", fail)
    with pytest.raises(OSError, match="No space"):
        stoss.animate(hit, tmp_path / "hit.gif", frames=2, size=(100, 100))
    assert os.listdir(tmp_path) == []


def test_without_ffmpeg(hit, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(RuntimeError) as caught:
        stoss.animate(hit, tmp_path / "hit.mp4")
    assert "ffmpeg" in str(caught.value) and ".gif" in str(caught.value) and "\n" not in str(caught.value)
    assert os.listdir(tmp_path) == []


def stand_in(folder, monkeypatch, body):
    """A program of the name ffmpeg."""
    script = folder / "ffmpeg"
    script.write_text(f"#!{sys.executable}\nimport sys\n{body}\n")
    script.chmod(0o755)
    monkeypatch.setenv("PATH", str(folder), prepend=os.pathsep)


def test_what_ffmpeg_is_given(hit, tmp_path, monkeypatch):
    stand_in(tmp_path, monkeypatch, "open(sys.argv[-1], 'wb').write(sys.stdin.buffer.read())")
    path = tmp_path / "hit.mp4"
    stoss.animate(hit, path, frames=3, size=(121, 101))
    pictures = np.frombuffer(path.read_bytes(), dtype=np.uint8).reshape(3, 102, 122, 3)
    assert (pictures[:, 0, 0] == 255).all() and (pictures[0] != pictures[1]).any()
    assert sorted(os.listdir(tmp_path)) == ["ffmpeg", "hit.mp4"]


def test_ffmpeg_that_fails(hit, tmp_path, monkeypatch):
    stand_in(tmp_path, monkeypatch, "sys.exit('Unknown encoder\\nand more')")
    with pytest.raises(RuntimeError) as caught:
        stoss.animate(hit, tmp_path / "hit.mp4", frames=3, size=(200, 200))
    assert str(caught.value).endswith("Unknown encoder and more")
    assert os.listdir(tmp_path) == ["ffmpeg"]


@pytest.mark.skipif(not FFMpegWriter.isAvailable(), reason="needs ffmpeg")
def test_mp4(hit, tmp_path):
    stoss.animate(hit, tmp_path / "hit.mp4", frames=4, size=(160, 140))
    with open(tmp_path / "hit.mp4", "rb") as film:
        assert film.read(8)[4:] == b"ftyp"
    subprocess.run(["ffmpeg", "-v", "error", "-i", tmp_path / "hit.mp4", "-f", "null", "-"], check=True)


def test_only_disks_have_films(tmp_path):
    rod = stoss.impact(stoss.Rod(), speed=0.1, cutoff=100)
    with pytest.raises(stoss.InvalidInput, match="allowed a stoss.Disk"):
        stoss.animate(rod, tmp_path / "rod.gif")
    assert os.listdir(tmp_path) == []
