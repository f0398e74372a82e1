"""Tables that studies have written, for their figures."""

import csv


def table(folder, name):
    """The rows of a CSV file, with numbers where there are numbers, by names without units."""

    def number(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(folder / f"{name}.csv", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{key.partition("[")[0]: number(text) for key, text in row.items()} for row in rows]


def having(rows, **values):
    """The rows with these values."""
    return [row for row in rows if all(row[name] == value for name, value in values.items())]
