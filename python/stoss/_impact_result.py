"""What one impact at a fixed resolution gives."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core, _replay
from stoss._bodies import PARTNERS, Body, Rod, shown
from stoss._contact import Against, contact, radiates
from stoss._field import Field
from stoss._result import Number
from stoss._si import InSiOfAnImpact
from stoss._trajectory import Trajectory
from stoss._wave import Wave


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Impact(InSiOfAnImpact):
    """One impact at a fixed resolution, with the inputs that made it.

    Energies are shares of the initial energy.

    Attributes
    ----------
    body : Disk, Sphere or Rod
        The first; all units are its own.
    against : HardWall, ExponentialWall, Disk, Sphere, Rod, HalfSpace or HalfPlane
    speed : float
        Of approach of the centres of mass, or towards the wall, c.
    restitution : float
        ε = −v_f/v_i of the relative motion.
    lost_fraction : float
        1 − ε².
    translation, vibration, dissipated, unresolved : float
        Energy after the impact: of the (relative) translation; of the kept modes; lost to the material;
        of the modes above the cutoff. The sum is 1 but for `energy_error`.
    lost_to_first, lost_to_second : float
        Vibration and dissipation of each body, `unresolved` included; what the waves of a
        half-space carry away.
    contact_time : float
        From first to last contact, R/c.
    impulse_time : float
        From 1 % to 99 % of the impulse, R/c.
    contacts : int
        Separate periods of contact.
    max_force : float
        Greatest mean over one step of the force, mc²/R: πRE of a disk, (4π/3)R²E of a sphere.
    max_compression : float
        R.
    max_half_width : float
        Greatest half-width of the contact, R; of spheres its radius.
    cutoff : float
        Modes up to this frequency are kept, c/R.
    modes, steps : int
        Numbers of kept modes and of time steps.
    step : float
        Time step, R/c.
    nodes, half_width : int, float
        Of the contact grid; R.
    energy_error, momentum_error : float
        What is missing, as shares of the initial energy and momentum.
    beyond_small_strain : bool
        Speed above 0.5 c or compression above 0.5 R, where linear elasticity has lost its meaning.
    mode_energies : ndarray
        Energy of each kept mode, a structured array with the fields body (0 of the first, 1 of
        the second), order, index, omega, after (the impact) and average (during contact). Those of
        a half-space are samples of a continuum, and their order counts wave numbers.
    keep : ndarray or None
        Which modes up to the cutoff were kept, if not all: those of `mode_energies`.
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si`, `max_force_si`,
        `max_compression_si` and `max_half_width_si` are the SI values. If a sphere has a yield
        strength, `yield_speed` and `yield_speed_si` say where yielding begins, and `beyond_yield`
        whether the impact is faster.
    """

    _name: ClassVar[str] = "impact"
    _kind = "impact"
    _given = {"speed": "speed"}

    body: Body
    against: Against
    speed: float
    restitution: float
    lost_fraction: float
    translation: float
    vibration: float
    dissipated: float
    unresolved: float
    lost_to_first: float
    lost_to_second: float
    contact_time: float
    impulse_time: float
    contacts: int
    max_force: float
    max_compression: float
    max_half_width: float
    cutoff: float
    modes: int
    step: float
    nodes: int
    half_width: float
    steps: int
    energy_error: float
    momentum_error: float
    beyond_small_strain: bool
    mode_energies: NDArray[Any]
    keep: NDArray[np.bool_] | None
    _handle: _core.Impact = dataclasses.field(repr=False)

    @property
    def max_half_width_si(self) -> Number:
        """Greatest half-width of the contact, m."""
        return self._in_si("max_half_width")

    def __repr__(self) -> str:
        return (
            f"Impact({self._who()}, speed={self.speed:.6g} c: restitution {self.restitution:.5f}, "
            f"contact time {self.contact_time:.4g} {self._unit('contact_time')}, {self.modes} modes)"
        )

    def _who(self) -> str:
        return shown(self.body) + (f" against {shown(self.against)}" if isinstance(self.against, PARTNERS) else "")

    def _contact(self) -> _core.Contact:
        return contact(self.body, self.against, self.cutoff, self.speed, self.keep)

    @classmethod
    def _made(
        cls,
        body: Body,
        against: Against,
        speed: float,
        cutoff: float,
        step: float | None,
        nodes: int | None,
        half_width: float | None,
        keep: NDArray[np.bool_] | None,
    ) -> Impact:
        """The impact with these inputs, checked before."""
        met = contact(body, against, cutoff, speed, keep)
        handle = _core.impact(met, radiates(against), speed, step, nodes, half_width)
        return cls(
            body=body, against=against, keep=keep, mode_energies=handle.modes(), _handle=handle,
            **handle.numbers(),
        )  # fmt: skip

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        width = None if isinstance(self.body, Rod) else self.half_width
        inputs = (self.body, self.against, self.speed, self.cutoff, self.step, self.nodes, width, self.keep)
        return Impact._made, inputs

    def trajectory(self, *, every: int = 1) -> Trajectory:
        """The impact in time, by repeating it bit by bit.

        Parameters
        ----------
        every : int
            Steps between two rows.

        Returns
        -------
        Trajectory

        Examples
        --------
        >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=25).trajectory()
        >>> energy = path.translation + path.vibration + path.unresolved
        >>> bool(abs(energy - 1).max() < 2e-3)
        True
        """
        return _replay.trajectory(self, every)

    def field(
        self, *, time: ArrayLike, radius: ArrayLike | None = None, angle: ArrayLike | None = None, of: int = 0
    ) -> Field:
        """A deformed disk or sphere and the stress inside it at some times.

        The kept modes are as they move; all others are in static equilibrium with the force of
        contact.

        Parameters
        ----------
        time : array_like
            R/c from the start of the impact, any order; during the impact the nearest step is
            taken, before and after it the body flies freely.
        radius : array_like, optional
            Radii r, 0 to 1, in radii of the body; default 41 of them.
        angle : array_like, optional
            Angles φ, radians, 0 towards the contact, where the default 181 are denser. In a sphere
            polar angles θ on a plane through the axis; negative ones are its other half.
        of : {0, 1}, optional
            Inside which body: the first, or the second.

        Returns
        -------
        DiskField or SphereField
            Arrays of times × radii × angles, without the first axis if `time` is one number.

        Raises
        ------
        InvalidInput
            If the body is a rod, for points outside it, and for more than 2 GB of values.

        Examples
        --------
        >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=25)
        >>> field = hit.field(time=hit.contact_time / 2)
        >>> bool(field.x.max() < 1e-3)  # nothing is beyond the wall
        True
        """
        return _replay.field(self, time, radius, angle, of)

    def wave(
        self,
        *,
        time: ArrayLike | None = None,
        distance: ArrayLike | None = None,
        depth: ArrayLike | None = None,
    ) -> Wave:
        """How the half-space that is met moves below its surface at some times.

        The impact is repeated with a half-space that is good for as long as the waves need to reach
        the farthest point, which has many more of them. A cutoff of 80 over the contact time in R/c
        is enough. It takes some seconds at 0.1 c, and 40 s at 2e-4 c.

        Parameters
        ----------
        time : array_like, optional
            R/c from the start of the impact, any order; during the impact the nearest step is
            taken, after it the waves run freely. Default: 0.4, 0.8, 1.2 and 1.6 contact times.
        distance, depth : array_like, optional
            Distances from the axis and depths below the surface, R; default 121 of them, as far as
            the pressure wave comes.

        Returns
        -------
        Wave
            Arrays of times × depths × distances, without the first axis if `time` is one number.

        Raises
        ------
        InvalidInput
            If what is met is no half-space, for points outside it, for more than 2 GB of values,
            and where the half-space would have more than 2·10⁶ waves.

        Examples
        --------
        >>> hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=4)
        >>> wave = hit.wave(time=5, distance=np.linspace(0, 8, 17), depth=np.linspace(0, 8, 17))
        >>> bool(abs(wave.normal[16]).max() < 0.01 * wave.normal.max())  # the waves are not there yet
        True
        """
        return _replay.wave(self, time, distance, depth)

    def energies_at(self, *, time: ArrayLike) -> NDArray[Any]:
        """Energy of each kept mode at some times, by repeating the impact bit by bit.

        Parameters
        ----------
        time : array_like
            R/c from the start of the impact, any order; during the impact the nearest step is
            taken, after it the energies stay.

        Returns
        -------
        ndarray
            Times × modes, without the first axis if `time` is one number: a structured array with
            the fields body, order, index, omega and energy, as a share of the initial one, in the
            order of `mode_energies`.

        Examples
        --------
        >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=25)
        >>> energies = hit.energies_at(time=[0, hit.contact_time / 2])
        >>> energies["energy"].sum(axis=1).round(2)
        array([0.  , 0.96])
        """
        return _replay.energies_at(self, time)

    def plot(self, ax: Any = None) -> Any:
        """Force against time. See `stoss.plot.force`."""
        return self.trajectory().plot(ax)

    def _inputs(self) -> dict[str, Any]:
        inputs: dict[str, Any] = {"body": self.body, "against": self.against}
        if self.keep is not None:
            inputs["keep"] = f"{self.modes} of {self.keep.size} modes"
        return inputs
