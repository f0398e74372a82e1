"""All laws and programs by name."""

from __future__ import annotations

from typing import Mapping

from stoss.laws._law import KAPPA, Law, Spring
from stoss.laws._granular import LAMMPS, LIGGGHTS, YADE
from stoss.laws._power import HuntCrossley, Linear, Mujoco, Tsuji, Viscoelastic
from stoss.laws._program import CHRONO, MERCURY, MUJOCO, TWO_COLUMNS, Program
from stoss.laws._rules import Table, Thornton, Walton

__all__ = ["KAPPA", "LAWS", "PROGRAMS", "Spring"]

ALL: tuple[type[Law], ...] = (Linear, Tsuji, Viscoelastic, HuntCrossley, Thornton, Walton, Mujoco, Table)
LAWS: Mapping[str, type[Law]] = {law.NAME: law for law in ALL}

PROGRAMS: Mapping[str, Program] = {
    "lammps": LAMMPS, "liggghts": LIGGGHTS, "yade": YADE, "mercurydpm": MERCURY, "chrono": CHRONO, "mujoco": MUJOCO,
    "acutrace": TWO_COLUMNS, "aspherix": TWO_COLUMNS,
}  # fmt: skip
