"""All laws and programs by name."""

from __future__ import annotations

from typing import Mapping

from stoss.laws._engines import DRAKE, FLUENT, GAZEBO, ISAAC, NEWTON, PHYSX, SIMBODY
from stoss.laws._granular import LAMMPS, LIGGGHTS, YADE
from stoss.laws._law import KAPPA, Law, Spring
from stoss.laws._particles import KRATOS, LETHE, MFIX
from stoss.laws._power import HuntCrossley, Linear, Mujoco, Tsuji, Viscoelastic
from stoss.laws._program import CHRONO, MERCURY, MUJOCO, TWO_COLUMNS, Program
from stoss.laws._rules import Polynomial, Table, Thornton, Walton

__all__ = ["KAPPA", "LAWS", "PROGRAMS", "Spring"]

ALL: tuple[type[Law], ...] = (
    Linear, Tsuji, Viscoelastic, HuntCrossley, Thornton, Walton, Mujoco, Table, Polynomial,
)  # fmt: skip
LAWS: Mapping[str, type[Law]] = {law.NAME: law for law in ALL}

PROGRAMS: Mapping[str, Program] = {  # as fitted_programs of the core has them
    "lammps": LAMMPS, "liggghts": LIGGGHTS, "yade": YADE, "mercurydpm": MERCURY, "kratos": KRATOS, "mfix": MFIX,
    "lethe": LETHE, "chrono": CHRONO, "simbody": SIMBODY, "drake": DRAKE, "mujoco": MUJOCO, "gazebo": GAZEBO,
    "physx": PHYSX, "isaac": ISAAC, "newton": NEWTON, "acutrace": TWO_COLUMNS, "aspherix": TWO_COLUMNS,
    "fluent": FLUENT,
}  # fmt: skip
