"""Numbers as they come from users, made ready for the core. Ranges are the core's business."""

from __future__ import annotations

import operator
import os
import reprlib
import stat
from typing import Any, BinaryIO, Sequence

import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput


def refusal(name: str, value: object, allowed: str) -> InvalidInput:
    """The one line that says what is wrong."""
    try:
        got = reprlib.repr(value)
    except Exception:  # integers of thousands of digits, and foreign objects
        got = f"an object of type {type(value).__name__}"
    got = " ".join(got.split())
    return InvalidInput.out_of_range(name, got if len(got) <= 80 else got[:77] + "...", allowed)


def open_file(name: str, path: str | os.PathLike[str]) -> BinaryIO:
    """A file to read. Refuses what may never end or never begin: a FIFO by its name, a device."""
    text = os.fspath(path)
    is_open = isinstance(text, str) and text.startswith(("/dev/stdin", "/dev/fd/", "/proc/self/fd/"))
    mode = os.stat(text).st_mode
    if not (is_open or stat.S_ISREG(mode) or stat.S_ISDIR(mode)):  # of a folder opening says it
        raise InvalidInput.out_of_range(name, f"'{text}', which is no regular file", "a file", "or /dev/stdin")
    return open(text, "rb")


def numbers(name: str, value: Any) -> NDArray[np.float64]:
    """Any number, sequence or array of real numbers as doubles, contiguous, of the same shape."""
    try:
        array = np.asarray(value)
    except Exception:  # whatever a foreign object raises when it is asked for its numbers
        raise refusal(name, value, "a number or an array of numbers") from None
    if array.size == 0 and not isinstance(value, (str, bytes)) and array.dtype.kind in "iufO":
        return np.empty(array.shape)
    if array.dtype.kind not in "iuf" or isinstance(value, np.ma.MaskedArray):
        raise refusal(name, value, "a number or an array of numbers")
    return np.array(array, dtype=np.float64, order="C")


def number(name: str, value: Any) -> float:
    """One real number."""
    if type(value) is float:  # the usual case, fast
        return value
    array = numbers(name, value)
    if array.ndim != 0:
        raise refusal(name, value, "one number")
    return float(array)


def brief(value: Any) -> str:
    """The shortest text that is the same number; of other things the usual one."""
    text = f"{value:g}" if isinstance(value, float) else repr(value)
    return text if not isinstance(value, float) or float(text) == value else repr(value)


def optional_number(name: str, value: Any) -> float | None:
    """One real number or None."""
    return None if value is None else number(name, value)


def integer(name: str, value: Any) -> int:
    """One integer that fits in 32 bits."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        result = operator.index(value)
    except Exception:
        raise refusal(name, value, "an integer") from None
    if not -(2**31) <= result < 2**31:
        raise refusal(name, value, "an integer of moderate size")
    return result


def boolean(name: str, value: Any) -> bool:
    """True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise refusal(name, value, "True or False")
    return bool(value)


def flags(name: str, value: Any) -> NDArray[np.bool_]:
    """A one-dimensional array of True and False, copied and read-only."""
    try:
        array = np.asarray(value)
    except Exception:  # whatever a foreign object raises when it is asked for its elements
        array = np.empty(0)
    if array.dtype.kind != "b" or array.ndim != 1 or isinstance(value, np.ma.MaskedArray):
        raise refusal(name, value, "a one-dimensional array of True and False")
    array = np.array(array, dtype=np.bool_, order="C")
    array.flags.writeable = False
    return array


def choice(name: str, value: Any, allowed: Sequence[str]) -> str:
    """One of a few words."""
    if not isinstance(value, str) or value not in allowed:
        *others, last = (repr(each) for each in allowed)
        raise refusal(name, value, f"{', '.join(others)} or {last}")
    return value


LARGEST = 2e9
"""Bytes that the arrays of one result may take."""


def require_memory(name: str, got: str, size: float, hint: str) -> None:
    """Refuse, before anything is allocated, a result of more than `LARGEST` bytes."""
    if size > LARGEST:
        raise InvalidInput.out_of_range(name, f"{got}, {size / 1e9:.3g} GB", f"{LARGEST / 1e9:g} GB", hint)


def broadcast(values: int = 1, /, **arrays: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Copy the arrays in the shape to which they broadcast, for a result of so many values each."""
    try:
        views = np.broadcast_arrays(*arrays.values())
    except ValueError:
        shapes = " and ".join(str(each.shape) for each in arrays.values())
        hint = "shapes that broadcast together"
        raise InvalidInput.out_of_range(", ".join(arrays), f"shapes {shapes}", hint) from None
    got = f"shape {views[0].shape}, {values} values each"
    size = 8.0 * views[0].size * (values + len(views))
    require_memory(", ".join(arrays), got, size, "compute them in parts")
    return [np.array(each, order="C") for each in views]


def arranged(values: NDArray[Any], shape: tuple[int, ...]) -> Any:
    """A read-only array of this shape, or one plain value."""
    values = values.reshape(shape)
    values.flags.writeable = False
    return values if values.ndim else values.item()


def instance(name: str, value: Any, kinds: tuple[type, ...]) -> Any:
    """An object of one of these classes."""
    if not isinstance(value, kinds):
        raise refusal(name, value, " or ".join(f"a stoss.{kind.__name__}" for kind in kinds))
    return value
