"""docs/paper: what it cites is in its bibliography, and its numbers are those of the pages that measure them."""

import re

import pytest
from conftest import ROOT, page

PAPER, WORDS = page("docs/paper/paper.md")
HEAD, BODY = PAPER.removeprefix("---\n").split("\n---\n", 1)
FOLDER = ROOT / "docs/paper"
BIBLIOGRAPHY = (FOLDER / "paper.bib").read_text(encoding="utf-8")
VALIDATION, VALIDATION_WORDS = page("docs/developer/validation.md")
PERFORMANCE, PERFORMANCE_WORDS = page("docs/developer/benchmarks.md")


def test_it_has_the_form_of_the_journal():
    yaml = pytest.importorskip("yaml")
    head = yaml.safe_load(HEAD)
    assert {"title", "tags", "authors", "date", "bibliography"} <= set(head)
    assert (FOLDER / head["bibliography"]).exists()
    assert [author["name"] for author in head["authors"]] == ["The stoss developers"]
    assert {author["affiliation"] for author in head["authors"]} == {place["index"] for place in head["affiliations"]}
    sections = re.findall(r"^# (.*)$", BODY, re.MULTILINE)
    assert sections[:3] == ["Summary", "Statement of need", "State of the field"] and sections[-1] == "References"
    assert 800 < len(BODY.split()) < 1200  # two pages


def test_what_it_cites_is_in_the_bibliography_and_nothing_else():
    entries = re.findall(r"^@\w+\{(\w+),$", BIBLIOGRAPHY, re.MULTILINE)
    assert set(re.findall(r"@(\w+)", BODY)) == set(entries) and len(entries) == len(set(entries))
    for entry in re.split(r"^@", BIBLIOGRAPHY, flags=re.MULTILINE)[1:]:
        where = {"booktitle"} if entry.startswith("inproceedings") else {"journal", "volume"}
        assert {"author", "title", "pages", "year"} | where <= set(re.findall(r"^  (\w+) +=", entry, re.M)), entry


def test_its_figure_is_there():
    figures = re.findall(r"!\[[^\]]*\\label\{(fig:\w+)\}\]\(([^)]*)\)", BODY)
    assert figures and all((FOLDER / file).exists() for _, file in figures)
    assert set(re.findall(r"\\autoref\{(.*?)\}", BODY)) == {label for label, _ in figures}


def rows(section, tolerance):
    """The rows of the tables of a section of docs/developer/validation.md at a tolerance."""
    text = VALIDATION.partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("| ")]
    return [line for line in lines if line[0] == tolerance]


def test_the_shares_within_the_errors_are_those_of_the_validation():
    within = [float(row[3].removesuffix(" %")) for row in rows("Result", "0.001")]
    assert len(within) == 10 and "at ten sets of points" in WORDS
    assert f"{min(within):.0f} to {max(within):.0f} % of the true errors are within the estimated ones" in WORDS
    shares = re.search(r"with 0.1 < v < 0.6, ([\d, and]+) % lie within", VALIDATION_WORDS)[1]
    assert f"Fast disks, 0.1 to 0.6 of the wave speed, are the weak spot, at {re.findall('[0-9]+', shares)[1]} %" in WORDS
    oblique = {row[4].removesuffix(" %") for row in rows("Oblique impacts", "0.001") if row[1] == "all"}
    plates = [row[3].removesuffix(" %") for row in rows("Balls on plates", "all") if row[1] == "1−ε²"]
    assert len(oblique) == 1
    shown = [f"{min(map(float, shares)):.0f}" for shares in (oblique, plates)]
    assert f"sets of their own, of which {' and '.join(shown)} % are within their errors" in WORDS


def test_the_times_of_disks_are_those_of_the_validation():
    ((_, converged, _, median, _, longest, *_),) = rows("Convergence and time", "0.001")
    points = converged.split()[-1]
    assert f"takes {median} ms in the median of {points} points" in WORDS
    assert f"{longest} ms at most" in WORDS


def test_the_times_of_spheres_are_those_of_the_performance():
    lines = re.findall(r"^\| restitution of a sphere to 0.001, v = 0\.(?:1|05|02) \| ([\d.]+) \|", PERFORMANCE, re.M)
    own = [float(time) for time in lines]
    assert len(own) == 3
    assert f"takes {min(own):.0f} to {max(own):.0f} ms at" in WORDS


def test_the_times_of_finite_elements_are_those_of_the_performance():
    ratios = {}
    for shape in ("disk", "sphere", "half-space"):
        table = PERFORMANCE.partition(f"\n| {shape}: error, speed |")[2].partition("\n\n")[0]
        ratios[shape] = [float(ratio) for ratio in re.findall(r"^\| 0\.001, .* \| ([\d.]+) \|$", table, re.M)]
    disk, ball = ratios["disk"], ratios["sphere"]
    assert f"take {min(disk):.0f} to {max(disk):.0f} times as long for disks" in WORDS
    assert f"{min(ball):.0f} to {max(ball):.0f} times for spheres" in WORDS


def test_the_procedure_of_the_model_takes_what_the_performance_says():
    said = r"At equal error \((.*?) of 1 − ε²\) .*? takes (\d+) ms .*? `restitution` to 10⁻² takes ([\d.]+) ms"
    error, theirs, own = re.search(said, PERFORMANCE_WORDS).groups()
    assert f"for an error of {error} of" in WORDS
    assert f"takes {theirs} ms with the modes and inner loops of `stoss`, and `stoss` itself {own} ms" in WORDS


def test_the_measured_losses_are_those_of_the_page():
    measured, _ = page("docs/understand/measured.md")
    loss = re.search(r"^\| alumina.*\| ([\d.]+) \|$", measured, re.MULTILINE)[1]
    assert f"lose {loss} times the predicted energy" in WORDS


def test_the_caption_says_what_the_readme_says_of_the_figure():
    _, readme = page("README.md")
    leaves, stays = re.search(r"Waves take (\d+) % of the energy, and ([\d.]+) % stays in the ball", readme).groups()
    assert f"{leaves} % of the energy leaves as waves, {stays} % stays in the ball as vibration" in WORDS


def test_errata_are_counted_as_in_the_theory():
    assert "Thirteen errata" in WORDS
    rows = re.findall(r"^\| \[E\d+\]", page("docs/theory/errata.md")[0], re.MULTILINE)
    assert len(rows) == 13
