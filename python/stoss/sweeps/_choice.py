"""What a sweep computes, by the arguments of its grid or the inputs of a task."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Mapping, Sequence

from stoss._arguments import integer, number, refusal
from stoss._errors import InvalidInput
from stoss.bodies._encounter import choose_against
from stoss.bodies._kinds import Specification
from stoss.sweeps._bodies import resolved
from stoss.sweeps._computation import Accuracy, Case, Computation, Ensemble, Rules, case_of
from stoss.sweeps._row_cases import Rows, row_case, row_of_text
from stoss.sweeps._specification import beside, make

ALONG = ("angle", "tangential", "spin", "second_spin", "friction")
AXES = ("speed", *ALONG, "temperature", "sample", "number")
"""In their order."""


def kind_of(axes: Sequence[str]) -> type[Computation]:
    """What has these axes."""
    return Rows if "number" in axes else Rules if "friction" in axes else Ensemble if "sample" in axes else Computation


def choose_computation(given: Mapping[str, Any]) -> Computation:
    """What these arguments of a grid ask for; those that were left out are None."""
    said = {name for name, value in given.items() if value is not None}
    if {"friction", "temperature"} <= said:
        raise InvalidInput.out_of_range("friction", "friction and temperature", "one of them")
    for name in ("friction", "temperature", "bodies", "against"):
        if {"row", name} <= said:
            raise InvalidInput.out_of_range("row", f"row and {name}", "a row alone, which has all but the speed")
    if {"angle", "tangential"} <= said:
        raise InvalidInput.out_of_range("angle", "angle and tangential", "one of them")
    last = {"temperature": "sample", "row": "number"}
    chosen = kind_of([last.get(name, name) for name in said])
    needs = dict.fromkeys(ALONG, "friction") | dict.fromkeys(("samples", *Ensemble.usual), "temperature")
    for name in sorted(said):
        key, of = needs.get(name), {Rules: "friction", Rows: "row"}.get(chosen, "temperature")
        if key is not None and key not in said:
            raise refusal(name, given[name], f"only together with {key}")
        if name in Computation.usual and name not in chosen.usual:
            raise refusal(name, given[name], f"none together with {of}, whose accuracy is {list(chosen.usual)[-1]}")
    accuracy: dict[str, float | int] = {}
    for name, usual in chosen.usual.items():
        value = usual if given[name] is None else given[name]
        accuracy[name] = integer(name, value) if name == "seed" else number(name, value)
    if accuracy.get("seed", 0) < 0:
        raise refusal("seed", given["seed"], "0 to 2147483647")
    counted = {Ensemble: "sample", Rows: "number"}.get(chosen)
    axes = [name for name in AXES if name in said or name == counted]
    return chosen(axes, accuracy)


def case_of_inputs(inputs: Specification, accuracy: Accuracy, store: Path) -> Case:
    """The case with the inputs that its task has, and the bodies of files in this store."""
    if "row" in inputs:
        return row_case((0, 0), row_of_text(json.dumps(inputs["row"])), accuracy)
    body = make("body", resolved(inputs["body"], store))
    against = choose_against(body, beside(resolved(inputs["against"], store), body))
    return case_of((0, 0), body, against, accuracy)
