"""Slow contacts of a disk or a sphere with a wall, in closed form where there is one.

Where the body follows the wall's force statically, energy conservation gives the whole impact, and
Rayleigh's estimate gives the small loss to vibration. Forces are in mc²/R, which is πRE of a disk
and (4π/3)R²E of a sphere, lengths in R, stresses in E, speeds in c (with a material in m/s).

======================================================  ============================================
`slow_impact`                                           contact time, maximum compression and force
`rayleigh`                                              lost fraction of a slow impact
`compression`, `compression_force`,                     a law of compression, its inverse,
`compression_energy`, `limit_force`, `limit_speed`      its energy, and where it ends
`contact_radius`                                        of a sphere
`static_contact`                                        a body held against a wall
`hertz_pressure`, `hertz_stress`                        stress under a contact
`greatest_shear`, `yield_speed`                         of a sphere: where and when it yields
`maw`                                                   of a sphere: oblique impact with friction
`mindlin_force`, `mindlin_displacement`,                a contact that is pushed along the wall
`mindlin_stick_radius`, `mindlin_traction`,
`mindlin_ratio`
======================================================  ============================================

Laws of compression of a disk, δ = F (ln(s/F) − b):

* ``'center'``: s = 1, b = (1 + ν)/4, the approach of the centre of mass, which belongs in its
  equation of motion;
* ``'diameter'``: s = 4, b = 1, the shortening of the diameter through the point of contact.

Those of a sphere, with the radius a of the contact, a³ = π(1 − ν²)F:

* ``'center'``: the approach of the centre of mass to the first order beyond Hertz;
* ``'hertz'``: δ = a², two half-spaces.

>>> stoss.quasistatic.slow_impact(poisson=0.33, speed=1e-4)
SlowImpact(poisson=0.33, speed=0.0001 c: contact time 10.0392 R/c, compression 0.000324499 R)
"""

from stoss.bodies._encounter import yield_speed
from stoss.quasistatic._compression import (
    compression, compression_energy, compression_force, contact_radius, limit_force, limit_speed,
)
from stoss.quasistatic._hertz import (
    AxisymmetricStress, GreatestShear, PlaneStress, greatest_shear, hertz_pressure, hertz_stress,
)
from stoss.quasistatic._oblique import (
    MawImpact, maw, mindlin_displacement, mindlin_force, mindlin_ratio, mindlin_stick_radius, mindlin_traction,
)
from stoss.quasistatic._slow_impact import RayleighEstimate, SlowImpact, rayleigh, slow_impact
from stoss.quasistatic._compression import StaticContact, static_contact

__all__ = [
    "AxisymmetricStress", "GreatestShear", "MawImpact", "PlaneStress", "RayleighEstimate", "SlowImpact", "StaticContact",
    "compression", "compression_energy", "compression_force", "contact_radius", "greatest_shear",
    "hertz_pressure", "hertz_stress", "limit_force", "limit_speed", "maw",
    "mindlin_displacement", "mindlin_force", "mindlin_ratio", "mindlin_stick_radius", "mindlin_traction", "rayleigh",
    "slow_impact", "static_contact", "yield_speed",
]  # fmt: skip
