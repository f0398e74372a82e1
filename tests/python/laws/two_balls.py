"""Pairs of balls collide in a simulation program: what becomes of their velocities.

All pairs of a run are far from each other. Each pair approaches along x with a relative speed v, and slides along y at
first with s; ε = −v′/v along the line of centres in the middle of the contact, ε_t = −s′/s.
"""

import subprocess

import numpy as np

APART = 10  # radii between pairs


class Pairs:
    """Places and velocities of pairs of balls before and, by `outcome`, what becomes of them."""

    def __init__(self, ball, speeds, slidings, contact_time, second=None):
        radius, self.balls = ball.radius, (ball, second or ball)
        self.speed, self.sliding = np.broadcast_arrays(*map(np.asarray, (speeds, slidings)))
        self.step = contact_time.min() / 8000
        gap = 3 * self.step * self.speed
        self.steps = int(1.1 * contact_time.max() / self.step) + 10
        here = np.arange(self.speed.size)[:, None] * [0, APART * radius, 0]
        away = self.balls[1].radius + gap
        self.first, self.second = here - [radius, 0, 0], here + np.stack([away, 0 * gap, 0 * gap], axis=1)
        self.radius = radius
        self.radii, self.densities = (np.repeat([getattr(each, name) for each in self.balls], self.speed.size)
                                      for name in ("radius", "density"))  # fmt: skip
        half = 0.5 * np.stack([self.speed, self.sliding, 0 * self.speed], axis=1)
        self.velocity = half, -half

    def outcome(self, places, velocities, spins):
        """ε and ε_t of what the program says of all balls, the first ones of all pairs before the second ones."""
        count = self.speed.size
        line = places[count:] - places[:count] + self.second - self.first
        normal = line / np.linalg.norm(line, axis=1)[:, None]
        relative = velocities[:count] - velocities[count:]
        along = np.stack([-normal[:, 1], normal[:, 0], 0 * normal[:, 0]], axis=1)
        approach = np.sum(relative * normal, axis=1)
        turning = self.radii * spins[:, 2]
        surface = np.sum(relative * along, axis=1) + turning[:count] + turning[count:]
        start = np.where(self.sliding, self.sliding, np.nan)
        return -approach / self.speed, -surface / start


