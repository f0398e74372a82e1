"""The file that stoss reads: a body as an impact at one point sees it."""

from __future__ import annotations

import json
from typing import Any, Mapping

import numpy as np

from stoss.export._files import write_lines

FORMAT = "stoss modal body 1"
DIGITS = 12


def write(path: str, body: Mapping[str, Any]) -> None:
    """JSON, one line for each key, that appears whole or not at all."""
    keys = {"format": FORMAT, **body}
    text = {name: json.dumps(_plain(value), ensure_ascii=False) for name, value in keys.items()}
    lines = [f" {json.dumps(name)}: {value}" for name, value in text.items()]
    write_lines(path, ["{\n", ",\n".join(lines), "\n}\n"])


def _plain(value: Any) -> Any:
    """Numbers with as many digits as mean something, in lists and dictionaries."""
    if isinstance(value, Mapping):
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [_plain(each) for each in value]
    return value if isinstance(value, (str, int)) else float(f"{float(value):.{DIGITS}g}")
