"""What docstrings have in common, said once: the words of parameters and of fields, by their names.

A docstring explains what is its own. `documented` adds the usual words of a function's other
parameters, `with_fields` those of a class's other fields, and types from their annotations, so that
help() and the site have all.
"""

from __future__ import annotations

import inspect
import re
import textwrap
from typing import Any, Callable, Mapping, TypeVar

Function = TypeVar("Function", bound=Callable[..., Any])

PARAMETERS = {
    "body": "The first body, in whose units all results are.",
    "speed": "Speed of approach of the centres of mass, or towards the wall, 1e-8 to 1, c (with a material: m/s). Equal"
    " bodies at twice the speed rebound as one of them from a rigid wall.",
    "against": "What the body meets: a rigid wall ('wall', the default), another wall, an identical body ('same'), another of its"
    " kind, or, for a sphere, a half-space or a plate, for a disk a half-plane or a strip.",
    "poisson": "In place of `body`: 2-D Poisson's ratio of a disk, −0.95 to 0.995; an array broadcasts.",
    "cutoff": "Highest frequency of the modes that are kept, c/R.",
    "step": "Time step, R/c.",
    "nodes": "Number of points of the contact grid.",
    "half_width": "Half the width of the contact grid, R.",
    "tail": "How the modes above the cutoff answer: 'radiating', with static compliance at low and plane-wave"
    " impedance at high frequency, 'static', with static compliance only, or of rough faces 'none', not at all.",
    "state": "How the bodies vibrate before the impact: modes up to `cutoff`, or an array as `Impact.state_after` gives"
    " it. Default: they are unexcited. Then ε cannot exceed 1; with a state it may.",
    "error": "Maximum error of ε, interpolation included, 1e-7 to 0.1.",
    "tolerance": "Relative error of 1 − ε², 1e-15 to 0.5.",
    "absolute": "Error of 1 − ε² that is small enough in any case, 0 to 0.5: a slow sphere loses little.",
    "seed": "Each seed gives another ensemble.",
    "threads": "0: as many as the machine has. Results do not depend on it.",
    "progress": "Show on stderr a bar of the values, or where they cannot be counted for how long it has gone on.",
    "law": "Law of compression: 'center', 'diameter' or 'hertz', see `stoss.quasistatic`.",
    "force": "F, mc²/R; broadcasts with the other arrays.",
    "time": "R/c from the start of the impact, any order; during the impact the nearest step is taken.",
    "path": "File to write; an existing one is replaced.",
    "store": "Directory of the values of a sweep.",
    "mix": "Take values of other versions of stoss too, where this one has none, and leave out those of other grids."
    " Without it such a store is refused.",
    "of": "The body that is meant: 0 the first, 1 the second.",
    "order": "Angular order n of a disk, degree n of a sphere; of a rod 0.",
    "index": "Number l of the mode among those of its order, from 0.",
    "frame": "Number of the instant, if the field has several.",
    "columns": "Pictures in a row.",
    "ax": "Where to draw; further calls with the same Axes add to it. Default: a new figure.",
    "label": "Name of the curve in the legend.",
}

STYLE = "**style: Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …"

FIELDS = {
    "body": "The first; all units are its own.",
    "against": "What it meets.",
    "poisson": "Poisson's ratio, of a disk the 2-D one.",
    "speed": "Speed of approach of the centres of mass, or towards the wall, c.",
    "restitution": "ε = −v_f/v_i of the relative motion; above 1 where vibration is given back.",
    "cutoff": "Modes up to this frequency are kept, c/R.",
    "tail": "How the modes above the cutoff answered: 'radiating', 'static' or 'none'.",
    "reason": "Why it is not converged; empty where it is.",
    "keep": "Which modes up to the cutoff were kept, if not all.",
    "state": "How the bodies vibrated before, if they did: a structured array with the fields body, order, index,"
    " energy (as a share of the translational one) and phase.",
    "beyond": "Answer beyond its range: 'error', 'clamp' or, where there is one, 'law'.",
    "tolerance": "Asked for: error of 1 − ε² over 1 − ε².",
    "absolute": "Alternative to it: absolute error of 1 − ε².",
    "decay_time": "Time in which vibrational energies fall in flight, as given.",
    "seed": "Seed of the random numbers of the ensemble.",
    "law": "Law of compression.",
    "impact": "The impact that it is a part of.",
    "compression": "δ = R + x₀, R.",
}

