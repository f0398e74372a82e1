"""The pictures of `make demo`: out/restitution.png and out/collision.gif."""

import os
import re
import sys
from pathlib import Path

import stoss

page = (Path(__file__).parents[1] / "docs/howto/plates.md").read_text(encoding="utf-8")
os.chdir(sys.argv[1])

# The picture of docs/howto/plates.md, drawn by the page's own lines.
exec(re.search(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[1])

hit = stoss.impact(poisson=0.33, speed=0.2, cutoff=25)
stoss.animate(hit, "collision.gif", quantity="von_mises")

for name in ("restitution.png", "collision.gif"):
    print(f"Picture: {Path(name).resolve()}")
