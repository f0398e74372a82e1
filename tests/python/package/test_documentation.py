"""help() explains every parameter of the public functions, and shared words are not said twice."""

import inspect
import re

import pytest

import stoss
import stoss.plot
from stoss import _documentation

FUNCTIONS = {
    f"{module.__name__}.{name}": getattr(module, name)
    for module in (stoss, stoss.quasistatic, stoss.plot)
    for name in module.__all__
    if inspect.isfunction(getattr(module, name))
}


def explained(said):
    section = re.search(r"^Parameters:\n((?:    .*\n?)+)", inspect.cleandoc(said), re.MULTILINE)
    entries = re.findall(r"^    (\S[^:(]*)", section[1] if section else "", re.MULTILINE)
    return [name for entry in entries for name in re.findall(r"\w+", entry)]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_parameter_is_explained_once(name):
    function = FUNCTIONS[name]
    names = explained(function.__doc__)
    assert set(inspect.signature(function).parameters) <= set(names)
    assert len(names) == len(set(names))


def test_types_come_from_annotations_and_own_words_come_first():
    @_documentation.documented
    def made(  # names without a meaning: only their words count
        body: "Body | None" = None,  # noqa: F821
        *,
        speed: "ArrayLike",  # noqa: F821
        threads: "int" = 0,
        **style: "Any",  # noqa: F821
    ) -> None:
        """Make it.

        Parameters:
            speed: One's own, which a shorter
                line continues.

        Examples:
            >>> 1
            1
        """

    assert made.__doc__ == (
        "Make it.\n\nParameters:\n"
        "    body (Disk, Sphere, Rod or ModalBody, optional): The first body, in whose units all results are.\n"
        "    speed (array_like): One's own, which a shorter line continues.\n"
        "    threads (int, optional): 0: as many as the machine has. Results do not depend on it.\n"
        "    **style: Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …\n\n"
        "Examples:\n    >>> 1\n    1"
    )


def test_fields_have_the_words_of_their_base():
    class Base:
        """A base.

        Attributes:
            law: Of its own.
        """

        law: "str"

    class Made(Base):
        """It is made."""

        law: "str"
        restitution: "Number"  # noqa: F821
        restitution_error: "Number"  # noqa: F821

    _documentation.with_fields(Made)
    assert "    law (str): Of its own.\n" in Made.__doc__
    assert "    restitution, restitution_error (float or ndarray): ε = " in Made.__doc__
