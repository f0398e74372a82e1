"""A folder of pages in which only what has changed is written, so that Sphinx reads only that again."""

import os
import shutil
from pathlib import Path

ROOT = Path(__file__).parents[3]


class Tree:
    """The folder; `finish` removes what was neither written nor linked."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.kept: set[Path] = set()
        (folder / "extra").mkdir(parents=True, exist_ok=True)

    def place(self, name: str) -> Path:
        place = self.folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        self.kept.add(place)
        return place

    def write(self, name: str, text: str) -> None:
        place = self.place(name)
        if not place.exists() or place.read_text(encoding="utf-8") != text:
            place.write_text(text, encoding="utf-8")

    def copy(self, name: str, file: Path) -> None:
        place = self.place(name)
        if not place.exists() or place.read_bytes() != file.read_bytes():
            shutil.copyfile(file, place)

    def link(self, name: str, target: Path) -> None:
        place = self.place(name)
        if not place.is_symlink():
            os.symlink(target, place)

    def finish(self) -> None:
        for folder, _, names in os.walk(self.folder):  # which follows no link
            links = [name for name in os.listdir(folder) if (Path(folder) / name).is_symlink()]
            for name in {*names, *links}:
                if (place := Path(folder) / name) not in self.kept:
                    place.unlink()
