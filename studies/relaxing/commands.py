"""The rows that the command prints, and the tables that these studies write."""

import csv
import shlex
import subprocess


def run(program, job):
    """The rows that a command prints, by names without units."""
    words = [program, *shlex.split(job), "--format", "csv", "--quiet"]
    found = subprocess.run(words, check=False, capture_output=True, text=True)
    if found.returncode not in (0, 1):  # 1: a value misses its tolerance
        raise RuntimeError(found.stderr)
    rows = csv.DictReader(line for line in found.stdout.splitlines() if not line.startswith("#"))
    return [{key.partition("[")[0]: text for key, text in row.items()} for row in rows]


def listed(values):
    return ",".join(f"{value:.6g}" for value in values)


def write(folder, name, about, rows, page="relaxing"):
    rows = list(rows)
    with open(folder / f"{name}.csv", "w", encoding="utf-8", newline="") as file:
        file.write(f"# {about}; made by `make results`. Columns: docs/understand/findings/{page}.md.\n")
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
