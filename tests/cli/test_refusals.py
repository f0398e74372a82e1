"""What the command refuses by itself, or hands over in the core's words: one line, the right code, nothing on stdout.
Numbers out of the ranges of the table of inputs are in parts/test_inputs.cpp, bodies in tests/encounter."""

import pathlib
import zipfile

import pytest

FILES = pathlib.Path(__file__).parents[2] / "examples" / "any_body"
BALL = "--body sphere --poisson 0.3"
DISK = "--body disk --poisson 0.33"
SOLID = "--body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"
STEEL = "--body sphere --material 'structural steel' --radius 0.005"

# A call, and what its line begins with.
CALLS = f"""
modes --body disk --poisson 1.5 | poisson: got 1.5, allowed -0.95 to 0.995
modes --body disk --poisson 0.9950000000001 | poisson: got 0.9950000000001, allowed
modes {DISK} --cutoff 1e9 | cutoff: got 1000000000
modes --poisson 0.3 --plane strain | plane: got --plane with --body sphere, allowed only with --body disk
restitution --speed 0.1 --poisson 0.3 --length 1 | length: got --length with --body sphere
impact {DISK} --speed 0.1,0.2 | speed: got 2 numbers, allowed one (stoss restitution takes lists)
impact {DISK} --speed 0.1 --every 0 | every: got 0, allowed 1 or more
impact {DISK} --speed 0.1 --every 3 | every: got --every without --trajectory
impact {DISK} --speed 0.1 --against wall,hardness=100 | against: got 'hardness', allowed roughness, u0 with wall
impact {DISK} --speed 0.1 --against exponential,hardness=inf | against hardness: got 'inf'
impact {DISK} --speed 0.1 --tail none | tail: got none at smooth faces, allowed static or radiating
impact {DISK} --speed 0.1 --nodes 1e99 | nodes: got '1e99'
impact {DISK} --speed 0.1 --mode -1,0,energy=0.1 | vibration: got mode (-1, 0) of the first
restitution {DISK} --speed 0.1,,0.2 | speed: got '0.1,,0.2'
restitution {DISK} --speed 0.1m/s | speed: got '0.1m/s'
restitution {DISK} --speed log:0:0.2:5 | speed: got 'log:0:0.2:5'
restitution {DISK} --speed 0.5,1.5 | speed: got 1.5, allowed 1e-8 to 1 c
restitution {DISK} --speed lin:0.5:1.5:4 | speed: got 1.16667 of 'lin:0.5:1.5:4', allowed 1e-8 to 1 c
restitution --body disk --poisson lin:0:0.5:1001 --speed lin:0.1:0.2:1000 | speed: got 1000 speeds for each of 1001 Poisson's ratios
restitution --body disk --poisson 0.33,1 --speed 0.1 | poisson: got 1, allowed -0.95
restitution {DISK} --speed 0.1 --threads 5000 | threads: got 5000
restitution --body disk --poisson 0.3,0.2 --speed 1 --young 1e9 --density 1000 --radius 1 | poisson: got 2 numbers with a material
restitution {DISK} --speed 1 --young 1e9 | material: got disk without density, allowed young, density and sizes
restitution {DISK} --speed 1 --plane strain | material: got disk without young
restitution {SOLID} --speed 10000 | speed: got 10000, allowed 5.1722e-05 to 5172.19 m/s
restitution {BALL} --speed 0.1 --yield-strength 1e9 | yield_strength: got 1000000000, allowed 0 to 1
restitution {BALL} --speed 0.1 --yield-strength 1e-4 | speed: got 0.1 c, allowed up to
restitution {BALL} --speed 0.1 --yield-rate 0.1 | yield_strength: missing (there is a yield_rate)
restitution --body rod --speed 0.1 --poisson 0.3 | poisson: got --poisson with --body rod
restitution --body rod --speed 0.1 --rigid-body | rigid-body: got --rigid-body with --body rod, allowed only with --body sphere or disk
restitution --body rod --speed 0.1 --young 1e9 --density 1e3 --length 1 | area: missing (a material needs it too, in m^2)
restitution {SOLID} --speed 1 --yield-strength 1e9 --rigid-body --against half-space,young=1e9,density=1e3 | yield_strength: 'rigid sphere poisson=0.3' is rigid, and does not yield
restitution {BALL} --speed 0.1 --against spere | against: got 'spere', allowed wall, same, disk, sphere, hollow-sphere, rod, half-space, half-plane, plate, strip, exponential, did you mean sphere?
restitution {BALL} --speed 0.1 --against disk | against: got disk for a sphere, allowed wall, same, sphere, hollow-sphere, half-space, plate or modal
restitution {BALL} --speed 0.1 --against sphere,length=2 | against: got 'length', allowed poisson, radius, young, density, loss_time, quality, extra_mass, roughness, u0, coat, coat_young, coat_poisson, coat_quality, yield_strength, yield_hardening, yield_rate, rigid, relaxation, young_is, material, c_p, c_s with sphere
restitution {BALL} --speed 0.1 --against sphere,raduis=2 | against: got 'raduis'
restitution {BALL} --speed 0.1 --against sphere, | against: got ''
restitution {BALL} --speed 0.1 --against , | against: got ''
restitution {BALL} --speed 0.1 --against sphere,radius | against: got 'radius' without a value, allowed radius=NUMBER
restitution {BALL} --speed 0.1 --against sphere,radius=2,radius=2 | against: got radius twice, allowed once
restitution {BALL} --speed 0.1 --against sphere,radius= | against radius: got ''
restitution {BALL} --speed 0.1 --against sphere,radius=2=3 | against radius: got '2=3'
restitution {BALL} --speed 0.1 --against sphere,radius=-2 | against radius: got -2
restitution {BALL} --speed 0.1 --against sphere,radius=1e4 | radius ratio: got 10000
restitution {BALL} --speed 0.1 --against sphere,yield=1e9 | against: got 'yield'
restitution {BALL} --speed 0.1 --against half-space,material=glass | against: has a material, but the first body is dimensionless
restitution {SOLID} --speed 1 --against sphere,radius=2 | against: got sphere without young
restitution {SOLID} --speed 1 --against half-space,material=glass,young=1 | against young: the material has it already
restitution {BALL} --speed 0.1 --rigid-body | rigid: got a rigid sphere against wall
restitution {BALL} --speed 0.1 --loss-time nan | loss_time: got 'nan'
restitution {BALL} --speed 0.1 --against sphere,loss_time=1e9 | against loss_time: got 1000000000, allowed 0 to 100000
restitution --body sphere --speed 0.1 --material steal --radius 1 | material: got 'steal', allowed structural steel, glass
restitution --body sphere --speed 0.1 --material steel --radius 1 | material: got 'steel', allowed 'structural steel' (yields at 235 MPa)
restitution --body sphere --speed 0.1 --material Gless --radius 1 | material: got 'Gless'
restitution {STEEL} --speed 0.1 --young 1e9 | young: the material has it already
restitution --body sphere --speed 0.1 --material glass --radius 0.01 --loss-time 31 | loss_time: got 31, allowed 0 to 0.18898
restitution {BALL} --speed 0.1 --against plate | against thickness: missing
restitution {BALL} --speed 0.1 --against plate,thickness=1/ | against: got ''
restitution {BALL} --speed 0.1 --against plate,thickness=1/young=2/young=3 | against layer 2 thickness: missing
restitution {BALL} --speed 0.1 --against plate,thickness=1/thickness=1,loss_time=0 | against: got 'loss_time', allowed thickness, poisson, young, density, material
restitution {BALL} --speed 0.1 --against half-space/young=2 | against layers: got 2, allowed 1 of a half-space
restitution {STEEL} --speed 1 --against plate,thickness=4e-3,material=glass/thickness=1e-3 | against: got plate without young
restitution {BALL} --speed 0.1 --against half-space,young=1e-7 | young ratio: got 1e-07, allowed 1e-6 to 1e6 (of the half-space to the body; beyond, the stiffer one is rigid: let the first be rigid (--rigid-body))
restitution {BALL} --extra-mass -1 --speed 0.1 | extra_mass: got -1, allowed 0 or more (a mass fixed to the body)
restitution --body disk --poisson 0.3 --extra-mass 1 --speed 0.1 | extra-mass: got --extra-mass with --body disk, allowed only with --body sphere or hollow-sphere
oblique {BALL} --extra-mass 1 --speed 0.1 --angle 30 --friction 0.1 | extra_mass: friction turns a body, and how this mass turns is not known
restitution {BALL} --speed 0.1 --against half-space,young=1e7 | young ratio: got 1e+07, allowed 1e-6 to 1e6 (of the half-space to the body; beyond, the stiffer one is rigid: let it be a wall (--against wall))
restitution {BALL} --speed 0.1 --against sphere,young=1e7 | young ratio: got 1e+07, allowed 1e-6 to 1e6 (of the second body to the first; beyond, the stiffer one is rigid: let the second be rigid (--against ...,rigid=1))
restitution {BALL} --speed 0.1 --mode 2,0 | mode: got '2,0', allowed ORDER,INDEX,energy=SHARE
restitution {BALL} --speed 0.1 --mode 2,0,phase=1 | mode: got '2,0,phase=1' without energy, allowed ORDER,INDEX,energy=SHARE, also with phase, of
restitution {BALL} --speed 0.1 --mode 2,0,energ=1 | mode: got 'energ', allowed energy, phase, of, did you mean energy?
restitution {BALL} --speed 0.1 --mode 2.5,0,energy=1 | mode: got '2.5'
restitution {BALL} --speed 0.1 --mode 2,0,energy=nan | mode energy: got 'nan'
restitution {BALL} --speed 0.1 --mode 2,0,energy=0.1,of=third | mode of: got 'third', allowed first, second
restitution {BALL} --speed 0.1 --mode 2,0,energy=1 --mode 2,0,energy=1 | vibration: got mode (2, 0) of the first body twice, allowed once
bounce {BALL} --speed 0.05 --cutoff 12 | flight_time: got neither it nor gravity
bounce {BALL} --speed 0.05 --cutoff 12 --flight-time 1 --gravity 1 | flight_time: got it and gravity
bounce {BALL} --speed 0.05 --cutoff 12 --flight-time 1 --against same | against: got a free body
distribution {BALL} --speed 0.01 | temperature: got neither --temperature and --spectrum, allowed one of the two
distribution {BALL} --speed 0.01 --temperature 1 --spectrum 2,0,energy=1 | temperature: got both
distribution {BALL} --speed 0.01 --spectrum 2,0,energy=1 --highest 10 | highest: got --highest with --spectrum
distribution {BALL} --speed 0.01 --spectrum 2,0,energy=1,phase=1 | spectrum: got 'phase', allowed energy, of
oblique --body rod --friction 0.3 --speed 0.1 | friction: not available for 'rod', but for disks
oblique {BALL} --friction 0.2 --speed 0.5 --angle 80 | tangential: got 2.8
oblique {BALL} --friction 0.2 --speed 0.05 --second-spin 0.1 | second_spin: got one that is not 0, allowed only 0
oblique {BALL} --friction 0.2 --speed lin:0.1:1:2000 --spin lin:0:1:2000 | speed: got 4000000 values in all
quasistatic {DISK} --speed 0.1,0.2 | speed: got 0.2, allowed 1e-100 to 0.186546 c
quasistatic {SOLID} --speed 1000 | speed: got 1000, allowed 5.17
quasistatic {DISK} --speed 0.1 --cutoff 1 | cutoff: got 1,
quasistatic {DISK} --compression 0.01,0.3 | compression: got 0.3, allowed 1e-12 to 0.263448 R
quasistatic {BALL} --compression lin:0.1:0.5:4 | compression: got 0.366667 of 'lin:0.1:0.5:4', allowed 1e-12 to 0.280321 R
quasistatic {BALL} --compression 0.01 --cutoff 10 | cutoff: got --cutoff with --compression
quasistatic {DISK} --speed 0.1 --law hertz | law: got hertz with --body disk, allowed center or diameter
quasistatic {BALL} --speed 0.5 --against half-space | speed: got 0.5, allowed 1e-12 to
quasistatic {BALL} --speed 0.1 --against half-space --law diameter | law: got diameter with --body sphere
quasistatic {BALL} --speed 0.1 --against half-space --cutoff 9 | cutoff: got --cutoff with --against half-space
quasistatic {BALL} --compression 0.1 --against half-space | compression: got --compression with --against half-space
quasistatic {BALL} --speed 0.1 --against half-space,loss_time=1 | against loss_time: got one, allowed none
quasistatic {BALL} --speed 0.1 --against half-space,relaxation=@none | against relaxation
quasistatic {BALL} --speed 0.1 --against half-space,young=1e7 | young: got 1
quasistatic {BALL} --speed 0.1 --against same | against: got same, allowed a smooth wall, or with --body sphere a half-space
quasistatic {BALL} --speed 0.1 --against wall,roughness=0.1 | against: got wall with numbers
quasistatic {DISK} --speed 0.1 --against half-plane | against: got half-plane
quasistatic {BALL} --speed 0.1 --law diameter | law: got diameter with --body sphere, allowed center or hertz
predict --body disk --poisson 0.3 --young 2e11 --density 7800 --radius 0.01 --speed 1 | body: got a disk
predict {BALL} --speed 0.1 | material: missing
predict {STEEL} --speed 1 --quick --format json | quick: got --quick with --format, allowed only without
predict {STEEL} --height 0 | height: got 0
predict {STEEL} --speed 1 --uncertainty young | uncertainty: got 'young', allowed NAME=U
predict {STEEL} --speed 1 --uncertainty colour=1 | uncertainties: got 'colour'
predict {STEEL} --speed 0.1 --uncertainty young=0.1 --uncertainty young=0.2 | uncertainty young: given twice, allowed once
restitution {BALL} --height 1 | height: needs a body with a material
table {DISK} --speed 0.1 | speed: got '0.1', allowed LOW:HIGH
table {DISK} --speed 0.1: | speed: got ''
table {DISK} --speed 0.2:0.1 | speed: got '0.2:0.1', allowed a lower end below the higher one
table {DISK} --speed 0.01:0.1 --name 2x | name: got '2x'
table {DISK} --speed 0.01:0.1 --name x --format json | name: got --name with --format json, allowed only with --format c, rust or js
table {DISK} --speed 0.01:0.1 --beyond error --format two-column | beyond: got --beyond with --format two-column
table {DISK} --speed 0.01:0.1 --ratio 1:2 | ratio
table {DISK} --speed 0.01:0.1 --ratio 1:2 --against same --format two-column | ratio: got --ratio with --format two-column
table {DISK} --speed 0.01:0.1 --friction 0.3 | friction: got --friction, allowed only with --oblique
table {DISK} --speed 0.01:0.1 --oblique | friction: missing, above 0 to 5
table {BALL} --speed 0.01:0.1 --friction 0.3 --oblique | friction: got 0.3, allowed none
table {BALL} --speed 0.01:0.1 --oblique --format two-column | speed: got '0.01:0.1'
table --body rod --speed 0.01:0.1 --oblique | friction: not available for 'rod'
table {BALL} --speed 0.01:0.1 --oblique --format netcdf | output: missing, a file
table {DISK} --speed 0.01:0.1 --format netcdf -o x.nc | format: got netcdf, allowed only with --oblique
table {STEEL} --speed 1:2 --adhesion 0.1 | adhesion: got --adhesion, allowed only with --predict
table {STEEL} --speed 1:2 --predict --oblique | oblique: got --oblique with --predict, allowed only without
fit --body disk --poisson 0.3 --speed 0.1:0.2 --law tsuji | body: got disk, allowed sphere
restitution --speed 0.1 --body @{FILES}/bar.json --radius 1 | radius: got --radius
restitution --speed 0.1 --body @{FILES}/bar.json --material glass | material: the body file has one already
restitution --speed 0.1 --body @{FILES}/beam_0.json | curvature
restitution --speed 0.1 {BALL} --against @{FILES}/bar.json | against: has a material
"""
PAIRS = [line.split(" | ") for line in CALLS.strip().splitlines()]


