"""Writes the stubs of an installed package, or of one that is being built: `python stubs.py FOLDER`.

Those of stoss._core are what pybind11 says of its functions; those of results and of bodies follow from the core's
tables of quantities and of kinds.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

HEAD = """from typing import Any, Callable, Sequence, TypeAlias

import numpy as np
from numpy.typing import NDArray

_Array: TypeAlias = NDArray[np.float64]
_Table: TypeAlias = NDArray[Any]

quantities: dict[str, tuple[tuple[str, str, bool, str, str], ...]]
version: str
"""

TYPES = (  # what pybind11 writes, and what that is in a stub
    (r"stoss\._core\.", ""), (r"numpy\.ndarray\[numpy\.float64\]", "_Array"),
    (r"numpy\.ndarray\[bool\]", "NDArray[np.bool_]"), (r"numpy\.ndarray(\[[\w.:]*\])?", "_Table"),
    (r"\[\d+\]", ""), (r"\bfunction\b", "Callable[[], None]"), (r"Optional\[(.*)\]$", r"\1 | None"),
    (r"Dict\[", "dict["), (r"Tuple\[", "tuple["), (r"\bdict$", "dict[str, Any]"), (r"\blist$", "list[Any]"),
    (r"\btuple$", "tuple[Any, ...]"),
)  # fmt: skip


def _type(written: str, given: bool) -> str:
    for pattern, meant in TYPES:
        written = re.sub(pattern, meant, written)
    return re.sub(r"List\[", "Sequence[" if given else "list[", written)


def _function(name: str, said: str, indent: str = "") -> str:
    """A function by the first line of its docstring, as `name(first: type, …) -> type`."""
    found = re.match(r"\w+\((.*)\) -> (.*)", said)
    assert found, f"{name}: {said}"
    own = []
    for each in re.split(r", (?=\w+: )", found[1]) if found[1] else []:
        word, _, kind = each.partition(": ")
        kind, equals, usual = kind.partition(" = ")
        own.append("self" if word == "self" else f"{word}: {_type(kind, True)}{equals}{usual}")
    return f"{indent}def {name}({', '.join(own)}) -> {_type(found[2], False)}: ..."


def of_core(core: Any) -> str:
    """The stub of the compiled module."""
    classes, others = list[str](), list[str]()
    for name, each in sorted(vars(core).items()):
        if isinstance(each, type):
            classes += ["", f"class {name}:"]
            own = {inner: of for inner, of in vars(each).items() if not inner.startswith("_")}
            for inner, of in own.items():
                if isinstance(of, property):
                    kind = str(of.fget.__doc__).strip().rpartition(" -> ")[2]
                    classes += ["    @property", f"    def {inner}(self) -> {_type(kind, False)}: ..."]
                else:
                    classes.append(_function(inner, of.__doc__, "    "))
            classes += [] if own else ["    ..."]
        elif type(each).__name__.startswith("dtype"):
            others.append(f"{name}: np.dtype[Any]")
        elif callable(each) and not name.startswith("_"):
            others.append(_function(name, each.__doc__))
    return "\n".join([HEAD, *others, *classes, ""])


def of_quantities(quantities: Any) -> str:
    """The stub of the classes of results that follow from the tables."""
    lines = [
        "import dataclasses", "from typing import Any, ClassVar, Mapping, NamedTuple, Union", "", "import numpy as np",
        "from numpy.typing import NDArray", "", "Number = Union[float, NDArray[np.float64]]",
        "Integer = Union[int, NDArray[np.int64]]", "Flag = Union[bool, NDArray[np.bool_]]",
        "Name = Union[str, NDArray[np.object_]]", "", "class Quantity(NamedTuple):",
        "    name: str", "    dimension: str", "    has_error: bool", "    help: str", "    type: str",
        "    @property", "    def columns(self) -> tuple[str, ...]: ...", "",
        "TABLES: Mapping[str, tuple[Quantity, ...]]", "QUANTITIES: Mapping[str, Mapping[str, str]]", "",
        "class Si(property):", "    def __init__(self, said: str) -> None: ...",
        "    def __set_name__(self, owner: type, name: str) -> None: ...",
        "    def __get__(self, result: Any, owner: type | None = None, /) -> Number: ...",
    ]  # fmt: skip
    for name, made in quantities.CLASSES.items():
        lines += ["", "@dataclasses.dataclass(frozen=True, eq=False, repr=False, kw_only=True)", f"class {name}:"]
        lines += ["    _kind: ClassVar[str]", *(f"    {field}: {kind}" for field, kind in made.types().items())]
        lines += [f"    {si}: ClassVar[Si]" for si in made.si_values()]
    return "\n".join([*lines, ""])


def of_solids(solids: Any, fields_of: Any, kinds: Any) -> str:
    """The stub of the classes of bodies that follow from the table of kinds."""
    lines = ["import dataclasses", "from typing import ClassVar", "", "from stoss.bodies._material import Material, Relaxation",
             "from stoss.bodies._solid import Endless, Solid"]  # fmt: skip
    for name, each in vars(solids).items():
        if getattr(each, "__module__", "") == solids.__name__:
            lines += ["", "@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)"]
            lines += [f"class {name}({each.__base__.__name__}):", "    _kind: ClassVar[str]"]
            lines += [f"    {field}: {kind} = ..." for field, kind in fields_of(kinds[each._kind]).items()]
    return "\n".join([*lines, ""])


def of_package(modules: Any) -> str:
    """The stub of the package, which imports what it has when that is asked for."""
    lines = ["from stoss import plot as plot, quasistatic as quasistatic", "from stoss.plot import animate as animate"]
    for module, names in modules.items():
        lines.append(f"from stoss.{module} import {', '.join(f'{name} as {name}' for name in names.split())}")
    return "\n".join([*lines, "", "__version__: str", ""])


def stubs() -> dict[str, str]:
    """All of them, by their places in the package that can be imported."""
    import stoss
    from stoss import _core
    from stoss.bodies import _kinds, _solids
    from stoss.results import _quantities

    return {
        "__init__.pyi": of_package(stoss._MODULES),
        "_core.pyi": of_core(_core),
        "bodies/_solids.pyi": of_solids(_solids, _kinds.fields_of, _kinds.KINDS),
        "results/_quantities.pyi": of_quantities(_quantities),
    }


if __name__ == "__main__":
    folder = Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(folder))
    for name, text in stubs().items():
        (folder / "stoss" / name).write_text(text, encoding="utf-8")
