"""stoss quasistatic: its output, the messages that go with it, and what it refuses."""

import json
import re
import signal
import subprocess

import pytest
from conftest import number, rows, wait_for_rows

pytestmark = pytest.mark.numbers

NU = 0.33
IMPACT = f"quasistatic --body disk --poisson {NU} --speed"
CONTACT = f"quasistatic --body disk --poisson {NU} --compression"
STEEL = "quasistatic --body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


@pytest.mark.parametrize("job, columns", [
    (f"{IMPACT} 0.01,0.1", ["poisson", "speed[c]", "lost_fraction", "lost_fraction_error", "contact_time[R/c]",
                            "max_compression[R]", "max_force[piRE]", "kinetic_share", "beyond_perturbation", "modes"]),
    (f"{CONTACT} 0.01,0.02", ["poisson", "compression[R]", "force[piRE]", "energy[mc^2]", "half_width[R]",
                              "static_force[piRE]", "static_force_error[piRE]"]),
])  # fmt: skip
def test_formats_agree(stoss, job, columns):
    text = stoss.run(job, "--law center --format csv --quiet").stdout
    head = [line for line in text.splitlines() if line.startswith("#")]
    assert re.fullmatch(r"# stoss \d+\.\d+\.\d+: quasistatic", head[0])
    assert head[1] == f"# command: stoss {job} --law center --format csv --quiet"
    assert {'# first: {"kind":"disk","poisson":0.33}', "# law: center"} <= set(head) and ("# cutoff: 60.0" in head) == ("--speed" in job)
    table = rows(text)
    assert list(table[0]) == columns
    document = json.loads(stoss.run(job, "--format json --quiet").stdout)
    assert document["schema"] == "stoss/quasistatic/2" and document["complete"] is True
    assert document["inputs"]["law"] == "center" and "modes" not in document
    units = {name.partition("[")[0]: name[name.index("[") + 1 : -1] for name in columns if "[" in name}
    assert document["units"] == units
    for row, record in zip(table, document["records"], strict=True):
        assert [json.loads(text) for text in row.values()] == list(record.values())
    shown = stoss.run(job, "--quiet").stdout.splitlines()
    assert len(shown) == 2 + len(table)
    for line, record in zip(shown[2:], document["records"]):
        assert float(line.split()[0]) == record["speed" if "--speed" in job else "compression"]


@pytest.mark.parametrize("job", [f"{IMPACT} 1e-100,1e-8,0.02,0.18", f"{CONTACT} 1e-12,0.01,0.26",
                                 f"{STEEL} --speed 1e-8,1,900", f"{STEEL} --compression 1e-12,1e-3"])  # fmt: skip
def test_table_fits_80_columns(stoss, job):
    lines = stoss.run(job, "--quiet").stdout.splitlines()
    assert max(map(len, lines)) <= 80
    assert all(line == line.rstrip() for line in lines)


def test_rows_beyond_perturbation_are_marked(stoss):
    result = stoss.run(f"{IMPACT} 0.001,0.02,0.03,0.1")
    assert result.returncode == 0
    assert [" !" in line for line in result.stdout.splitlines()[2:]] == [False, False, True, True]
    (warning,) = result.stderr.splitlines()
    assert warning.startswith("stoss: warning: 2 of 4 rows beyond perturbation theory")
    assert stoss.run(f"{IMPACT} 0.001,0.02").stderr == ""
    assert stoss.run(f"{IMPACT} 0.1 --quiet").stderr == ""
    for row in stoss.data(f"{IMPACT} lin:0.01:0.05:9"):
        assert row["beyond_perturbation"] == ("true" if number(row, "kinetic_share") > 0.04 else "false")


def test_great_compression_is_warned_of(stoss):
    result = stoss.run(f"{CONTACT} 0.05,0.2")
    assert result.returncode == 0
    assert result.stderr.startswith("stoss: warning: 1 of 2 compressions above 0.1 R")
    assert stoss.run(f"{CONTACT} 0.05,0.2 --quiet").stderr == ""


