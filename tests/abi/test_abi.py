"""Programs that are linked with the library go on running: what it exports, and how its structures lie in memory, are
those of the stored lists. STOSS_LIBRARY is the library, CXX its compiler; the lists of C++ are those of Debian 12."""

import os
import platform
import re
import shutil
import subprocess

import abi
import pytest

LIBRARY = os.environ.get("STOSS_LIBRARY", "")
of_this_machine = pytest.mark.skipif(
    platform.machine() != "x86_64" or shutil.which("clang++") is None, reason="needs x86-64 and clang++"
)


@pytest.fixture(scope="module")
def symbols():
    return abi.exported(LIBRARY)


def complain(name, now):
    before, _ = abi.stored()
    lines = abi.problems({name: before[name]}, {name: now}, os.path.relpath(LIBRARY, abi.ROOT))
    assert not lines, "\n".join(["", *lines])


def test_the_interface_in_c_is_the_one_that_is_stored():
    complain("c.txt", abi.declarations())


def test_all_that_is_declared_in_c_is_exported_and_nothing_else(symbols):
    assert abi.functions(abi.declarations()) == {name for _, name in symbols if name.startswith("stoss_")}


@of_this_machine
def test_the_names_in_cpp_are_those_that_are_stored(symbols):
    complain("cpp.txt", abi.public_names(symbols))


@of_this_machine
def test_structures_lie_as_is_stored():
    complain("layouts.txt", abi.layouts())


def test_nothing_of_other_libraries_is_exported(symbols):
    own = re.compile(r"stoss_\w+$|(typeinfo (name )?for |vtable for |guard variable for )?(\S+ )*stoss::")
    assert len(symbols) > 400
    assert not [name for _, name in symbols if not own.match(name)]


def test_the_lists_are_those_of_this_soversion():
    assert abi.stored()[1] == {abi.soversion()}


@pytest.mark.skipif(shutil.which("ninja") is None, reason="needs ninja")
def test_a_shared_library_is_built_with_this_soversion_and_these_exports(tmp_path):
    options = ["-DBUILD_SHARED_LIBS=ON", "-DSTOSS_BUILD_CLI=OFF", "-G", "Ninja"]
    subprocess.run(["cmake", "-S", abi.ROOT, "-B", tmp_path, *options], check=True, capture_output=True)
    ninja = (tmp_path / "build.ninja").read_text(encoding="utf-8")
    assert f"SONAME = libstoss.so.{abi.soversion()}\n" in ninja
    assert re.search(r"LINK_FLAGS = .*--version-script=\S*/cmake/exports\.map", ninja)


BEFORE = {"c.txt": ["int stoss_a(int x)", "int stoss_b(void)"]}


def test_what_is_gone_or_changed_asks_for_another_soversion():
    for now in ([BEFORE["c.txt"][0]], ["int stoss_a(long x)", BEFORE["c.txt"][1]]):
        first, *others = abi.problems(BEFORE, {"c.txt": now}, "libstoss.a")
        assert "gone or changed" in first and "raise STOSS_SOVERSION in CMakeLists.txt" in first
        assert "abi.py --renew libstoss.a" in first and "\n" not in first
        assert len(others) == len(set(now) - set(BEFORE["c.txt"]))


def test_what_is_new_asks_for_one_command():
    (line,) = abi.problems(BEFORE, {"c.txt": [*BEFORE["c.txt"], "int stoss_c(void)"]}, "libstoss.a")
    assert line == "c.txt: new: 'int stoss_c(void)'; run python3 tests/abi/abi.py --add libstoss.a"
    assert not abi.problems(BEFORE, BEFORE)


def test_nothing_is_added_while_something_is_gone(monkeypatch, tmp_path):
    monkeypatch.setattr(abi, "HERE", tmp_path)
    lists = {"c.txt": ["int stoss_a(int x)"], "cpp.txt": ["stoss::a()"], "layouts.txt": ["stoss::A: 8 bytes"]}
    abi.write(lists)
    monkeypatch.setattr(abi, "present", lambda library: {**lists, "cpp.txt": ["stoss::b()"]})
    with pytest.raises(SystemExit, match="gone or changed: 'stoss::a"):
        abi.main(["--add", "libstoss.a"])
    assert abi.stored()[0] == lists
    monkeypatch.setattr(abi, "present", lambda library: {**lists, "cpp.txt": ["stoss::a()", "stoss::b()"]})
    abi.main(["--add", "libstoss.a"])
    assert abi.stored() == ({**lists, "cpp.txt": ["stoss::a()", "stoss::b()"]}, {abi.soversion()})


@pytest.mark.skipif(shutil.which("clang++") is None, reason="needs clang++")
def test_a_member_more_or_another_order_is_another_layout(monkeypatch, tmp_path):
    header = tmp_path / "stoss/a.hpp"
    header.parent.mkdir()
    monkeypatch.setattr(abi, "INCLUDE", tmp_path)
    monkeypatch.setattr(abi, "HEADERS", [header.relative_to(tmp_path)])
    found = []
    for members in ("double x; double y;", "double y; double x;", "double x; double y; int z;"):
        header.write_text(f"namespace stoss {{\n\nstruct A {{\n  {members}\n}};\n\n}}  // namespace stoss\n")
        found += abi.layouts()
    assert found[0] == "stoss::A: 16 bytes, aligned to 8: 0 double x; 8 double y" and len(set(found)) == 3
