"""What one impact gives when it is repeated: in time, inside the bodies, below a surface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from numpy.typing import ArrayLike, NDArray

from stoss._arguments import number
from stoss.results import _replay
from stoss.results._field import Field
from stoss.results._motion import Trajectory, Wave
from stoss.results._si import ImpactsInSi

if TYPE_CHECKING:
    from stoss.results._impact import Impact


class ImpactViews(ImpactsInSi):
    """The methods of `Impact` that repeat it."""

    def _whole(self) -> Impact:
        return cast("Impact", self)

    def trajectory(self, *, every: int = 1) -> Trajectory:
        """The impact in time, by repeating it bit by bit.

        Parameters
        ----------
        every : int
            Steps between two rows.

        Examples
        --------
        >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=25).trajectory()
        >>> energy = path.translation + path.vibration + path.unresolved
        >>> bool(abs(energy - 1).max() < 2e-3)
        True
        """
        return _replay.trajectory(self._whole(), every)

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
        return _replay.field(self._whole(), time, radius, angle, of)

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
        return _replay.wave(self._whole(), time, distance, depth)

    def energies_at(self, *, time: ArrayLike) -> NDArray[Any]:
        """Energy of each kept mode at some times, by repeating the impact bit by bit.

        Parameters
        ----------
        time : array_like
            R/c from the start of the impact, any order; during the impact the nearest step is
            taken, before and after it the energies stay.

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
        return _replay.energies_at(self._whole(), time)

    def state_after(self, *, flight: float) -> NDArray[Any]:
        """How the bodies vibrate when they meet again at the speed of their parting, `restitution`
        × `speed`.

        Parameters
        ----------
        flight : float
            Time between the two impacts, R/c: from where the bodies would part if they were unexcited
            to where they would touch.

        Returns
        -------
        ndarray
            The `state` of the next `impact`: a structured array with the fields body, order, index,
            energy (as a share of the translational one before that impact) and phase, radians.
            Bodies with a loss time vibrate less by then, and the waves of a half-space have run
            away.

        Raises
        ------
        InvalidInput
            If the flight is negative, and if the bodies do not part.

        Examples
        --------
        >>> hit = stoss.impact(stoss.Sphere(poisson=0.3), speed=0.1, cutoff=25)
        >>> state = hit.state_after(flight=20)
        >>> bool(abs(state["energy"].sum() - hit.vibration / hit.translation) < 1e-12)
        True
        """
        return _replay.state_after(self._whole(), number("flight", flight))

    def plot(self, ax: Any = None) -> Any:
        """Force against time. See `stoss.plot.force`."""
        return self.trajectory().plot(ax)
