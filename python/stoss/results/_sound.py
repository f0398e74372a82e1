"""What is heard of an impact: the velocity of the struck point while the modes ring. A method of `Impact`."""

from __future__ import annotations

import dataclasses
import math
import os
import wave

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import integer, number, optional_number, refusal, require_memory
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import BODIES, shown
from stoss.bodies._losses import relaxes
from stoss.export._files import whole_file
from stoss.results._computed_impact import ComputedImpact

QUALITY = 1000.0
"""Quality of modes of a material without a loss time."""


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Sound:
    """How the struck point of a body moves after an impact, as samples that can be played.

    Attributes:
        impact (Impact): The impact that it follows.
        of (int): The body that is heard: 0 the first, 1 the second.
        samples (ndarray): Velocity of the point towards what it has met, m/s, from the end of the
            impact on.
        rate (int): Samples in a second.
        slower (float): How many times slower it is than what happens.
    """

    impact: ComputedImpact
    of: int
    samples: NDArray[np.float64]
    rate: int
    slower: float

    def __repr__(self) -> str:
        body = self.impact.against if self.of == 1 else self.impact.body
        slow = f", {self.slower:g} times slower" if self.slower != 1.0 else ""
        return f"Sound({shown(body)}, {self.duration:g} s at {self.rate} Hz{slow})"  # type: ignore[arg-type]

    @property
    def duration(self) -> float:
        """How long it is played, s."""
        return self.samples.size / self.rate

    @property
    def time(self) -> NDArray[np.float64]:
        """Time of each sample, s after the impact."""
        return np.arange(self.samples.size) / (self.rate * self.slower)

    @documented
    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a WAV file, 16 bits, one channel, as loud as it can be. It appears whole or not at all."""
        with whole_file(os.fspath(path), ".wav") as temporary, wave.open(temporary, "wb") as file:
            file.setnchannels(1)
            file.setsampwidth(2)
            file.setframerate(self.rate)
            loudest = float(np.abs(self.samples).max(initial=0.0)) or 1.0
            file.writeframes(np.round(32767.0 / loudest * self.samples).astype("<i2").tobytes())


@documented
def sound(
    self: ComputedImpact,
    *,
    duration: float = 2.0,
    rate: int = 44100,
    quality: float | None = None,
    of: int = 0,
    slower: float = 1.0,
) -> Sound:
    """The sound of a body after the impact: its partials, summed to the velocity of the struck point.

    Each mode rings on as the impact leaves it, with u_k e^(−γt) [P/m cos ωt − ωQ sin ωt], where u_k
    is its displacement at the point, and γ = ½ηω² of a material with a loss time η, else ω/(2·quality).
    The radiation into the air, which is better for some modes than for others, is left out.

    Parameters:
        duration: How long it is played, s, to 600.
        rate: Samples in a second, 1000 to 384000. Modes above half of it are left out.
        quality: Q of all modes, above 0.5. Default: that of the material, or 1000 where it loses
            nothing.
        slower: How many times slower it is played: small bodies ring far above what one hears.

    Examples:
        >>> ball = stoss.Sphere(radius=0.05, material=stoss.Material(young=7e10, poisson=0.22, density=2500))
        >>> heard = stoss.impact(ball, speed=1.0, cutoff=25).sound(duration=0.5, slower=20)
        >>> heard
        Sound(Sphere(poisson=0.22, radius=0.05 m), 0.5 s at 44100 Hz, 20 times slower)
        >>> heard.save("ball.wav")
    """
    number_of, pair = integer("of", of), isinstance(self.against, BODIES)
    if number_of not in ((0, 1) if pair else (0,)):
        raise refusal("of", number_of, "0 or 1" if pair else "0 (only bodies that move ring on)")
    body = self.against if number_of == 1 else self.body
    if self.body.material is None:
        raise refusal("body", self.body, "one with a material: only then are frequencies in Hz")
    if self.keep is not None:
        raise InvalidInput.out_of_range("keep", "an impact of a selection of modes", "one with all of them")
    length, samples, slow = number("duration", duration), integer("rate", rate), number("slower", slower)
    for name, value, low, high in (("duration", length, 0.0, 600.0), ("rate", samples, 999, 384000),
                                   ("slower", slow, 0.0, 1e9)):  # fmt: skip
        if not low < value <= high:
            raise refusal(name, value, f"above {low:g}, to {high:g}")
    count = math.ceil(length * samples)
    require_memory("duration", f"{count} samples", 16.0 * count, "make it shorter")
    chosen = optional_number("quality", quality)
    if chosen is None and not getattr(body, "loss_time", 0.0) and not relaxes(body):
        chosen = QUALITY
    scales, interval = self.body.scales, 1.0 / (samples * slow)
    modes = self.mode_energies
    heard = modes["omega"][modes["body"] == number_of] * scales.frequency
    if not np.any(heard * interval < math.pi):
        least = f"the lowest mode has {heard.min() / (2.0 * math.pi):.4g} Hz" if heard.size else "it has no modes"
        raise refusal("slower", slow, f"a larger one, so that modes are below half the rate ({least})")
    made = _core.sound(self._contact(), self._handle, number_of, interval / scales.time, count, chosen)
    velocity = made * scales.speed
    velocity.flags.writeable = False
    return Sound(self, number_of, velocity, samples, slow)
