"""Pictures of results, for print: one column wide (3.4 in) and told apart without colour.

Every function takes a result and ``ax``, the Axes to draw in (None: a new figure), and returns the
Axes. Most results draw their own: ``result.plot(ax)``. New figures have small print that fits one
column; in your own Axes the text follows your settings. Nothing global is changed.

================================================  ==================================================
`restitution`                                     ε or 1 − ε² against speed
`function`                                        ε(v) as a function, with its error
`calibration`                                     measured and computed values, with the band of constants
`prediction`                                      a drop test: ε in its band, and what each channel takes
`oblique`                                         ε_t and ε_n against the angle of incidence
`oblique_impact`, `grip`                          one of them in time: velocities, forces, stick and
                                                  slip
`pulse`, `pulse_spectrum`                         force of an impact in time, and its spectrum
`seismogram`                                      motion of a sensor on a block or a plate
`oblique_ledger`                                  where the energy is after oblique impacts
`pair_table`                                      ε(v) of pairs of several ratios of radii
`distribution`                                    ε of many bodies that vibrate
`slow_impact`, `rayleigh`, `static_contact`       quasi-static: contact time, lost fraction,
                                                  pressure
`spectrum`, `mode_shape`                          eigenmodes
`force`, `velocity`, `energies`, `half_width`     one impact in time
`bounces`                                         a sequence: ε, and where the energy is
`ledger`                                          which mode holds how much energy
`disk`, `sphere`, `sequence`, `stress`            the deformed disk or sphere at the wall, or two
`wave`                                            what runs away in a half-space or a plate
`cooling`, `restitution_histogram`                a chain of rods: energies in time, and its ε
`row`, `row_impact`                               bodies on a line: velocities; forces in space and time
`animate`                                         impacts and rows as GIF or MP4
================================================  ==================================================

Examples:
    >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5)
    >>> ax = stoss.plot.sequence(hit)
    >>> ax.figure.savefig("sequence.pdf")
"""

try:
    import matplotlib as _matplotlib  # noqa: F401
except ModuleNotFoundError as _missing:
    if _missing.name != "matplotlib":
        raise
    _hint = "pip install matplotlib, or apt install python3-matplotlib"
    raise ImportError(f"stoss.plot needs matplotlib: {_hint}") from None

from stoss.plot._animation import animate
from stoss.plot._calibration import calibration
from stoss.plot._disk import disk, sphere
from stoss.plot._restitution import function, pair_table
from stoss.plot._modes import ledger
from stoss.plot._many import bounces, cooling, distribution, restitution_histogram
from stoss.plot._modes import mode_shape, spectrum
from stoss.plot._oblique import oblique, oblique_ledger
from stoss.plot._trajectory import energies, force, grip, half_width, oblique_impact, velocity
from stoss.plot._prediction import prediction
from stoss.plot._pulse import pulse, pulse_spectrum, seismogram
from stoss.plot._relaxation import master_curve
from stoss.plot._quasistatic import rayleigh, slow_impact, static_contact
from stoss.plot._restitution import restitution
from stoss.plot._row import row, row_impact
from stoss.plot._sequence import sequence, wave
from stoss.plot._stress import stress
from stoss.plot._style import PICTURES as PICTURES

__all__ = [
    "animate", "bounces", "calibration", "cooling", "disk", "distribution", "energies", "force",
    "function", "grip", "half_width", "ledger", "master_curve", "mode_shape", "oblique", "oblique_impact",
    "oblique_ledger", "pair_table", "prediction", "pulse", "pulse_spectrum", "rayleigh", "restitution", "restitution_histogram", "row", "row_impact",
    "seismogram", "sequence", "slow_impact", "spectrum", "sphere", "static_contact", "stress", "velocity", "wave",
]  # fmt: skip
