"""Files import each other in one direction only, for types too: results know nothing of pictures."""

import ast
from pathlib import Path

import pytest
import stoss

PACKAGE = Path(stoss.__file__).parent
STUDIES = Path(__file__).parents[3] / "studies"


def imported(path, package):
    """Names of the modules that a file imports, at any place of it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (each.name for each in node.names)
        if isinstance(node, ast.ImportFrom):
            above = package[: len(package) + 1 - node.level] if node.level else []
            module = ".".join([*above, *filter(None, [node.module])])
            yield from (module, *(f"{module}.{each.name}" for each in node.names))


@pytest.mark.parametrize("root, name, some", [(PACKAGE, "stoss", 80), (STUDIES, "", 30)])
def test_no_circles(root, name, some):
    paths = [path for path in root.rglob("*.py") if path.name != "__main__.py"]
    parts = {path: [*filter(None, [name]), *path.relative_to(root).with_suffix("").parts] for path in paths}
    files = {".".join(own).removesuffix(".__init__"): path for path, own in parts.items()}
    needs = {each: {*imported(path, parts[path][:-1])} & {*files} - {each, name} for each, path in files.items()}
    # The packages themselves collect their modules, which do not need what they collect.
    needs = {each: own - {"stoss.plot"} if each.startswith("stoss.plot.") else own for each, own in needs.items()}
    assert len(needs) > some
    while free := [each for each, own in needs.items() if not own]:
        needs = {each: own - {*free} for each, own in needs.items() if each not in free}
    assert not needs
