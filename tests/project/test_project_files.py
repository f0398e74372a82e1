"""What runs the project elsewhere, workflows, hooks, container, calls what the Makefile and scripts/ have; editors are
told what the formatters expect."""

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))
TARGETS = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
INSTALL = "apt-get update && apt-get install -y --no-install-recommends ca-certificates git make"


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def steps(text):
    """The commands of a workflow. Each has one line, so that there is no other place for logic than the Makefile."""
    lines = re.findall(r"^ *(?:- )?run: *(.*?)(?: +#.*)?$", text, re.MULTILINE)
    assert len(lines) == len(re.findall(r"\brun:", text)) and not {"|", ">", ""} & set(lines)
    return lines


def targets(text):
    return [word for words in re.findall(r"\bmake ((?:[a-z-]+ ?)+)", text) for word in words.split()]


def test_there_are_workflows_for_changes_wheels_documents_and_nights():
    assert [file.stem for file in WORKFLOWS] == ["docs", "nightly", "test", "wheels"]


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.stem)
def test_a_workflow_calls_targets_of_the_makefile_and_nothing_else(file):
    commands = steps(file.read_text(encoding="utf-8"))
    made = [re.fullmatch(r"make ([a-z-]+)", line) for line in commands]
    assert any(made) and all(match[1] in TARGETS for match in made if match)
    assert all(line == INSTALL or line.startswith("git config ") for line, match in zip(commands, made) if not match)


def test_an_unknown_target_would_be_found():
    assert steps("      - run: make unknown  # why\n") == ["make unknown"] and "unknown" not in TARGETS
    with pytest.raises(AssertionError):
        steps("      - run: |\n          make test\n")


def test_the_container_runs_the_two_commands():
    text = read("Containerfile")
    assert "FROM debian:12\n" in text and INSTALL in text and text.endswith('CMD ["make", "demo"]\n')
    assert {"demo", "test", "python"} <= set(targets(text)) <= TARGETS


def test_files_of_yaml_are_valid():
    yaml = pytest.importorskip("yaml")
    files = [*ROOT.glob(".github/**/*.yml"), ROOT / ".pre-commit-config.yaml"]
    assert len(files) == 10
    for file in files:
        assert isinstance(yaml.safe_load(file.read_text(encoding="utf-8")), dict), file
    for file in WORKFLOWS:
        jobs = yaml.safe_load(file.read_text(encoding="utf-8"))["jobs"]
        for job in jobs.values():
            # Git of the host's user would refuse the folder in a container.
            words = " ".join(step.get("run", "") for step in job["steps"])
            assert ("container" in job) == ("safe.directory" in words) and job["timeout-minutes"] <= 360
    for file in ROOT.glob(".github/ISSUE_TEMPLATE/[!c]*.yml"):
        form = yaml.safe_load(file.read_text(encoding="utf-8"))
        assert form["name"] and form["description"] and len({part["id"] for part in form["body"] if "id" in part}) > 2


def test_hooks_call_what_is_there():
    entries = re.findall(r"^ +entry: (\S+)", read(".pre-commit-config.yaml"), re.MULTILINE)
    assert entries == ["clang-format", "scripts/lint.sh"] and (ROOT / entries[1]).exists()


def test_editors_are_told_what_formatters_expect():
    columns = int(re.search(r"ColumnLimit: (\d+)", read(".clang-format"))[1])
    ruff = tomllib.loads(read("pyproject.toml"))["tool"]["ruff"]
    said = read(".editorconfig")
    sources = re.search(r"^\[\*\.\{(.*)\}\]\nmax_line_length = (\d+)$", said, re.MULTILINE)
    assert int(sources[2]) == columns == ruff["line-length"]
    assert {"cpp", "hpp", "c", "h", "py", "ts"} <= set(sources[1].split(","))


def test_placeholders_of_who_is_behind_the_project_say_that_they_are_some():
    for name in ("SECURITY.md", "CODE_OF_CONDUCT.md"):
        text = " ".join(read(name).split())
        assert "@example.org**. *This address is a placeholder: " in text, name
