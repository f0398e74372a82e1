"""The frequencies that CalculiX finds on the same mesh."""

import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import UNITS

BOX = 'SetFactory("OpenCASCADE");\nBox(1) = {-2, -1, -0.5, 4, 2, 1};\n'
CONVERT = """
import gmsh
gmsh.initialize(); gmsh.option.setNumber("General.Terminal", 0); gmsh.open("box.msh")
tags, x, _ = gmsh.model.mesh.getNodes()
_, cells = gmsh.model.mesh.getElementsByType(11)
order = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]  # the last two edges change places
with open("box.inp", "w") as out:
    out.write("*NODE\\n")
    for tag, p in zip(tags, x.reshape(-1, 3)):
        out.write(f"{tag},{p[0]:.12g},{p[1]:.12g},{p[2]:.12g}\\n")
    out.write("*ELEMENT,TYPE=C3D10,ELSET=ALL\\n")
    for i, c in enumerate(cells.reshape(-1, 10)):
        out.write(f"{i + 1},{','.join(str(c[j]) for j in order)}\\n")
    out.write("*MATERIAL,NAME=M\\n*ELASTIC\\n1,0.3\\n*DENSITY\\n1\\n")
    out.write("*SOLID SECTION,ELSET=ALL,MATERIAL=M\\n")
    out.write("*STEP\\n*FREQUENCY\\n26\\n*END STEP\\n")
gmsh.finalize()
"""


LIKE_CALCULIX = """
import sys
from stoss.modal import _elasticity
from stoss.modal.__main__ import main
_elasticity.DEGREE = 2  # CalculiX integrates masses too at four points only
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed")
def test_frequencies_of_a_box(modal):
    modal.gmsh(BOX, "box.msh", 0.35)
    (modal.folder / "like_calculix.py").write_text(LIKE_CALCULIX)
    place = "--point 0,0,0.5 --normal 0,0,1"
    words = f"box.msh {place} {UNITS} --poisson 0.3 --modes 15 --errors-unknown"
    exact = frequencies(modal.body(words, name="box.json"))
    alike = frequencies(modal.body(words, name="alike.json", program=("like_calculix.py",)))
    subprocess.run([sys.executable, "-c", CONVERT], cwd=modal.folder, check=True, timeout=60)
    subprocess.run(["ccx", "box"], cwd=modal.folder, check=True, timeout=100, capture_output=True)
    text = (modal.folder / "box.dat").read_text()
    rows = re.findall(r"^ +\d+ +\S+ +\S+ +(\S+) +\S+$", text, re.MULTILINE)
    theirs = np.array([float(row) for row in rows[:26]])[6:]
    assert len(exact) >= 15
    assert alike[:15] == pytest.approx(theirs[:15], rel=1e-6)
    assert exact[:15] == pytest.approx(theirs[:15], rel=1e-3)


def frequencies(body):
    return np.array(body["modes"]["frequency"])
