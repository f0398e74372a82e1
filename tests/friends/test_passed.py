"""What passed.toml says has passed was written by a run: of inputs that this or an earlier commit has, by the tests that
the group has, and sealed."""

import datetime
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import friends  # noqa: E402

RECORDS = friends.passed()
GOOD = {
    "inputs": "0" * 64,
    "date": datetime.datetime(2026, 1, 1, tzinfo=datetime.timezone.utc),
    "tests": {"friends.page.core": 1.5},
}


def commits(group):
    """Those that changed an input, the newest first."""
    return friends.git("log", "--format=%H", "--", *friends.GROUPS[group]["inputs"]).split()


def complaint(group, record):
    """Why no run can have written this record; '' if one can."""
    if group not in friends.GROUPS:
        return "no such group"
    if not re.fullmatch("[0-9a-f]{64}", record["inputs"]):
        return "no hash"
    if record.get("seal") != friends.seal(group, record):
        return "changed by hand"
    if record["date"] > datetime.datetime.now(datetime.timezone.utc) + datetime.timedelta(days=1):
        return "of the future"
    if min(record["tests"].values(), default=0.0) < 0.0 or not sum(record["tests"].values()) > 0.0:
        return "took no time"
    if record["inputs"] == friends.inputs(group):
        return "" if sorted(record["tests"]) == sorted(friends.tests(group)) else "not the tests of the group"
    shallow = friends.git("rev-parse", "--is-shallow-repository").strip() == "true"
    if shallow or any(record["inputs"] == friends.inputs(group, commit) for commit in commits(group)):
        return ""
    return "of inputs that no commit has (make test-friends)"


@pytest.mark.parametrize("group", friends.GROUPS)
def test_what_passed_was_written_by_a_run(group):
    if group in RECORDS:
        assert complaint(group, RECORDS[group]) == ""


def test_no_other_group_has_passed():
    assert set(RECORDS) <= set(friends.GROUPS)


def sealed(group, **changes):
    record = {**GOOD, **changes}
    return {**record, "seal": friends.seal(group, record)}


@pytest.mark.parametrize("group, record, why", [
    ("unknown", sealed("unknown"), "no such group"),
    ("page", sealed("page", inputs="yes"), "no hash"),
    ("page", GOOD, "changed by hand"),
    ("page", {**sealed("page"), "inputs": "1" * 64}, "changed by hand"),
    ("page", {**sealed("page"), "tests": {"friends.page.core": 1.6}}, "changed by hand"),
    ("engines", sealed("page"), "changed by hand"),
    ("page", sealed("page", date=datetime.datetime(9999, 1, 1, tzinfo=datetime.timezone.utc)), "of the future"),
    ("page", sealed("page", tests={}), "took no time"),
    ("page", sealed("page", tests={"friends.page.core": 0.0}), "took no time"),
    ("page", sealed("page", tests={"friends.page.core": 3.0, "friends.page.build": -1.0}), "took no time"),
    ("page", sealed("page"), "of inputs that no commit has (make test-friends)"),
])  # fmt: skip
def test_what_no_run_can_have_written_is_refused(group, record, why):
    shallow = friends.git("rev-parse", "--is-shallow-repository").strip() == "true"
    assert complaint(group, record) == ("" if shallow and why.startswith("of inputs") else why)


def test_the_tests_are_those_of_the_group():
    assert complaint("page", sealed("page", inputs=friends.inputs("page"))) == "not the tests of the group"


@pytest.mark.parametrize("group", friends.GROUPS)
def test_a_group_has_tests_inputs_and_packages(group):
    assert friends.tests(group)
    for path in friends.GROUPS[group]["inputs"]:
        assert (ROOT / path).exists(), path
    words = [ROOT / "scripts/install-dependencies.sh", group]
    named = subprocess.run(words, env={**os.environ, "STOSS_LIST": "1"}, capture_output=True, text=True)
    assert named.returncode == 0 and len(named.stdout.split()) > 1, named.stderr


def test_every_test_of_a_friend_is_in_a_group():
    grouped = {name for group in friends.GROUPS for name in friends.tests(group)}
    assert {name for name in friends.known() if name.startswith("friends.")} == grouped


def test_a_changed_input_is_seen():
    """A commit's inputs are those that a folder with its files has."""
    if friends.git("status", "--porcelain", "--", *friends.GROUPS["engines"]["inputs"]):
        pytest.skip("the inputs are being changed")
    assert friends.inputs("engines") == friends.inputs("engines", "HEAD")
    older = [friends.inputs("engines", commit) for commit in commits("engines")[:3]]
    assert len(set(older)) == len(older)
