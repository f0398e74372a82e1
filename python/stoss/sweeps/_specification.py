"""Bodies and walls as plain mappings, which files hold and other processes take, and what they are called there."""

from __future__ import annotations

import itertools
import json
import os
import reprlib
from typing import Any, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import brief, instance, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import PARTNERS, Body
from stoss.bodies._material import Material, materials
from stoss.bodies._modal import ModalBody
from stoss.bodies._walls import WALLS as MADE_WALLS, ExponentialWall, HardWall, Layer
from stoss.bodies._faces import FACE, SMOOTH
from stoss.bodies._kinds import KINDS, Specification
from stoss.bodies._solid import Solid, describe
from stoss.export._files import of_json

SOLIDS: tuple[type[Solid], ...] = PARTNERS
CLASSES: Mapping[str, Any] = {name: made for name in KINDS for made in SOLIDS if made._kind == name}
WALLS: Mapping[str, Any] = {"wall": HardWall, "exponential": ExponentialWall, "same": None}

Choices = list[list[tuple[str, Any]]]
"""Of each key of a mapping all values that it is to have."""


def of_document(text: str) -> tuple[Any, Any]:
    """The body of an encounter's JSON document, and what it meets."""
    document = of_json(text)
    body, against = make("body", document["first"]), document.get("against", "wall")
    return body, beside({"kind": against} if isinstance(against, str) else against, body)


def make(name: str, given: Specification) -> Any:
    """The body that a mapping describes, which the core reads."""
    kind = given.get("kind")
    if not isinstance(kind, str) or kind not in CLASSES:
        raise refusal(f"{name}: kind", kind, ", ".join(CLASSES))
    if KINDS[kind].from_file:
        return _of_file(name, {key: each for key, each in given.items() if key != "kind"})
    try:
        text = json.dumps(given, default=_plain, allow_nan=False)
    except (TypeError, ValueError, RecursionError):
        raise refusal(name, given, "finite numbers, words and lists of them") from None
    try:
        words = _of_material(json.loads(_core.participant(name, text)))
    except InvalidInput as error:  # of a name that no material has the core says no more than that
        raise error if error.name.startswith(name) else error.renamed(f"{name}: {error.name}") from None
    if "layers" in words:
        words["layers"] = [Layer(**_of_material(each)) for each in words["layers"]]
    return CLASSES[words.pop("kind")](**words)


def _plain(given: Any) -> Specification:
    """What may be given as an object, in plain types."""
    if isinstance(given, Material):
        return given._words()
    return {name: each for name, each in describe(instance("layers", given, (Layer,))).items() if name != "kind"}


def _of_material(words: Specification) -> Specification:
    """The same with the material as an object: by its name in stoss.materials, or of its constants."""
    given = words.get("material")
    if given is None:
        return words
    return {**words, "material": materials[given] if isinstance(given, str) else Material(**given)}


def _of_file(name: str, words: Specification) -> ModalBody:
    """A body by its file, by its document, or as it is."""
    face = {key: each for key, each in words.items() if key in FACE}
    left = set(words) - set(face)
    if left == {"file"} and isinstance(words["file"], (str, os.PathLike)):
        return ModalBody.read(words["file"]).with_face(**face)
    if left != {"body"}:
        raise refusal(name, sorted(words), "kind and file, the name of a body's file, or kind and body, its document")
    given = words["body"]
    return (given if isinstance(given, ModalBody) else ModalBody.from_dict(given)).with_face(**face)


def with_folder(given: Any, folder: str) -> Any:
    """Bodies as a file in this folder names them: files of bodies are sought from there."""
    if isinstance(given, list):
        return [with_folder(each, folder) for each in given]
    if not isinstance(given, Mapping) or "file" not in given:
        return given
    files = given["file"]
    several = [os.path.join(folder, each) if isinstance(each, str) else each for each in _listed(files)]
    return {**given, "file": several if isinstance(files, (list, tuple)) else several[0]}


def _listed(given: Any) -> list[Any]:
    return list(given) if isinstance(given, (list, tuple)) else [given]


def beside(given: Specification, body: Body) -> Any:
    """What a mapping describes where it meets this body: what it leaves out is the body's."""
    kind = given["kind"]
    if kind == "same":
        return body
    if kind in WALLS:
        return WALLS[kind](**{name: value for name, value in given.items() if name != "kind"})
    words = dict(given)
    if kind in ("disk", "sphere") and "material" not in words and "poisson" in vars(body):
        words.setdefault("poisson", body.poisson)
    if kind in CLASSES and KINDS[kind].has_plane and "material" in words and getattr(body, "plane", None):
        words.setdefault("plane", body.plane)  # type: ignore[union-attr]
    return make("against", words)