BAD_VALUES = [
    (f"{IMPACT} 0", "speed", "0, allowed 1e-100"),
    (f"{IMPACT} 9e-101", "speed", "9e-101"),
    (f"{IMPACT} 0.1,0.2", "speed", "0.2, allowed 1e-100 to 0.186546 c"),
    (f"{IMPACT} 0.4 --law diameter", "speed", "0.382785"),
    (f"{IMPACT} -0.1", "speed", "-0.1"),
    (f"{IMPACT} nan", "speed", "nan"),
    (f"{IMPACT} inf", "speed", "inf"),
    (f"{IMPACT} 0.1,x", "speed", "x"),
    (f"{IMPACT} log:0.1:0.2", "speed", "log:0.1:0.2"),
    (f"{STEEL} --speed 2000", "speed", "2000, allowed 5.17"),
    (f"{IMPACT} 0.1 --cutoff 1", "cutoff", "1"),
    (f"{IMPACT} 0.1 --cutoff 1001", "cutoff", "1001"),
    (f"{IMPACT} 0.1 --cutoff nan", "cutoff", "nan"),
    (f"{CONTACT} 0", "compression", "0"),
    (f"{CONTACT} 9e-13", "compression", "9e-13"),
    (f"{CONTACT} 0.01,0.3", "compression", "0.3, allowed 1e-12 to 0.263448 R"),
    (f"{CONTACT} nan", "compression", "nan"),
    (f"{CONTACT} 0.1,", "compression", "0.1,"),
    (f"{CONTACT} 0.1 --cutoff 30", "cutoff", "--compression"),
    ("quasistatic --body disk --poisson -0.95 --law diameter --compression 0.51", "compression", "0.51, allowed 1e-12 to 0.443147 R"),
    (f"{STEEL} --compression 0.01", "compression", "0.01, allowed 1e-14 to 0.0026"),
    ("quasistatic --body disk --poisson 1 --speed 0.1", "poisson", "1"),
    ("quasistatic --poisson nan --compression 0.1", "poisson", "nan"),
    (f"{IMPACT} 0.1 --young 1e9", "material", "disk without density"),
    (f"{IMPACT} 0.1 --law hertz", "law", "hertz with --body disk, allowed center or diameter"),
    (f"{STEEL} --speed 1 --yield 1e9", "yield", "--body disk"),
]


@pytest.mark.parametrize("arguments, name, got", BAD_VALUES)
def test_value_out_of_range(stoss, tmp_path, arguments, name, got):
    path = tmp_path / "kept"
    path.write_text("precious")
    for more in ("", f"-o {path} --format csv"):
        result = stoss.run(arguments, more)
        assert result.returncode == 3
        assert result.stdout == ""
        (line,) = result.stderr.splitlines()
        assert line.startswith(f"stoss: error: {name}: got ")
        assert got in line and "allowed" in line
    assert path.read_text() == "precious"


@pytest.mark.parametrize("arguments", [
    "quasistatic", f"quasistatic --body disk --poisson {NU}", f"{IMPACT} 0.1 --compression 0.1", f"{IMPACT} 0.1 --law linear",
    f"{CONTACT} 0.1 --tolerance 1", f"{IMPACT}",
    f"{IMPACT} 0.1 --against wall", f"{IMPACT} 0.1 --body rod",
])  # fmt: skip
def test_usage(stoss, arguments):
    result = stoss.run(arguments)
    assert result.returncode == 2
    assert result.stdout == ""
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: ") and "--help" in line


@pytest.mark.parametrize("poisson", ["-0.95", "0", "0.995"])
@pytest.mark.parametrize("law", ["center", "diameter"])
def test_range_ends_are_allowed(stoss, poisson, law):
    job = f"quasistatic --body disk --poisson {poisson} --law {law}"
    for option in ("--speed 9", "--compression 9"):
        refusal = stoss.run(f"{job} {option}").stderr
        low, high = (float(word) for word in refusal.split("allowed ")[1].split()[0:3:2])
        near = high * (1 - 1e-5)
        assert stoss.run(f"{job} {option[:-1]}{low!r},{near!r} --quiet").returncode == 0


def test_help_names_both_ways(stoss):
    text = stoss.run("quasistatic --help").stdout
    for word in ("--speed SPEEDS", "--compression DELTAS", "1e-100", "1e-12", "c (m/s", "(m with a material)", "(default: center)",
                 "(default: 60)", "stoss quasistatic --body disk --poisson 0.33 --compression lin:"):  # fmt: skip
        assert word in text, word


def test_interrupt_keeps_the_rows_so_far(stoss, tmp_path):
    path = tmp_path / "slow.csv"
    job = f"{IMPACT} log:1e-9:0.1:1000000 --format csv -o {path}"
    command = stoss.start(job, stderr=subprocess.PIPE)
    wait_for_rows(command, path, 20)
    command.send_signal(signal.SIGINT)
    assert command.wait(timeout=30) == 130
    assert command.stderr.read() == "stoss: error: interrupted\n"
    assert path.read_text().endswith("# interrupted: the rows above are complete, later ones are missing\n")


@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_full_disk(stoss, form):
    words = [stoss.path, *f"{IMPACT} 0.01 --format {form}".split()]
    with open("/dev/full", "w") as full:
        result = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
    assert result.returncode == 4
    (line,) = result.stderr.splitlines()
    assert "cannot write" in line and "No space left" in line
