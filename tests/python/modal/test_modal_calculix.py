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
    out.writelines(f"{t},{p[0]!r},{p[1]!r},{p[2]!r}\\n" for t, p in zip(tags, x.reshape(-1, 3).tolist()))
    out.write("*ELEMENT,TYPE=C3D10,ELSET=ALL\\n")
    out.writelines(f"{i + 1},{','.join(str(c[j]) for j in order)}\\n" for i, c in enumerate(cells.reshape(-1, 10)))
    out.write("*MATERIAL,NAME=M\\n*ELASTIC\\n1,0.3\\n*DENSITY\\n1\\n*SOLID SECTION,ELSET=ALL,MATERIAL=M\\n")
    out.write("*STEP\\n*FREQUENCY\\n26\\n*END STEP\\n")
gmsh.finalize()
"""


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed")
def test_frequencies_of_a_box(modal):
    modal.gmsh(BOX, "box.msh", 0.5)
    place = "--point 0,0,0.5 --normal 0,0,1"
    words = f"box.msh {place} {UNITS} --poisson 0.3 --modes 15 --errors-unknown"
    ours = np.array(modal.body(words, name="box.json")["modes"]["frequency"])
    subprocess.run([sys.executable, "-c", CONVERT], cwd=modal.folder, check=True, timeout=60)
    subprocess.run(["ccx", "box"], cwd=modal.folder, check=True, timeout=100, capture_output=True)
    rows = re.findall(r"^ +\d+ +(\S+) +(\S+) +(\S+) +\S+$", (modal.folder / "box.dat").read_text(), re.MULTILINE)
    theirs = np.array([float(row[2]) for row in rows[:26]])[6:]
    assert len(ours) >= 15
    assert ours[:15] == pytest.approx(theirs[:15], rel=1e-6)