def choices(name: str, given: Any) -> Choices:
    """What the lists and series in a mapping leave to choose; of an object or a word nothing."""
    if not isinstance(given, Mapping):
        return []
    return [[(key, each) for each in _choices(f"{name}: {_shown(key)}", key, value)] for key, value in given.items()]


def expanded(name: str, given: Any, left: Choices) -> Iterator[Specification]:
    """The mappings of an object, a word, or a mapping for which all combinations of its choices are left."""
    if isinstance(given, MADE_WALLS):
        yield of_wall(given)
        return
    if name == "against" and isinstance(given, str) and given in WALLS:
        yield {"kind": given}
    elif isinstance(given, PARTNERS):
        yield describe(given)
    elif isinstance(given, Mapping):
        for chosen in itertools.product(*left):
            one = dict(chosen)
            if _is_wall(name, one):
                yield _wall(name, one)
                continue
            made = make(name, {"poisson": 0.0, **one} if name == "against" and _borrows(one) else one)
            its, complete = describe(made), name != "against" or KINDS[made._kind].from_file
            # What a partner leaves out stays open until it is known whom it meets.
            yield its if complete else {**one, **{key: its[key] for key in ("material", "layers") if key in one}}
    else:
        walls = "'wall', 'same', " if name == "against" else ""
        raise refusal(name, given, f"{walls}a body, or a mapping with its kind")


def of_wall(wall: Any) -> Specification:
    """A wall in plain types."""
    its: str | Specification = wall._document()
    return {"kind": its} if isinstance(its, str) else its


def _wall(name: str, words: Specification) -> Specification:
    """A wall by its numbers, in range."""
    known = [each.name for each in KINDS[words["kind"]].parameters]
    for other in words:
        if other not in ("kind", *known):
            raise refusal(name, other, f"nothing besides {words['kind']}" + "".join(f", {each}" for each in known))
    if words["kind"] != "same":
        WALLS[words["kind"]](**{key: value for key, value in words.items() if key != "kind"})
    return words


def _shown(key: Any) -> str:
    """A key as it stands in a line of its own."""
    return key if isinstance(key, str) and len(key) <= 30 and key.isprintable() else reprlib.repr(key)


def _is_wall(name: str, words: Mapping[str, Any]) -> bool:
    return name == "against" and isinstance(words.get("kind"), str) and words["kind"] in WALLS


def _borrows(words: Specification) -> bool:
    return words.get("kind") in ("disk", "sphere") and "material" not in words


def _choices(name: str, key: str, value: Any) -> list[Any]:
    if key in ("layers", "body", "relaxation", "young_is"):
        return [value]
    if key in ("kind", "plane", "rigid", "material", "file"):
        return _listed(value)
    if isinstance(value, str):
        return list(_core.series(name, value))
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    return [_number(name, each) for each in value] if isinstance(value, (list, tuple)) else [_number(name, value)]


def _number(name: str, value: Any) -> float:
    allowed = "a number, a list of numbers, or a series"
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise refusal(name, value, allowed)
    try:
        return float(value)
    except OverflowError:
        raise refusal(name, value, allowed) from None


SI = {its.name: its.unit.replace("^", "") for each in KINDS.values() for its in each.parameters if its.unit}
"""Units of the numbers of bodies with a material."""


def label(words: Specification) -> str:
    """What a body or a partner is, in the manner of --against."""
    if KINDS[words["kind"]].from_file:
        return f"{words['kind']},{words['body'].get('name', '')}"
    usual = {each.name: each.otherwise for each in KINDS[words["kind"]].parameters}
    usual = {"loss_time": 0.0, **SMOOTH} if "material" in words else usual
    numbers = {name: value for name, value in words.items() if name != "kind" and usual.get(name) != value}
    layers = [_label(each) for each in numbers.pop("layers", [])]
    return "/".join([",".join(filter(None, (words["kind"], _label(numbers), *layers[:1]))), *layers[1:]])


def _label(numbers: Specification) -> str:
    plain = {name: value for name, value in numbers.items() if name != "material"}
    plain |= {f"material_{name}": value for name, value in numbers.get("material", {}).items()}
    return ",".join(f"{name}={brief(value)}" for name, value in plain.items())


def numbers_of_bodies(bodies: Sequence[Body]) -> dict[str, NDArray[np.float64]]:
    """Poisson's ratio, radius and so on of the first bodies; NaN of a body that has none."""
    names = {number.name for each in bodies for number in KINDS[each._kind].parameters}
    return {
        name: np.array([getattr(each, name, np.nan) for each in bodies], dtype=np.float64) for name in sorted(names)
    }


def unit_of_body(name: str, in_si: bool) -> str:
    """Unit of one of these numbers; "" of a pure one."""
    return SI.get(name, "") if in_si else ""
