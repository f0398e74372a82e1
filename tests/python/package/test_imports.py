"""The package's files import each other in one direction only: results know nothing of pictures."""

import ast
from pathlib import Path

import stoss

ROOT = Path(stoss.__file__).parent


def imported(tree):
    """Names of modules that the code imports when it runs, in functions too; types only are left out."""
    if isinstance(tree, ast.If) and getattr(tree.test, "id", "") == "TYPE_CHECKING":
        return
    if isinstance(tree, ast.ImportFrom) and tree.module:
        yield tree.module
        yield from (f"{tree.module}.{each.name}" for each in tree.names)
    for child in ast.iter_child_nodes(tree):
        yield from imported(child)


def test_no_circles():
    files = {".".join(("stoss", *path.relative_to(ROOT).with_suffix("").parts)): path for path in ROOT.rglob("*.py")}
    files = {name.removesuffix(".__init__"): path for name, path in files.items() if name != "stoss.__main__"}
    needs = {name: {each for each in imported(ast.parse(path.read_text(encoding="utf-8"))) if each in files} - {"stoss"}
             for name, path in files.items()}  # fmt: skip
    # The packages themselves collect their modules, which do not need what they collect.
    needs = {name: each - {"stoss.plot"} if name.startswith("stoss.plot.") else each for name, each in needs.items()}
    assert len(needs) > 30 and "stoss.results._result" in needs["stoss.results._restitution"]
    while free := [name for name, each in needs.items() if not each]:
        needs = {name: each - set(free) for name, each in needs.items() if name not in free}
    assert not needs
