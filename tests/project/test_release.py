"""scripts/release.sh, in a small repository of what it reads: what it refuses, and that all versions agree afterwards."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
READS = (
    "CHANGELOG.md CITATION.cff CMakeLists.txt debian/changelog docs/developer/versions.md include/stoss/stoss.h"
    " include/stoss/version.hpp scripts/release.sh"
).split()
OLD = re.search(r"project\(stoss VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
NEW = f"{int(OLD.partition('.')[0]) + 1}.0.0"
SECTION = "## Unreleased\n\n### What you must change\n\n- Nothing.\n\n"
WHO = {f"GIT_{who}_{what}": f"{who}@example.org" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}


class Repository:
    def __init__(self, folder):
        self.folder = folder
        for name in READS:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
        # Whatever stands there at present: a section to be released, and what is stable in it.
        text = self.read("CHANGELOG.md")
        released = re.search(rf"^## {re.escape(OLD)}.*", text, re.MULTILINE | re.DOTALL)[0]
        self.write("CHANGELOG.md", "# Changelog\n\n" + SECTION + released)
        stable = re.sub(r"^Within the versions \d+\.x:", f"Within the versions {NEW[0]}.x:", self.read("docs/developer/versions.md"),
                        flags=re.MULTILINE)  # fmt: skip
        self.write("docs/developer/versions.md", stable)
        self.git("init", "-q")
        self.commit()

    def read(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def git(self, *words):
        environment = {**os.environ, **WHO, "GIT_CONFIG_GLOBAL": os.devnull}
        done = subprocess.run(["git", *words], cwd=self.folder, capture_output=True, text=True, env=environment)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "Change")

    def release(self, *words):
        environment = {**os.environ, **WHO, "GIT_CONFIG_GLOBAL": os.devnull}
        return subprocess.run([self.folder / "scripts/release.sh", *words], capture_output=True, text=True,
                              env=environment, timeout=60)  # fmt: skip

    def state(self):
        return self.git("log", "--format=%H"), self.git("status", "--porcelain"), self.git("tag")


@pytest.fixture
def repository(tmp_path):
    return Repository(tmp_path)


def test_a_check_changes_nothing(repository):
    before = repository.state()
    done = repository.release("--check", NEW)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert f"{NEW} can follow no release" in done.stdout
    assert repository.state() == before


def test_a_release_writes_its_version_everywhere_and_tags_it(repository):
    done = repository.release(NEW)
    assert done.returncode == 0, done.stderr
    assert f"project(stoss VERSION {NEW} " in repository.read("CMakeLists.txt")
    citation = repository.read("CITATION.cff")
    assert re.findall(r"^version: (.*)$", citation, re.MULTILINE) == [NEW]
    assert len(re.findall(r"^date-released: \d{4}-\d\d-\d\d$", citation, re.MULTILINE)) == 1
    assert re.search(r"^## (.*)$", repository.read("CHANGELOG.md"), re.MULTILINE)[1].startswith(f"{NEW} (")
    assert repository.read("debian/changelog").startswith(f"stoss ({NEW}-1) unstable")
    assert repository.read("debian/changelog").count("\n -- ") == (ROOT / "debian/changelog").read_text().count("\n -- ") + 1
    for name in ("include/stoss/stoss.h", "include/stoss/version.hpp"):
        assert f'as in "{NEW}"' in repository.read(name)
    words = repository.read("docs/developer/versions.md")
    assert f"stoss {NEW} follows" in words and f"# stoss {NEW}: KIND" in words and f"stoss {OLD}" not in words
    assert repository.git("tag").split() == [f"v{NEW}"] and repository.git("status", "--porcelain") == ""
    assert repository.git("log", "-1", "--format=%s").strip() == f"Release {NEW}"
    # The next one needs a section of its own, and another number.
    again = repository.release("--check", NEW)
    assert again.returncode == 1 and f"whose tag v{NEW} exists" in again.stderr and "unchanged" in again.stderr
    next_one = f"{NEW[:-1]}1"
    assert "allowed a section 'Unreleased'" in repository.release("--check", next_one).stderr
    repository.write("CHANGELOG.md", repository.read("CHANGELOG.md").replace("## ", SECTION + "## ", 1))
    repository.commit()
    assert repository.release("--check", next_one).returncode == 0
    assert repository.release(next_one).returncode == 0
    assert repository.read("CITATION.cff").count("date-released") == 1


def test_what_is_left_to_a_person_is_said_of_a_tag(repository):
    before = repository.release("--left", NEW)
    assert before.returncode == 1 and f"which has no tag v{NEW}" in before.stderr and before.stdout == ""
    assert repository.release(NEW).returncode == 0
    after = repository.release("--left", NEW)
    assert after.returncode == 0 and after.stderr == ""
    for word in ("CITATION.cff", "key", "git push", "debsign", "twine", "npm publish", "build/docs", "DOI"):
        assert word in after.stdout, word


def test_make_release_does_it_in_this_order():
    text = (ROOT / "Makefile").read_text(encoding="utf-8")
    lines = text.partition("\nrelease:")[2].partition("\n\n")[0].splitlines()[1:]
    steps = [" ".join(line.split()).removeprefix("@").replace("$(MAKE) --no-print-directory", "make") for line in lines]
    assert steps == [
        'scripts/release.sh --check "$(VERSION)"', "make test-long", 'scripts/release.sh "$(VERSION)"',
        "make deb wheel npm static docs", 'scripts/release.sh --left "$(VERSION)"',
    ]  # fmt: skip


def test_the_version_of_the_sources_can_be_released():
    done = subprocess.run([ROOT / "scripts/release.sh", "--check", OLD], capture_output=True, text=True, timeout=60)
    faults = [line for line in done.stderr.splitlines() if not line.startswith("release: tree: got ")]
    tags = subprocess.run(["git", "tag"], cwd=ROOT, capture_output=True, text=True).stdout.split()
    if f"v{OLD}" in tags:  # the next section of the changelog is being written
        pytest.skip(f"{OLD} has been released")
    assert faults == [], faults


@pytest.mark.parametrize("version", ["", "2", "2.0", "v2.0.0", "2.0.0-1", "2.0.0 x"])
def test_what_is_no_version_is_refused(repository, version):
    done = repository.release("--check", version)
    assert done.returncode == 2 and "allowed three numbers" in done.stderr


def refused(repository, version, words):
    before = repository.state()
    for options in (["--check"], []):
        done = repository.release(*options, version)
        assert done.returncode == 1 and words in done.stderr, done.stderr
    assert repository.state() == before


def test_a_changed_tree_is_refused(repository):
    repository.write("CMakeLists.txt", repository.read("CMakeLists.txt") + "\n")
    refused(repository, NEW, "tree: got 1 changed files, allowed none")


def test_a_version_below_the_last_is_refused(repository):
    refused(repository, "0.9.0", "VERSION: got 0.9.0, allowed")


@pytest.mark.parametrize("section, words", [
    ("", f"got '{OLD}"),
    ("## Unreleased\n\n", "got nothing under 'Unreleased'"),
    ("## Unreleased\n\n### Fixed\n\n- A fault.\n\n", "must begin with '### What you must change'"),
])  # fmt: skip
def test_a_changelog_that_says_nothing_is_refused(repository, section, words):
    repository.write("CHANGELOG.md", repository.read("CHANGELOG.md").replace(SECTION, section))
    repository.commit()
    refused(repository, NEW, words)


def test_another_first_number_needs_words_on_what_is_stable(repository):
    stable = repository.read("docs/developer/versions.md").replace(f"Within the versions {NEW[0]}.x:", "Within the versions 0.x:")
    repository.write("docs/developer/versions.md", stable)
    repository.commit()
    refused(repository, NEW, f"docs/developer/versions.md: what is stable must be said of {NEW[0]}.x")


def test_placeholders_are_named(repository):
    assert "CITATION.cff has placeholders for people and repository" in repository.release("--check", NEW).stdout
    repository.write("CITATION.cff", re.sub("# Placeholders.*\n", "", repository.read("CITATION.cff")))
    repository.commit()
    assert "placeholders" not in repository.release("--check", NEW).stdout
