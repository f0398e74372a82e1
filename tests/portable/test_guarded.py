"""What is carried elsewhere, the static command and the module of the wheel, has what cmake/hardening.cmake asks for."""

import sys

import pytest

from conftest import ROOT, TREE

sys.path.insert(0, str(ROOT / "tests/support"))

import hardened

pytestmark = pytest.mark.skipif(hardened.reason_to_skip(TREE) != "", reason=hardened.reason_to_skip(TREE))


def test_static_command_is_guarded():
    static = TREE / "static/stoss"
    if "\nbuild static/stoss:" not in (TREE / "build.ninja").read_text(encoding="utf-8"):
        pytest.skip("no static command in this build tree")
    assert static.exists()  # the whole tier builds it before
    assert hardened.guards(static) == hardened.GUARDED
    assert hardened.has_no_fixed_address(static)


def test_python_module_is_guarded():
    modules = list((TREE / "python/stoss").glob("_core*.so"))
    assert len(modules) == 1
    assert hardened.guards(modules[0]) == hardened.GUARDED
