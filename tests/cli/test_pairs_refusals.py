"""What --body and --against refuse: one line, with the name, what was given and what is allowed."""

import pytest

DISK = "restitution --poisson 0.33 --speed 0.2"
STEEL = "--poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


REFUSED = [
    ("dsk,radius=2", "against", "did you mean disk?"),
    ("wall,radius=2", "against", "none with wall"),
    ("same,radius=2", "against", "none with same"),
    ("disk,raduis=2", "against", "did you mean radius?"),
    ("disk,length=2", "against", "allowed poisson, radius, young, density, loss_time, material with disk"),
    ("disk,", "against", "''"),
    (",", "against", "''"),
    ("disk,radius", "against", "allowed radius=NUMBER"),
    ("disk,radius=2,radius=2", "against", "twice"),
    ("disk,radius=", "against radius", "''"),
    ("disk,radius=nan", "against radius", "'nan'"),
    ("disk,radius=1e400", "against radius", "1e400"),
    ("disk,radius=2=3", "against radius", "2=3"),
    ("disk,radius=0", "against radius", "0"),
    ("disk,young=-1", "against young", "-1"),
    ("disk,density=-1", "against density", "-1"),
    ("disk,poisson=1", "against poisson", "1"),
    ("disk,radius=1e4", "radius ratio", "10000"),
    ("disk,young=1e4", "young ratio", "10000"),
    ("rod", "against", "a disk meets disks"),
    ("exponential", "against", "exponential"),
]


@pytest.mark.parametrize("against, name, said", REFUSED)
def test_refusals(stoss, tmp_path, against, name, said):
    path = tmp_path / "x.csv"
    path.write_text("precious")
    result = stoss.run(DISK, f"-o {path} --against", against)
    assert (result.returncode, result.stdout, path.read_text()) == (3, "", "precious")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line
    if against != "exponential":
        other = stoss.run("impact --poisson 0.33 --speed 0.2 --cutoff 20 --against", against)
        assert other.returncode == 3 and name in other.stderr and said in other.stderr


@pytest.mark.parametrize(
    "arguments, name, said",
    [
        (f"{STEEL} --against disk,radius=2", "against", "without young"),
        (f"{STEEL} --against disk,young=1e9,density=1e3,radius=-1", "against radius", "-1"),
        (f"{STEEL} --against disk,young=1e9,density=1e3,radius=0.01,poisson=0.5", "against poisson", "0.5"),
        ("--body rod --poisson 0.3", "poisson", "--body rod"),
        ("--body rod --plane strain", "plane", "--body rod"),
        ("--body rod --against disk", "against", "a disk meets disks"),
        ("--body rod --against rod,area=0", "against area", "0"),
        ("--poisson 0.3 --against same --method extrapolate", "against", "extrapolate"),
        ("--body rod --method extrapolate", "against", "extrapolate"),
    ],
)
def test_what_does_not_go_together(stoss, arguments, name, said):
    result = stoss.run("restitution --speed 1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line