@pytest.mark.parametrize("words, said", PAIRS, ids=[" ".join(words.split()[:1]) for words, _ in PAIRS])
def test_bad_input_is_one_line(stoss, words, said):
    result = stoss.run(words)
    assert (result.returncode, result.stdout) == (3, ""), result.stderr
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {said}") and (": got " not in line or "allowed" in line), line


def test_files_of_bodies_that_are_none(stoss, tmp_path):
    for name, text, said in (("broken", '{"format": "stoss modal body 1", "mass": 1}', "curvature: missing"),
                             ("wrong", "mass = 1", "not a JSON document")):  # fmt: skip
        (tmp_path / name).write_text(text)
        for option in (f"--body @{tmp_path}/{name}", f"{SOLID} --against @{tmp_path}/{name}"):
            result = stoss.run("restitution --speed 0.1", option)
            assert result.returncode == 3 and said in result.stderr and result.stderr.count("\n") == 1
    with zipfile.ZipFile(tmp_path / "packed.npz", "w") as archive:
        archive.writestr("mass.npy", b"")
    result = stoss.run(f"restitution --speed 0.1 --body @{tmp_path}/packed.npz")
    assert result.returncode == 3 and "an NPZ file, allowed JSON (in Python: stoss.ModalBody.read(" in result.stderr


