"""What is no number, no whole number, no flag: for tests of what is refused."""

import numpy as np

nan, inf = float("nan"), float("inf")


class Broken:
    """Everything that can be asked of it raises."""

    def _raise(self, *_):
        raise ZeroDivisionError("broken")

    __array__ = __float__ = __index__ = __len__ = __getitem__ = __iter__ = __repr__ = __str__ = __eq__ = _raise
    __hash__ = None


class array:  # reprlib knows how to show the real one
    pass


NUMBERS = [  # of what no number can be made
    "0.1", "", b"1", True, np.True_, [True], 1j, [0.1, "x"], [[0.1], [0.1, 0.2]], {}, {1: 2}, {0.1}, object(),
    Broken(), [Broken()], array(), 10**5000, [10**400], np.array([0.1], dtype=object), np.ma.array([0.1], mask=[True]),
    slice(3), np.datetime64("2020"), np.zeros(2, dtype="f8,i4"), float, Ellipsis, lambda: 0.1, iter(()), None,
]  # fmt: skip
SEVERAL = [[1.0], [], np.ones((1, 1))]  # where one number is taken
INTEGERS = [0.5, 16.0, nan, "16", True, [16], 10**10, -(10**5000), Broken(), np.array([16, 17]), object(), None]
FLAGS = [1, 0, None, "yes", [], Broken()]
WORDS = ["", "Center", 1, ["center"], Broken()]
BODIES = ["disk", 0.3, [0.3], float, Broken()]
