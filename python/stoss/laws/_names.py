"""All laws and programs by name."""

from __future__ import annotations

from typing import Mapping

from stoss.laws._chrono import CHRONO
from stoss.laws._collision import Spring
from stoss.laws._hunt_crossley import HuntCrossley
from stoss.laws._lammps import LAMMPS
from stoss.laws._law import KAPPA, Law
from stoss.laws._liggghts import LIGGGHTS
from stoss.laws._linear import Linear
from stoss.laws._mercury import MERCURY
from stoss.laws._mujoco import Mujoco
from stoss.laws._mujoco_xml import MUJOCO
from stoss.laws._program import Program
from stoss.laws._table import Table
from stoss.laws._thornton import Thornton
from stoss.laws._tsuji import Tsuji
from stoss.laws._two_columns import TWO_COLUMNS
from stoss.laws._viscoelastic import Viscoelastic
from stoss.laws._walton import Walton
from stoss.laws._yade import YADE

__all__ = ["KAPPA", "LAWS", "PROGRAMS", "Spring"]

ALL: tuple[type[Law], ...] = (Linear, Tsuji, Viscoelastic, HuntCrossley, Thornton, Walton, Mujoco, Table)
LAWS: Mapping[str, type[Law]] = {law.NAME: law for law in ALL}

PROGRAMS: Mapping[str, Program] = {
    "lammps": LAMMPS,
    "liggghts": LIGGGHTS,
    "yade": YADE,
    "mercurydpm": MERCURY,
    "chrono": CHRONO,
    "mujoco": MUJOCO,
    "acutrace": TWO_COLUMNS,
    "aspherix": TWO_COLUMNS,
}
