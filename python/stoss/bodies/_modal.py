"""Any body by its modes at the point where it is struck, as finite elements give them."""

from __future__ import annotations

import dataclasses
import json
import os
from typing import Any, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import number, numbers, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._material import Material
from stoss.bodies._modal_file import read_document, write_document
from stoss.bodies._faces import FACE, face_of
from stoss.bodies._kinds import Specification
from stoss.bodies._solid import Solid

FORMAT = "stoss modal body 1"
NUMBERS = ("mass", "young", "poisson", "density", "compliance", "loss_time", "compliance_error", "complete_to")
ALONG = ("tangential_displacement", "tangential_displacement_curvature", "tangential_displacement_error")
LISTS = ("frequency", "displacement", "displacement_curvature", "frequency_error", "displacement_error", *ALONG)
TANGENT = ("direction", "compliance", "compliance_error", "mass", "inertia", "arm", "cross")
NESTED = {"modes": LISTS, "rotation": ("inertia", "point", "normal"), "tangent": TANGENT}


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False, eq=False)
class ModalBody(Solid):
    """Any elastic body that is struck at one smooth point: its modes there and one static number, in SI.

    Near the point it is a half-space with the mean curvature H of the surface. Pushed into it by a
    unit force, and relative to its rigid motion, the surface moves at the distance r by

        G(r) = (1 − ν²)/(πE) [1/r − g H ln(Hr)] + c₀ + O(r),   g = (1 − 2ν)²/(2(1 − ν)),

    of which the modes are a part: c₀ is all that the shape of the body adds. It meets what spheres
    meet, with a material. In results R is 1/H, of a plane point the edge of a cube of its mass.

    Parameters:
        mass (float): Mass, kg.
        curvature (float or tuple of two float): Principal curvatures at the point, 1/m; 0: a plane.
            One may be below 0, where the surface is a saddle, their sum not.
        young, poisson, density (float): Material at the point: E in Pa, ν, ρ in kg/m³.
        compliance (float): c₀, m/N.
        frequency (array_like): Frequencies of the elastic modes that move the point, Hz, rising.
        displacement (array_like): Along the outward normal at the point, kg^(−1/2), of each mode with
            ∫ρ|u|² dV = 1.
        displacement_curvature (array_like, optional): χ, kg^(−1/2) m⁻²: at the distance r from the
            point the displacement is φ + χr², all around on average. Without it wide contacts are
            refused, and the error is larger.
        frequency_error, displacement_error (array_like, optional): Errors, which enter those of
            results; 0.
        compliance_error (float, optional): Error of c₀; 0.
        complete_to (float, optional): Frequency in Hz up to which no mode is missing; the highest.
        loss_time (float, optional): η of the whole body, s; 0.
        held (bool, optional): Whether clamps or springs keep it from moving as a whole: its modes, from
            the lowest on, carry all that the point does, and c₀ is that against what holds it; False.
        rotation (mapping, optional): Where the line of the blow misses the centre of mass: `inertia`
            about it, 3 × 3, kg m², `point` of contact from there, m, and its outward `normal`.
        tangent (mapping, optional): What friction along one direction asks of the body: `direction`, in
            the plane of impact; its static `compliance` there as c₀, c_t in m/N, and `compliance_error`.
            Without `rotation` also `inertia` and `arm` of the round body as which it turns, kg m² and m,
            both 0 if it does not. Without a tangent friction is refused, as it is where a mode moves the
            point along the normal and along the surface at once.
        tangential_displacement (array_like, optional): Displacement of each mode along that direction, kg^(−1/2).
        tangential_displacement_curvature, tangential_displacement_error (array_like, optional): As above.
        roughness, u0, coat, coat_young, coat_poisson, coat_quality (float, optional): How rough its face is, and
            its coat, as of other bodies, in m and Pa; not in its file.
        yield_strength, yield_hardening, yield_rate (float, optional): From which stress on it yields, Pa; not in its file.
        name, origin (str, optional): What it is, and where its numbers come from.
        material (Material): Not to be given: that of `young`, `poisson` and `density`.

    Examples:
        >>> bar = stoss.ModalBody(
        ...     mass=0.0785, curvature=0, young=2.1e11, poisson=0.3, density=7850, compliance=5e-8,
        ...     frequency=[5319], displacement=[7.14], complete_to=5319, name="bar",
        ... )
        >>> bar
        ModalBody('bar', 1 mode to 5319 Hz)
        >>> bar.save("bar.json")
        >>> stoss.ModalBody.read("bar.json") == bar
        True
    """

    _kind = "modal"

    mass: float
    curvature: float | tuple[float, float]
    young: float
    poisson: float
    density: float
    compliance: float
    frequency: NDArray[np.float64]
    displacement: NDArray[np.float64]
    displacement_curvature: NDArray[np.float64] | None = None
    frequency_error: NDArray[np.float64] | None = None
    displacement_error: NDArray[np.float64] | None = None
    compliance_error: float = 0.0
    complete_to: float | None = None
    loss_time: float = 0.0
    held: bool = False
    rotation: Mapping[str, Any] | None = None
    tangent: Mapping[str, Any] | None = None
    tangential_displacement: NDArray[np.float64] | None = None
    tangential_displacement_curvature: NDArray[np.float64] | None = None
    tangential_displacement_error: NDArray[np.float64] | None = None
    roughness: float = 0.0
    u0: float = 0.0
    coat: float = 0.0
    coat_young: float = 0.0
    coat_poisson: float = 0.3
    coat_quality: float = 0.0
    yield_strength: float = 0.0
    yield_hardening: float = 0.0
    yield_rate: float = 0.0
    name: str = "modal body"
    origin: str = ""

    def __post_init__(self) -> None:
        made: dict[str, Any] = {}
        for name in LISTS:
            given = getattr(self, name)
            needed = name in ("frequency", "displacement")
            made[name] = _fixed(name, given) if needed or given is not None else None
        count = made["frequency"].size
        for name in ("frequency_error", "displacement_error"):
            made[name] = _fixed(name, np.zeros(count)) if made[name] is None else made[name]
        highest = made["frequency"][-1] if count else None
        for name in FACE:
            made[name] = number(name, getattr(self, name))
        for name in NUMBERS:
            given = getattr(self, name)
            if name != "complete_to" or given is not None or highest is None:
                made[name] = _finite(name, number(name, given))
        made.setdefault("complete_to", None if highest is None else float(highest))
        bends = _finite("curvature", numbers("curvature", self.curvature))
        if bends.shape not in ((), (2,)):
            raise refusal("curvature", self.curvature, "one number or two in 1/m (0: a plane)")
        made["curvature"] = float(bends) if bends.ndim == 0 else (float(bends[0]), float(bends[1]))
        for name, needs in (("rotation", "inertia, point and normal"), ("tangent", "direction and compliance")):
            given = getattr(self, name)
            if given is None:
                continue
            if not isinstance(given, Mapping):
                raise refusal(name, given, f"a mapping with {needs}")
            made[name] = {str(inner): _inner(name, str(inner), each) for inner, each in given.items()}
        if not isinstance(self.held, (bool, np.bool_)):
            raise refusal("held", self.held, "True or False")
        made["held"] = bool(self.held)
        for name in ("name", "origin"):
            if not isinstance(getattr(self, name), str):
                raise refusal(name, getattr(self, name), "a text")
        for name, value in made.items():
            object.__setattr__(self, name, value)
        object.__setattr__(self, "_text", json.dumps(self.to_dict(), sort_keys=True))
        _require(self.to_dict())
        _core.check_face(self.roughness, self.u0)
        lossy = self.loss_time or None
        material = Material(young=self.young, poisson=self.poisson, density=self.density, loss_time=lossy)
        object.__setattr__(self, "material", material)

    def __repr__(self) -> str:
        count, highest = self.frequency.size, f" to {self.frequency[-1]:.6g} Hz" if self.frequency.size else ""
        return f"ModalBody({self.name!r}, {count} mode{'s' * (count != 1)}{highest})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ModalBody) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[str, frozenset[tuple[str, float]]]:
        return vars(self)["_text"], frozenset(face_of(self).items())

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.to_dict(), face_of(self))

    def to_dict(self) -> dict[str, Any]:
        """Return the document of the body in plain types, as its JSON file has it."""
        kept = {name: getattr(self, name) for name in ("name", "origin", *NUMBERS) if getattr(self, name) != ""}
        shape = list(self.curvature) if isinstance(self.curvature, tuple) else self.curvature
        modes = {name: getattr(self, name).tolist() for name in LISTS if getattr(self, name) is not None}
        known = {name: each for name, each in kept.items() if each is not None}
        known |= {"held": True} if self.held else {}
        nested = {name: getattr(self, name) for name in ("rotation", "tangent") if getattr(self, name) is not None}
        plain = {name: {key: np.asarray(each).tolist() for key, each in its.items()} for name, its in nested.items()}
        return {"format": FORMAT, **known, "curvature": shape, **plain, "modes": modes}

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> ModalBody:
        """Make a body of its document, as `to_dict` returns it or its JSON file has it."""
        if not isinstance(given, Mapping):
            raise refusal("body", given, "a mapping, as a file of a body has it")
        try:
            words: dict[str, Any] = json.loads(json.dumps(given, allow_nan=False))
        except (TypeError, ValueError, RecursionError):
            raise refusal("body", given, "numbers, lists and texts, all finite") from None
        _require(words)
        modes = words.pop("modes")
        del words["format"]
        return cls(**words, **modes)

    @classmethod
    @documented
    def read(cls, path: str | os.PathLike[str]) -> ModalBody:
        """Read a body from a JSON file, or from an NPZ file with the same keys.

        In an NPZ file numbers and texts are arrays without a dimension, and what is nested has both
        names, joined by an underscore or a point: `modes_frequency`, `rotation_inertia`.

        Parameters:
            path: A file that is a ZIP archive is read as NPZ.
        """
        try:
            return cls.from_dict(read_document(path, NESTED))
        except InvalidInput as error:
            raise error.renamed(f"{os.fspath(path)}: {error.name}") from None

    @documented
    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file that `read` reads: NPZ if its name ends in .npz, else JSON.

        The command and the page read JSON only. The file appears whole or not at all.

        Parameters:
            path:
        """
        write_document(path, self.to_dict(), NESTED)

    def off_by_errors(self) -> tuple[ModalBody, ...]:
        """Return it with c₀, then with all frequencies, then with all displacements off by their errors."""
        bodies = [self.to_dict() for _ in range(3)]
        bodies[0]["compliance"] += self.compliance_error
        bodies[1]["modes"]["frequency"] = np.sort(self.frequency + np.asarray(self.frequency_error)).tolist()
        moved = self.displacement + np.copysign(np.asarray(self.displacement_error), self.displacement)
        bodies[2]["modes"]["displacement"] = moved.tolist()
        if self.held:  # what the modes leave of c₀ stays
            for each in bodies[1:]:
                off, own = (np.asarray(its["displacement"]) / np.asarray(its["frequency"]) for its in (each["modes"], self.to_dict()["modes"]))
                each["compliance"] += float(off @ off - own @ own) / (2.0 * np.pi) ** 2
        return tuple(_again(each, face_of(self)) for each in bodies)

    def with_face(self, **face: float) -> ModalBody:
        """Return it with another roughness or coat: `roughness`, `u0`, `coat` …; without any, as it is."""
        return _again(self.to_dict(), {**face_of(self), **face}) if face else self

    def _numbers(self) -> Specification:
        return {"kind": self._kind, "body": json.loads(vars(self)["_text"]), **face_of(self)}

    def _numbers_at_wall(self) -> Specification:
        return self._numbers()


def _again(document: Mapping[str, Any], face: Mapping[str, Any]) -> ModalBody:
    """The body of a document, with what says how rough its face is."""
    words = {name: each for name, each in document.items() if name not in ("format", "modes")}
    return ModalBody(**words, **document["modes"], **face)


def _finite(name: str, value: Any) -> Any:
    if not np.all(np.isfinite(value)):
        raise refusal(name, value, "finite numbers")
    return value


def _fixed(name: str, given: ArrayLike, most: int = 1) -> NDArray[np.float64]:
    """A read-only copy of a list, or of what has so many dimensions."""
    array = _finite(name, numbers(name, given))
    if not 1 <= array.ndim <= most:
        raise refusal(name, given, "a list of numbers")
    array.flags.writeable = False
    return array  # type: ignore[no-any-return]


def _inner(where: str, name: str, given: Any) -> Any:
    """A number of a tangent, or a list."""
    if where == "tangent" and name != "direction":
        return _finite(name, number(f"tangent {name}", given))
    return _fixed(name, given, 2)


def _require(document: Specification) -> None:
    """Refuse what the core refuses of a body."""
    try:
        _core.encounter(json.dumps({"first": {"kind": "modal", "body": document}}))
    except InvalidInput as error:
        raise error.renamed(error.name.removeprefix("first ").removeprefix("body ")) from None
