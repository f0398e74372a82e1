"""Files that read_csv takes and refuses, and the table that it makes of them."""

import pickle

import numpy as np
import pytest

import stoss


def test_an_unknown_error_is_infinite(tmp_path):
    path = tmp_path / "unknown.csv"
    path.write_text("# stoss 0.1.0: restitution\n# body: disk\nspeed[c],restitution_error\n0.1,unknown\n0.2,0.5\n")
    assert stoss.read_csv(path)["restitution_error"].tolist() == [np.inf, 0.5]


GOOD = "# stoss 0.1.0: modes\n# cutoff: 3\norder,omega[c/R]\n0,2.5\n1,3.5\n"


@pytest.mark.parametrize(
    "text, what",
    [
        ("", "has written"), ("a,b\n1,2\n", "has written"), ("# stoss\n", "has written"), ("\0\1", "has written"),
        (GOOD[:-1], "damaged"), (GOOD[:-4], "damaged"), (GOOD + "2\n", "damaged"), (GOOD + "2,3,4\n", "damaged"),
        (GOOD.replace("3.5", "x"), "damaged"), (GOOD.replace("2.5", ""), "damaged"),
        (GOOD.replace("omega[c/R]", "order"), "damaged"), (GOOD.replace("c/R]", "c/R"), "damaged"),
        ("# stoss 0.1.0: modes\n# cutoff: 3\n", "damaged"),
    ],
)  # fmt: skip
def test_foreign_and_damaged_files_are_refused_in_one_line(text, what, tmp_path):
    path = tmp_path / "file.csv"
    path.write_text(text)
    with pytest.raises(stoss.InvalidInput, match=what) as refusal:
        stoss.read_csv(path)
    assert "\n" not in str(refusal.value) and "file.csv" in str(refusal.value)


def test_what_is_no_text_is_refused(tmp_path):
    path = tmp_path / "file.csv"
    path.write_bytes(b"# stoss 0.1.0: modes\n\xff\xfe\n")
    with pytest.raises(stoss.InvalidInput, match="has written"):
        stoss.read_csv(path)
    with pytest.raises(FileNotFoundError):
        stoss.read_csv(tmp_path / "none.csv")


def test_a_table_is_a_frozen_mapping(tmp_path):
    path = tmp_path / "file.csv"
    path.write_text(GOOD)
    table = stoss.read_csv(path)
    assert dict(table.items()).keys() == {"order", "omega"} and "omega" in table and len(table) == 2
    assert table[1] == {"order": 1, "omega": 3.5} and table[-1] == table[1]
    assert table[:1]["omega"].tolist() == [2.5] and table[table["omega"] > 3].size == 1
    assert [row["order"] for row in (table[k] for k in range(table.size))] == [0, 1]
    again = pickle.loads(pickle.dumps(table))
    assert again["omega"].tolist() == [2.5, 3.5] and again.units == table.units
    with pytest.raises(KeyError):
        table["none"]
    with pytest.raises(IndexError):
        table[2]
    with pytest.raises(AttributeError):
        table.kind = "other"
    with pytest.raises(TypeError):
        table.columns["omega"] = 0


def test_html_is_escaped(tmp_path):
    path = tmp_path / "file.csv"
    path.write_text("# stoss 0.1.0: <b>\n<i>,family\n1,<script>\n")
    text = stoss.read_csv(path)._repr_html_()
    assert "<script>" not in text and "&lt;script&gt;" in text and "<b>" not in text and "<i>" not in text
