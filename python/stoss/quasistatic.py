"""Slow contacts of a disk with a wall, in closed form where there is one; when a sphere begins to yield.

Where the disk follows the wall's force statically, energy conservation gives the whole impact, and
Rayleigh's estimate gives the small loss to vibration. Forces are in πRE = mc²/R, lengths in R,
stresses in E, speeds in c.

======================================================  ============================================
`slow_impact`                                           contact time, greatest compression and force
`rayleigh`                                              lost fraction of a slow impact
`compression`, `compression_force`,                     a law of compression, its inverse,
`compression_energy`, `limit_force`, `limit_speed`      its energy, and where it ends
`static_contact`, `soft_static_contact`                 a disk held against a wall
`hertz_pressure`, `hertz_stress`, `heavy_disk_stress`   stress under a contact or in a heavy disk
`yield_speed`                                           when a sphere, or what it meets, begins to yield
======================================================  ============================================

Laws of compression, δ = F (ln(s/F) − b):

* ``'center'``: s = 1, b = (1 + ν)/4, the approach of the centre of mass, which belongs in its
  equation of motion;
* ``'diameter'``: s = 4, b = 1, the shortening of the diameter through the point of contact;
* ``'printed'``: s = 4, b = 1 + ν, what Gerl and Zippelius print for the latter.

>>> stoss.quasistatic.slow_impact(poisson=0.33, speed=1e-4)
SlowImpact(poisson=0.33, speed=0.0001 c: contact time 10.0392 R/c, compression 0.000324499 R)
"""

from stoss._compression import compression, compression_energy, compression_force, limit_force, limit_speed
from stoss._hertz import PlaneStress, heavy_disk_stress, hertz_pressure, hertz_stress
from stoss._rayleigh import RayleighEstimate, rayleigh
from stoss._slow_impact import SlowImpact, slow_impact
from stoss._static_contact import SoftStaticContact, StaticContact, soft_static_contact, static_contact
from stoss._yield import yield_speed

__all__ = [
    "PlaneStress",
    "RayleighEstimate",
    "SlowImpact",
    "SoftStaticContact",
    "StaticContact",
    "compression",
    "compression_energy",
    "compression_force",
    "heavy_disk_stress",
    "hertz_pressure",
    "hertz_stress",
    "limit_force",
    "limit_speed",
    "rayleigh",
    "slow_impact",
    "soft_static_contact",
    "static_contact",
    "yield_speed",
]
