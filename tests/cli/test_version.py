"""stoss --version: the version of the project and the commit, which cmake/commit.cmake finds at each build."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(stoss VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
NOBODY = {f"GIT_{who}_{what}": "nobody" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
needs_git = pytest.mark.skipif(shutil.which("git") is None, reason="needs git")


def test_the_command_says_its_version_and_its_commit(stoss):
    result = stoss.run("--version")
    assert (result.returncode, result.stderr) == (0, "")
    assert re.fullmatch(rf"stoss {re.escape(VERSION)}( \(commit [0-9a-f]{{7}}(, changed)?\))?\n", result.stdout)


def git(tree, *words):
    environment = {**os.environ, **NOBODY, "GIT_CONFIG_GLOBAL": os.devnull}
    done = subprocess.run(["git", "-C", tree, *words], env=environment, check=True, capture_output=True, text=True)
    return done.stdout.strip()


@pytest.fixture
def repository(tmp_path):
    tree = tmp_path / "tree"
    (tree / "part").mkdir(parents=True)
    (tree / "file").write_text("one\n")
    git(tree, "init", "--quiet")
    git(tree, "add", ".")
    git(tree, "commit", "--quiet", "--message=One")
    return tree


def commit(source, output, asked="auto", with_git=True):
    """What the script finds in a tree."""
    template = ROOT / "cli/commit.cpp.in"
    options = {"SOURCE": source, "TEMPLATE": template, "OUTPUT": output, "COMMIT": asked}
    if with_git:
        options["GIT"] = shutil.which("git")
    words = [f"-D{name}={value}" for name, value in options.items()]
    environment = {**os.environ, "GIT_CEILING_DIRECTORIES": str(output.parent)}
    subprocess.run(["cmake", *words, "-P", ROOT / "cmake/commit.cmake"], env=environment, check=True)
    return re.search(r'return "(.*)";', output.read_text(encoding="utf-8"))[1]


@needs_git
def test_the_commit_is_that_of_the_tree_and_says_whether_the_tree_differs(repository, tmp_path):
    output = tmp_path / "commit.cpp"
    first = git(repository, "rev-parse", "HEAD")[:7]
    assert commit(repository, output) == first
    (repository / "new").write_text("not tracked\n")
    assert commit(repository, output) == first
    (repository / "file").write_text("two\n")
    assert commit(repository, output) == f"{first}, changed"
    git(repository, "commit", "--quiet", "--all", "--message=Two")
    second = git(repository, "rev-parse", "HEAD")[:7]
    assert second != first and commit(repository, output) == second


@needs_git
def test_the_file_is_left_alone_while_the_commit_is_the_same(repository, tmp_path):
    output = tmp_path / "commit.cpp"
    commit(repository, output)
    os.utime(output, (1, 1))
    commit(repository, output)
    assert output.stat().st_mtime == 1


@needs_git
def test_no_commit_is_known_without_a_repository_of_its_own_or_without_git(repository, tmp_path):
    output = tmp_path / "commit.cpp"
    (tmp_path / "tarball").mkdir()
    assert commit(tmp_path / "tarball", output) == ""
    assert commit(repository / "part", output) == ""  # a folder of another repository
    assert commit(repository, output, with_git=False) == ""


def test_whoever_builds_may_say_the_commit(tmp_path):
    assert commit(tmp_path, tmp_path / "commit.cpp", asked="of mine") == "of mine"
    assert commit(ROOT, tmp_path / "commit.cpp", asked="") == ""