USAGE = f"""
 | subcommand
rebound | unknown argument: rebound
modes | --poisson is required
modes {DISK} --colour red | unknown argument: --colour
modes {DISK} extra | unknown argument: extra
modes {DISK} --format xml | --format
impact {DISK} | --speed or --height is required
impact {DISK} --speed | --speed
impact {DISK} --speed 0.1 --tail soft | --tail
restitution --speed 0.1 | --poisson is required
restitution --body ball --poisson 0.33 --speed 0.1 | --body
restitution {DISK} --speed 0.1 --resume | --resume
restitution {SOLID} --plane middle --speed 1 | --plane
oblique {DISK} --speed 0.05 | --friction is required
oblique {BALL} --friction 0.2 --speed 0.05 --angle 30 --tangential 0.01 | --tangential excludes --angle
quasistatic {DISK} | --speed or --compression is required
quasistatic {DISK} --speed 0.1 --compression 0.1 | excludes
quasistatic {DISK} --speed 0.1 --body rod | --body
table {DISK} | --speed or --height is required
table {DISK} --speed 0.1:0.2 --format csv | --format
"""


@pytest.mark.parametrize("words, said", [line.split(" | ") for line in USAGE.strip("\n").splitlines()])
def test_usage(stoss, words, said):
    result = stoss.run(words)
    assert (result.returncode, result.stdout) == (2, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: ") and said in line and "--help" in line


@pytest.mark.parametrize("job", [f"{DISK} --law center", f"{DISK} --law diameter", f"{BALL} --law center", "--body sphere --poisson 0.4999 --law hertz"])
def test_ends_of_ranges_that_are_shown_are_allowed(stoss, job):
    for option in ("--speed 9", "--compression 9"):
        refusal = stoss.run("quasistatic", job, option).stderr
        low, high = (float(word) for word in refusal.split("allowed ")[1].split()[0:3:2])
        more = "--cutoff 9 --quiet" if "speed" in option else "--quiet"
        assert stoss.run("quasistatic", job, f"{option[:-1]}{low!r},{high * (1 - 1e-5)!r}", more).returncode == 0


def test_a_step_that_does_not_resolve_the_motion(stoss):
    words = "--body disk --poisson 0.95 --speed 0.4 --tail static --cutoff 50"
    result = stoss.run("impact", words, "--step 0.02")
    assert result.returncode == 1 and result.stderr.endswith("of the energy is unaccounted for (use a smaller step)\n")
