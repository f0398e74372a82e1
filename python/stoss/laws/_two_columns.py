"""Altair AcuTrace and Aspherix: rows of a speed and ε, as `stoss table --format two-column` writes them."""

from __future__ import annotations

from typing import Any

from stoss.laws._collision import Spring
from stoss.laws._program import Program, Wording, digits


def _rows(law: Any) -> list[str]:
    return [f"{digits(speed)} {digits(value)}" for speed, value in zip(law.speeds, law.values)]


TWO_COLUMNS = Program({"table": Wording(_rows, Spring(), None)}, comment=None)
