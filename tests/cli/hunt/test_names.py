"""A refusal is of what was given: its name is an option, a field or a key of the command, in calls drawn at random."""

import json
import re
import resource
import shlex
import subprocess
from pathlib import Path

import pytest
from drawn import BODY_FILES, OPTIONS, Drawer

LONGEST = 1  # second of processor time: a refusal comes sooner
# What computations that have not converged say of themselves.
COMPUTATIONS = {"impact", "bounce", "restitution", "oblique", "table", "rule_table", "predict", "distribution", "quasistatic"}
# Ways out that only a command with such an option has.
WAYS = {"nodes": r"fewer nodes|more nodes", "step": r"(smaller|larger) step", "cutoff": r"cutoff|raise it", "tolerance": r"tolerance"}


@pytest.fixture(scope="module")
def drawer(stoss):
    return Drawer(stoss.path)


def properties(schema):
    """Names of all properties, at any depth."""
    if isinstance(schema, list):
        return set().union(*map(properties, schema))
    if not isinstance(schema, dict):
        return set()
    return set(schema.get("properties", {})).union(*map(properties, schema.values()))


@pytest.fixture(scope="module")
def keys(stoss):
    """Of an encounter and of body files."""
    of_files = set().union(*(json.loads(Path(file).read_text()) for file in BODY_FILES))
    return properties(json.loads(stoss.run("schema").stdout)) | of_files


@pytest.fixture(scope="module")
def options(stoss):
    return {command: set(re.findall(r"--([\w-]+)", stoss.run(command, "--help").stdout)) for command in OPTIONS}


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 1))


def fault(words, code, text, options, keys):
    """What is wrong with what a call says; "" if nothing is."""
    if re.search(r"\bnan\b", text) and not any("nan" in word for word in words):
        return "nan that was not given"
    given = " ".join(words)
    for number in re.findall(r"(?<![\w.])\d*\.?\d+(?:e[+-]?\d+)?", text):
        if len(re.sub(r"^0*\.?0*|\.|e.*", "", number)) > 10 and number not in given:
            return f"{number} was not given"
    if text.startswith("stoss: error: unknown argument: "):
        return ""
    for option in re.findall(r"--([\w-]+)", text):
        if option not in options:
            return f"the command has no --{option}"
    for option, way in WAYS.items():
        if option not in options and re.search(way, text):
            return f"a way out by {option}, which the command has not"
    found = re.fullmatch(r"stoss: error: (?:against |--)?([\w -]+?)(?: ratio)?: .*", text)
    if not found:
        return "" if code == 1 or re.match("stoss: error: '", text) else "no name"
    name = found[1]
    allowed = options | {each.replace("-", "_") for each in options} | keys
    if code == 1:
        allowed = allowed | COMPUTATIONS
    # Products of what rods were given, which the message spells out.
    derived = {"transit time": "length sqrt(density/young)", "impedance": "area sqrt(young density)"}
    if name in derived and derived[name] in text:
        return ""
    return "" if name.split()[0] in allowed else f"the command has no {name}"


def hold(stoss, drawer, options, keys, seed):
    words = drawer.call(seed)
    done = subprocess.run([stoss.path, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, preexec_fn=limit)
    lines = [line for line in done.stderr.splitlines() if line.startswith("stoss: error: ")]
    if done.returncode not in (1, 2, 3) or not lines:
        return  # not refused, or stopped by the limit
    found = fault(words, done.returncode, lines[-1], options[words[0]], keys)
    if found:
        pytest.fail(f"seed {seed}: {found}\n  stoss {shlex.join(words)}\n  {lines[-1]}", pytrace=False)


@pytest.mark.parametrize("seed", range(5000, 5060))
def test_refusals_name_what_was_given(stoss, drawer, options, keys, seed):
    hold(stoss, drawer, options, keys, seed)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(6000, 6300))
def test_refusals_name_what_was_given_long(stoss, drawer, options, keys, seed):
    hold(stoss, drawer, options, keys, seed)
