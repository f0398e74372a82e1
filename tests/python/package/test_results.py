"""Any result: frozen, with a line that says the essential, the same as a copy, a dictionary, a file, a frame, and HTML."""

import copy
import dataclasses
import json
import pickle

import numpy as np
import pytest
import stoss
from every_result import RESULTS, computed
from stoss.results._result import Result


@pytest.fixture(params=RESULTS)
def result(request):
    return computed(request.param)


def alike(one, other):
    """Equal, where what is no number is itself too."""
    return json.dumps(one) == json.dumps(other)


def values(result):
    return {field.name: getattr(result, field.name) for field in dataclasses.fields(result)}


def test_every_public_class_of_results_is_among_them():
    public = {each for module in (stoss, stoss.quasistatic) for each in vars(module).values() if isinstance(each, type)}
    made = {base for name in RESULTS for base in type(computed(name)).__mro__}
    assert {each for each in public if issubclass(each, Result)} <= made


def test_fields_are_read_only(result):
    for name, value in values(result).items():
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(result, name, value)
        with pytest.raises(dataclasses.FrozenInstanceError):
            delattr(result, name)
        if isinstance(value, np.ndarray):
            assert not value.flags.writeable, name
            if value.size:
                with pytest.raises(ValueError, match="read-only"):
                    value[...] = value
        else:
            assert not isinstance(value, np.generic), name
    with pytest.raises(dataclasses.FrozenInstanceError):
        result.something_new = 1


def test_repr_is_a_line_that_says_the_essential(result):
    text = repr(result)
    assert text.startswith(type(result).__name__ + "(") and text.isprintable() and len(text) <= 250
    if hasattr(result, "restitution") and np.ndim(result.restitution) == 0:
        shown = float(text.partition("restitution ")[2].split()[0].rstrip(",)"))
        assert abs(shown - result.restitution) < 0.005
    assert str(result) == text or isinstance(result, (stoss.Fit, stoss.Calibration))  # whose text is what it writes


def test_identity_is_equality(result):
    assert result == result != copy.copy(result) and result != 1 and hash(result) == hash(result)


@pytest.mark.parametrize("protocol", [0, pickle.HIGHEST_PROTOCOL, None])
def test_copies_are_the_same(result, protocol):
    """None: a deep copy, without a pickle."""
    again = copy.deepcopy(result) if protocol is None else pickle.loads(pickle.dumps(result, protocol))
    assert alike(again.to_dict(), result.to_dict()) and repr(again) == repr(result)
    if hasattr(result, "trajectory"):
        assert again.trajectory().force.tobytes() == result.trajectory().force.tobytes()


def test_dict_is_plain(result):
    def is_plain(value):
        if type(value) is dict:
            return all(type(key) is str and is_plain(each) for key, each in value.items())
        return all(map(is_plain, value)) if type(value) is list else type(value) in (float, int, bool, str, type(None))

    got = result.to_dict()
    assert is_plain(got) and alike(json.loads(json.dumps(got)), got)
    assert all(name in got for name in ("speed_si", "max_force_si") if hasattr(result, name))


def test_read_csv_gives_back_what_to_csv_wrote(result, tmp_path):
    result.to_csv(tmp_path / "result.csv")
    table = stoss.read_csv(tmp_path / "result.csv")
    columns = result._columns()
    assert list(table) == list(columns) and table.version == stoss.__version__
    assert table.kind == result._name and table.size == min(column.size for column in columns.values())
    assert dict(table.inputs) == {key: " ".join(str(value).split()) for key, value in result._inputs().items()}
    for name, column in columns.items():
        if table.size:
            assert table[name].dtype.kind == column.dtype.kind, name
        assert alike(table[name].tolist(), column.ravel().tolist()), name
        assert table.units.get(name, "") == result._unit(name)
    with pytest.raises(ValueError, match="read-only"):
        table[list(table)[0]][...] = 0


def test_pandas(result):
    pytest.importorskip("pandas")
    frame = result.to_dataframe()
    columns = result._columns()
    assert list(frame.columns) == list(columns)
    for name, column in columns.items():
        assert alike(frame[name].tolist(), column.ravel().tolist())
    assert frame.attrs["units"] == {name: result._unit(name) for name in columns if result._unit(name)}


def test_xarray(result):
    pytest.importorskip("xarray")
    data = result.to_xarray()
    for name, column in result._columns().items():
        assert data[name].attrs.get("units", "") == result._unit(name)
        if name not in data.dims and not name.startswith("body_"):  # those of a sweep do not depend on the speed
            assert alike(data[name].values.ravel().tolist(), column.ravel().tolist()), name
    assert data.attrs == {key: str(value) for key, value in result._inputs().items()}


def test_notebooks_get_a_compact_escaped_table(result):
    text = result._repr_html_()
    assert text.count("<tr>") <= 12 and text.count("<table") == text.count("</table>") == 1 and len(text) < 20_000