TYPES = {
    "ComputedImpact": "Impact",
    "Number": "float | ndarray",
    "Integer": "int | ndarray",
    "Flag": "bool | ndarray",
    "ArrayLike": "array_like",
    "Body": "Disk | Sphere | HollowSphere | Rod | ModalBody",
    "Unbounded": "HalfSpace | HalfPlane | Plate | Strip",
    "Standing": "HardWall | HalfSpace | HalfPlane | Plate | Strip",
    "Against": "HardWall | ExponentialWall | Disk | Sphere | HollowSphere | Rod | ModalBody | "
    "HalfSpace | HalfPlane | Plate | Strip",
    "State": "Oscillation | sequence of them | ndarray",
    "os.PathLike[str]": "path",
}


def documented(function: Function, **own: str) -> Function:
    """Add types, and these or the usual words of all parameters that a docstring does not explain."""
    if function.__doc__:
        given = inspect.signature(function).parameters
        typed = {name: each for name, each in given.items() if each.annotation is not each.empty}
        types = {name: _type(each.annotation, each.default) for name, each in typed.items()}
        words = {name: f"{name}: {said}" for name, said in (PARAMETERS | own).items()} | {"style": STYLE}
        function.__doc__ = _completed(function.__doc__, "Parameters", types, words)
    return function


def with_fields(made: type, title: str = "Attributes") -> None:
    """Add types, and the words of a base or the usual ones of all fields that a docstring does not explain."""
    fields, words = vars(made).get("__annotations__", {}), dict[str, str]()
    for name in [name for name, kind in fields.items() if name in FIELDS and kind != "Any"]:
        words[name] = f"{name}: {FIELDS[name]}"
        if f"{name}_error" in fields:
            words[name] = f"{name}, {name}_error: {FIELDS[name][:-1]}; and its estimated error."
    for base in reversed(made.__mro__[1:]):
        words |= _own(base.__doc__ or "", title)
    if made.__doc__:
        kinds = dict(fields)
        for base in made.__mro__[1:]:
            kinds |= {name: kind for name, kind in vars(base).get("__annotations__", {}).items() if name not in kinds}
        types = {name: _type(kind) for name, kind in kinds.items()}
        made.__doc__ = _completed(made.__doc__, title, types, words)


def _type(annotation: str, default: Any = inspect.Parameter.empty) -> str:
    """What an annotation says, in words; where there is a default it is optional."""
    written = re.sub(r"NDArray\[[\w.]*\]", "ndarray", annotation.removesuffix(" | None" if default is None else ""))
    kinds = [kind for each in written.split(" | ") for kind in TYPES.get(each, each).split(" | ")]
    kind = " or ".join(filter(None, [", ".join(kinds[:-1]), kinds[-1]]))
    return kind if default is inspect.Parameter.empty else f"{kind}, optional"


def _sections(said: str) -> list[str]:
    """What a docstring begins with, and its sections."""
    return re.split(r"\n\n(?=(?:Attributes|Examples|Parameters|Raises|Returns):\n)", inspect.cleandoc(said))


def _own(said: str, title: str) -> dict[str, str]:
    """The entries of the section with this title, if there is one, by the names that each explains."""
    section = next((each for each in _sections(said) if each.startswith(f"{title}:\n")), "")
    entries = re.split(r"\n(?=\S)", textwrap.dedent(section.partition("\n")[2]))
    return {name: each for each in entries for name in re.split(r"[:(]", each)[0].strip(" *").split(", ") if name}


def _completed(said: str, title: str, types: Mapping[str, str], words: Mapping[str, str]) -> str:
    """The docstring, where a section explains these names in their order: as it does itself, or by the usual words."""
    own = _own(said, title)
    entries: dict[str, str] = {}
    for name, kind in {**types, **{name: types.get(name, "") for name in own}}.items():
        if each := own.get(name) or words.get(name, ""):
            entries.setdefault(each, kind)
    lines = [_line(each, kind) for each, kind in entries.items()]
    before, *others = (each for each in _sections(said) if not each.startswith(f"{title}:\n"))
    return "\n\n".join([before, *(["\n".join([f"{title}:", *lines])] if lines else []), *others])


def _line(entry: str, kind: str) -> str:
    """An entry with its type, unless it says one."""
    names, colon, said = entry.partition(":")
    typed = names if "(" in names or not kind or kind == "Any" else f"{names} ({kind})"
    fixed = "\u00a0"  # Sphinx reads the types on one line only
    text = " ".join([" ".join(typed.split()).replace(" ", fixed) + colon, *said.split()])
    filled = textwrap.fill(text, 100, initial_indent=" " * 4, subsequent_indent=" " * 8, break_long_words=False,
                           break_on_hyphens=False)  # fmt: skip
    return filled.replace(fixed, " ")
