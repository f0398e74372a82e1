"""Nothing that the compiled module is asked for ends the interpreter."""

import pytest

# Each line alone in a process: whatever it raises, the interpreter must live to say so.
NASTY = [
    "core.Contact()", "core.Impact()", "core.Frames.summaries(None)", "core.Impact.modes(None)",
    "copy.copy(handle)", "copy.deepcopy(disk)", "pickle.dumps(handle)", "pickle.dumps(hit)", "copy.deepcopy(hit)",
    "core.motion(rod.contact(100.0, 1.0), handle, two)", "core.motion(disk.contact(3.0, 1.0), handle, two)",
    "core.motion(pair.contact(6.0, 1.0), handle, two)", "core.encounter('[')", "core.encounter('{}')",
    "core.motion(met, handle, two[::-1])", "core.motion(met, handle, two * nan)", "core.Encounter()",
    "handle.trajectory(disk.contact(20.0, 1.0), 1)", "handle.trajectory(rod.contact(9.0, 1.0), 1)",
    "handle.trajectory(met, -1)", "disk.scales()", "disk.wave_speeds()", "rod.slow_law()",
    "core.fields(disk, 0, disk.contact(20.0, 1.0), handle, frames, two, two)",
    "core.fields(disk, 0, rod.contact(9.0, 1.0), handle, frames, two, two)",
    "core.fields(rod, 0, met, handle, frames, two, two)", "core.fields(disk, 0, met, finer, frames, two, two)",
    "core.fields(disk, 1, met, handle, frames, two, two)", "core.fields(disk, -7, met, handle, frames, two, two)",
    "core.fields(pair, 1, pair.contact(6.0, 1.0), handle, frames, two, two)",
    "core.disk_displacement(0.33, 10**6, 1.0, 1.0, 1.0, two)", "core.disk_displacement(0.33, -1, nan, nan, nan, two)",
    "core.impact(met, 0.1, None, None, 1e-300)", "rod.contact(1e300, 1.0)", "disk.contact(1e300, 1.0)",
    "rod.contact(nan, 1.0)", "met.with_modes(np.ones(3, dtype=bool))",
    "core.check_curve(two, nan, 1)", "threading.stack_size(65536); run(stoss.modes, poisson=0.3, cutoff=50)",
    "run(stoss.restitution, poisson=[0.1, 0.2], speed=0.1, tolerance=0.1)", "del hit, handle; energies[0]",
    "core.ObliqueImpact()", "core.ObliqueImpact.ledger(None)", "slip.trajectory(met, 0)", "pickle.dumps(slip)",
    "slip.trajectory(rod.contact(9.0, 1.0), 1)", "slip.trajectory(pair.contact(6.0, 1.0), 1)",
    "slip.trajectory(disk.contact(20.0, 1.0), 3)", "rung.trajectory(disk.contact(3.0, 1.0), 3)",
    "core.oblique_impact(met, 0.1, two, None, None, None, hit.state_after(flight=1.0))",
    "[stoss.restitution(poisson=0.3, speed=np.full(3, 0.1), tolerance=0.1, threads=1024) for _ in range(3)]",
]
# Ways to an object of memory that nobody has set.
EMPTY = ["core.Encounter.__new__(core.Encounter).refinable()", "pickle.dumps(handle, 1)", "pickle.dumps(hit._handle, 0)", "core.Frames.__new__(core.Frames).summaries()",
         "repr(core.Impact.__new__(core.Impact).modes())"]
CHILD = """
import copy, gc, pickle, threading, numpy as np, stoss, stoss._core
core, nan, two = stoss._core, float("nan"), np.array([0.1, 0.2])
hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=6)
energies, handle = hit.mode_energies, hit._handle
first = '{{"first": {{"kind": "disk", "poisson": 0.33}}'
disk, pair = core.encounter(first + "}}"), core.encounter(first + ', "against": "same"}}')
rod, met = core.encounter('{{"first": {{"kind": "rod"}}}}'), disk.contact(6.0, 1.0)
finer, frames = stoss.impact(poisson=0.33, speed=0.1, cutoff=6, nodes=90)._handle, core.motion(met, handle, two)
def slid(**state):
    return stoss.oblique_impact(stoss.Disk(poisson=0.33), speed=0.1, angle=20, friction=0.3, cutoff=6, **state)._handle
slip, rung = slid(), slid(state=hit.state_after(flight=1.0))
def run(function, **arguments):
    thread = threading.Thread(target=function, kwargs=arguments)
    thread.start()
    thread.join()
for line in {lines!r}:
    print(line, flush=True)
    try:
        exec(line, dict(globals()))
    except Exception as error:
        str(error)
    gc.collect()
print("alive")
"""


def lives(interpreter, lines):
    done = interpreter.run(CHILD.format(lines=lines))
    assert done.returncode == 0 and done.stdout.endswith("alive\n"), done.stdout[-200:] + done.stderr


def test_nothing_ends_the_interpreter(interpreter):
    lives(interpreter, NASTY)


@pytest.mark.parametrize("line", EMPTY)
def test_there_are_no_empty_objects(interpreter, line):
    lives(interpreter, [line])