def _run(*command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout


def molecular(command, balls, lines, run, folder):
    """Places, velocities and spins after a run of LAMMPS or LIGGGHTS, whose scripts differ in little.

    `balls` are places, velocities, radii and densities; `run` is the time step and how many.
    """
    places, speeds, radii, densities = balls
    radius = radii.max()
    step, steps = run
    old = command == "liggghts"
    low, high = places.min(axis=0) - 5 * radius, places.max(axis=0) + 5 * radius
    box = " ".join(f"{a:.17g} {b:.17g}" for a, b in zip(low, high))
    types = 2 if any(" 2 " in line for line in lines) else 1
    script = [
        "units si", f"atom_style {'granular' if old else 'sphere'}", "atom_modify map array", "boundary f f f",
        "newton off", "communicate single vel yes" if old else "comm_modify vel yes",
        f"region box block {box} units box", f"create_box {types} box",
        *(f"create_atoms 1 single {x:.17g} {y:.17g} {z:.17g} units box" for x, y, z in places),
        *(f"set atom {k} diameter {2 * size:.17g} density {density:.17g}"
          for k, (size, density) in enumerate(zip(radii, densities), 1)),
    ]  # fmt: skip
    for k, velocity in enumerate(speeds, 1):
        words = " ".join(f"{each:.17g}" for each in velocity)
        script += [f"group one id {k}", f"velocity one set {words} units box", "group one delete"]
    number = "%d" + 9 * " %.16g"
    script += [
        f"neighbor {0.2 * radius:.17g} bin", "neigh_modify delay 0", *lines, "fix move all nve/sphere",
        f"timestep {step:.17g}", f"dump all all custom {steps} out id x y z vx vy vz omegax omegay omegaz",
        f'dump_modify all sort id format {"" if old else "line"} "{number}"', f"thermo {steps}", f"run {steps}",
    ]  # fmt: skip
    (folder / "script").write_text("\n".join(script) + "\n")
    _run(command, "-in", "script", "-log", "none", folder=folder)
    rows = np.array([line.split() for line in (folder / "out").read_text().splitlines()[-len(places):]], dtype=float)
    return rows[:, 1:4], rows[:, 4:7], rows[:, 7:10]


def lammps(pairs, lines, folder, command="lmp"):
    places, speeds = np.concatenate([pairs.first, pairs.second]), np.concatenate(pairs.velocity)
    balls = places, speeds, pairs.radii, pairs.densities
    return pairs.outcome(*molecular(command, balls, lines, (pairs.step, pairs.steps), folder))


def liggghts(pairs, lines, folder):
    return lammps(pairs, lines, folder, "liggghts")


YADE = """
from yade import *
exec(open("lines").read())
O.materials.append(material)
for place, velocity in {balls!r}:
    ball = utils.sphere(place, {radius!r})
    O.bodies.append(ball)
    ball.state.vel = velocity
O.engines = [
    ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist={radius!r}), InteractionLoop(*contact),
    NewtonIntegrator(damping=0, gravity=(0, 0, 0)),
]
O.dt = {step!r}
O.run({steps}, True)
with open("out", "w") as out:
    for body in O.bodies:
        print(*body.state.pos, *body.state.vel, *body.state.angVel, file=out)
"""


def yade(pairs, lines, folder):
    places, speeds = np.concatenate([pairs.first, pairs.second]).tolist(), np.concatenate(pairs.velocity).tolist()
    (folder / "lines").write_text("\n".join(lines))
    balls, step = list(zip(places, speeds)), float(pairs.step)
    script = YADE.format(balls=balls, radius=pairs.radius, step=step, steps=pairs.steps)
    (folder / "script.py").write_text(script)
    _run("yade", "-n", "-x", "-j1", "script.py", folder=folder)
    rows = np.loadtxt(folder / "out")
    return pairs.outcome(rows[:, :3], rows[:, 3:6], rows[:, 6:])


MUJOCO = """
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char **words) {
  char error[500] = "";
  mjModel *model = mj_loadXML(words[1], NULL, error, sizeof error);
  if (model == NULL) return fprintf(stderr, "%s", error), 1;
  mjData *data = mj_makeData(model);
  FILE *velocities = fopen(words[2], "r");
  for (int k = 0; k < model->nv; ++k) {
    if (fscanf(velocities, "%lf", &data->qvel[k]) != 1) return 2;
  }
  for (int k = atoi(words[3]); k > 0; --k) mj_step(model, data);
  for (int k = 0; k < model->nbody - 1; ++k) {
    for (int i = 0; i < 3; ++i) printf("%.16g ", data->qpos[7 * k + i]);
    for (int i = 0; i < 6; ++i) printf("%.16g ", data->qvel[6 * k + i]);
    printf("\\n");
  }
  return count != 4;
}
"""


def _mujoco(places, velocities, ball, run, lines, folder, floor=""):
    step, steps = run
    geometry = f'<geom type="sphere" size="{ball.radius!r}" density="{ball.density!r}"/>'
    bodies = "".join(
        f'<body pos="{x!r} {y!r} {z!r}"><freejoint/>{geometry}</body>' for x, y, z in np.asarray(places).tolist()
    )  # fmt: skip
    option = f'<option timestep="{float(step)!r}" gravity="0 0 0" tolerance="0" iterations="100"/>'
    size = '<size njmax="2000" nconmax="500"/>'
    text = "".join(["<mujoco>", size, option, *lines, "<worldbody>", floor, bodies, "</worldbody></mujoco>"])
    (folder / "model.xml").write_text(text)
    np.savetxt(folder / "velocities", np.concatenate([velocities, 0 * velocities], axis=1))
    (folder / "main.c").write_text(MUJOCO)
    _run("cc", "main.c", "-lmujoco", "-o", "main", folder=folder)
    out = _run("./main", "model.xml", "velocities", str(steps), folder=folder)
    rows = np.array([line.split() for line in out.splitlines()], dtype=float)
    return rows[:, :3], rows[:, 3:6], rows[:, 6:]


def mujoco(pairs, lines, folder):
    places, speeds = np.concatenate([pairs.first, pairs.second]), np.concatenate(pairs.velocity)
    return pairs.outcome(*_mujoco(places, speeds, pairs.balls[0], (pairs.step, pairs.steps), lines, folder))


SIMBODY = """
#include <Simbody.h>
#include <cstdio>
#include <fstream>

int main(int, char **words) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::ContactTrackerSubsystem tracker(system);
  SimTK::CompliantContactSubsystem forces(system, tracker);
#include "lines"
  std::ifstream balls(words[1]);
  std::vector<SimTK::Vec3> places, velocities;
  std::vector<SimTK::MobilizedBody::Free> bodies;
  double x, y, z, u, v, w, radius, density;
  while (balls >> x >> y >> z >> u >> v >> w >> radius >> density) {
    const double mass = 4.0 / 3.0 * SimTK::Pi * density * radius * radius * radius;
    SimTK::Body::Rigid body(SimTK::MassProperties(mass, SimTK::Vec3(0), SimTK::UnitInertia::sphere(radius)));
    const SimTK::ContactMaterial &its = bodies.size() < std::stoul(words[4]) ? material : other;
    body.addContactSurface(SimTK::Transform(), SimTK::ContactSurface(SimTK::ContactGeometry::Sphere(radius), its));
    bodies.emplace_back(matter.Ground(), SimTK::Transform(), body, SimTK::Transform());
    places.emplace_back(x, y, z);
    velocities.emplace_back(u, v, w);
  }
  if (std::string(words[3]) == "floor") {  // z < 0
    matter.Ground().updBody().addContactSurface(
        SimTK::Transform(SimTK::Rotation(SimTK::Pi / 2, SimTK::YAxis)),
        SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), material));
  }
  SimTK::State state = system.realizeTopology();
  for (size_t k = 0; k < bodies.size(); ++k) {
    bodies[k].setQToFitTranslation(state, places[k]);
    bodies[k].setUToFitLinearVelocity(state, velocities[k]);
  }
  const double time = std::stod(words[2]);
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(1e-9);
  integrator.setMaximumStepSize(time / 2000);
  SimTK::TimeStepper stepper(system, integrator);
  stepper.initialize(state);
  stepper.stepTo(time);
  for (const auto &body : bodies) {
    const SimTK::Vec3 place = body.getBodyOriginLocation(integrator.getState());
    const SimTK::SpatialVec motion = body.getBodyVelocity(integrator.getState());
    for (const SimTK::Vec3 &each : {place, motion[1], motion[0]}) {
      std::printf("%.16g %.16g %.16g ", each[0], each[1], each[2]);
    }
    std::puts("");
  }
}
"""


def _simbody(places, velocities, sizes, time, lines, folder, floor=""):
    """`sizes` are radii and densities. The second half of all balls have the material `other`, if lines have it."""
    if not any(" other" in line for line in lines):
        lines = [*lines, "const SimTK::ContactMaterial other = material;"]
    (folder / "lines").write_text("\n".join(lines) + "\n")
    (folder / "main.cpp").write_text(SIMBODY)
    np.savetxt(folder / "balls", np.column_stack([places, velocities, *sizes]), fmt="%.17g")
    libraries = ["-lSimTKsimbody", "-lSimTKmath", "-lSimTKcommon"]
    _run("c++", "-std=c++17", "-w", "-I/usr/include/simbody", "main.cpp", "-o", "main", *libraries, folder=folder)
    out = _run("./main", "balls", f"{time:.17g}", floor or "none", str((len(places) + 1) // 2), folder=folder)
    rows = np.array([line.split() for line in out.splitlines()], dtype=float)
    return rows[:, :3], rows[:, 3:6], rows[:, 6:]


def simbody(pairs, lines, folder):
    places, speeds = np.concatenate([pairs.first, pairs.second]), np.concatenate(pairs.velocity)
    time = pairs.step * pairs.steps
    return pairs.outcome(*_simbody(places, speeds, (pairs.radii, pairs.densities), time, lines, folder))


def drop(program, ball, speed, lines, contact_time, folder):
    """ε of one ball that meets the plane z = 0 head-on."""
    step = contact_time / 8000
    place, velocity = np.array([[0, 0, ball.radius + 3 * step * speed]]), np.array([[0, 0, -speed]])
    if program == "simbody":
        sizes = [ball.radius], [ball.density]
        return _simbody(place, velocity, sizes, 30000 * step, lines, folder, "floor")[1][0, 2] / speed
    if program == "mujoco":
        floor = '<geom type="plane" size="1 1 1"/>'
        return _mujoco(place, velocity, ball, (step, 30000), lines, folder, floor)[1][0, 2] / speed
    command, wall = {"lammps": "lmp"}.get(program, program), lines[-1]
    if command == "liggghts":  # which does not run without a law for pairs
        words = wall.partition("wall/gran ")[2].replace("primitive type 2 zplane 0.0 ", "")
        lines = [*lines[:-1], f"pair_style gran {words}", "pair_coeff * *", wall]
    balls = place, velocity, np.array([ball.radius]), np.array([ball.density])
    return molecular(command, balls, lines, (step, 30000), folder)[1][0, 2] / speed
