"""Any body by its modes at the point where it is struck, as finite elements give them."""

from __future__ import annotations

import dataclasses
import json
import os
from typing import Any, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._material import Material
from stoss.bodies._faces import face_of
from stoss.bodies._modal_file import read_document, write_document
from stoss.bodies._modal_numbers import FORMAT, LISTS, NESTED, NUMBERS, ready, require
from stoss.bodies._kinds import Specification
from stoss.bodies._solid import Solid



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
        for name, value in ready(self).items():
            object.__setattr__(self, name, value)
        object.__setattr__(self, "_text", json.dumps(self.to_dict(), sort_keys=True))
        require(self.to_dict())
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
        require(words)
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
