#!/usr/bin/env python3
"""What programs that are linked with the library rely on, as lists: the declarations of the C interface (c.txt), the
public names that the shared library exports in C++ (cpp.txt), and how public structures lie in memory (layouts.txt).

    abi.py --add LIBRARY      puts what is new into the lists
    abi.py --renew LIBRARY    writes them anew: for another STOSS_SOVERSION

LIBRARY is libstoss.a, of which a shared library is made here, or libstoss.so. CXX and CLANG name the compilers.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
INCLUDE = ROOT / "include"
HEADERS = sorted(path.relative_to(INCLUDE) for path in INCLUDE.glob("stoss/**/*.h*"))


def output(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"abi: {words[0]} failed: {done.stderr.strip()}")
    return done.stdout


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)


def soversion():
    """That of the project."""
    return int(re.search(r"set\(STOSS_SOVERSION (\d+)\)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1])


def declarations():
    """The macros, structures and functions of stoss.h, one a line."""
    text = without_comments((INCLUDE / "stoss/stoss.h").read_text(encoding="utf-8")).replace("\\\n", " ")
    macros = [" ".join(line.split()) for line in re.findall(r"^#define STOSS_\w+ .*", text, re.MULTILINE)]
    text = re.sub(r"^#.*|extern \"C\" \{", "", text, flags=re.MULTILINE)
    statements = re.findall(r"(?:[^;{]|\{[^}]*\})+(?=;)", text)
    return macros + [" ".join(each.split()) for each in statements]


def functions(lines):
    """The names of the functions among declarations."""
    return {found[1] for line in lines if (found := re.match(r"(?!typedef)[^(]*\b(stoss_\w+)\(", line))}


def exported(library):
    """Kind and name of all that a shared library exports; of an archive, what one made of it would."""
    if Path(library).suffix != ".a":
        lines = output("nm", "--dynamic", "--demangle", "--defined-only", library).splitlines()
        return [tuple(line.split(maxsplit=2)[1:]) for line in lines]
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "libstoss.so"
        whole = ["-Wl,--whole-archive", library, "-Wl,--no-whole-archive", f"-Wl,--version-script={ROOT}/cmake/exports.map"]
        output(os.environ.get("CXX", "c++"), "-shared", *whole, "-pthread", "-o", made)
        return exported(made)


def public_names(symbols):
    """The functions and variables in C++ all of whose words are in a public header; without those that are made where
    they are used, which depend on the compiler."""
    text = " ".join(without_comments((INCLUDE / header).read_text(encoding="utf-8")) for header in HEADERS)
    words = set(re.findall(r"\w+", text))
    names = {name for kind, name in symbols if kind in "TDBR" and name.startswith("stoss::")}
    own = {name: re.sub(r"\[abi:\w+\]|\(.*", "", name).replace("~", "").split("::") for name in names}
    return sorted(name for name, parts in own.items() if words.issuperset(parts))


def records():
    """The names of all public structures."""
    for header in HEADERS:
        space, before = "", ""
        for line in (INCLUDE / header).read_text(encoding="utf-8").splitlines():
            if found := re.match(r"namespace ([\w:]+) \{", line):
                space = found[1] + "::"
            found = re.match(r"(?:struct|class) (\w+)(?: final)?(?: :[^;]*)? \{|typedef struct (\w+) \{", line)
            if found and not before.startswith("template"):
                yield found[2] or space + found[1]
            before = line


def layouts():
    """Size, alignment and members with their places of each public structure, one a line."""
    wanted = list(records())
    lines = [f'#include "{header}"' for header in HEADERS] + [f"static_assert(sizeof({name}) > 0);" for name in wanted]
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "all.cpp"
        source.write_text("\n".join(lines) + "\n", encoding="utf-8")
        dump = ["-fsyntax-only", "-Xclang", "-fdump-record-layouts"]
        text = output(os.environ.get("CLANG", "clang++"), "-std=c++20", f"-I{INCLUDE}", *dump, source)
    found = {}
    for block in text.split("*** Dumping AST Record Layout\n")[1:]:
        name = re.match(r" *0 \| (?:struct|class|union) (.+?)(?: \(empty\))?\n", block)
        members = re.findall(r"^ *([\d:-]+) \|   (\S.*)$", block, re.MULTILINE)
        size, alignment = re.search(r"\[sizeof=(\d+), .*?align=(\d+)", block).groups()
        shown = "; ".join(f"{place} {re.sub(r'(class|struct|enum|union) ', '', member)}" for place, member in members)
        if name:
            found[name[1]] = f"{name[1]}: {size} bytes, aligned to {alignment}: {shown}"
    missing = [name for name in wanted if name not in found]
    if missing:
        raise SystemExit(f"abi: the compiler does not say how these lie: {' '.join(missing)}")
    return sorted(found[name] for name in wanted)


def present(library):
    """The lists as they would have to be now."""
    symbols = exported(library)
    declared, in_c = declarations(), {name for _, name in symbols if name.startswith("stoss_")}
    if functions(declared) != in_c:
        raise SystemExit(f"abi: declared or exported alone: {' '.join(sorted(functions(declared) ^ in_c))}")
    return {"c.txt": declared, "cpp.txt": public_names(symbols), "layouts.txt": layouts()}


def stored():
    """The stored lists, and the STOSS_SOVERSION for which they hold."""
    texts = {name: (HERE / name).read_text(encoding="utf-8").splitlines() for name in ("c.txt", "cpp.txt", "layouts.txt")}
    versions = {int(lines[0].split()[-1]) for lines in texts.values()}
    return {name: lines[1:] for name, lines in texts.items()}, versions


def problems(before, now, library="LIBRARY"):
    """What differs, one line each, with what is to be done."""
    lines = []
    tool = "python3 tests/abi/abi.py"
    for name, old in before.items():
        new = now[name]
        lines += [f"{name}: gone or changed: '{each}'; programs that are linked need it: let it be as it was, or raise "
                  f"STOSS_SOVERSION in CMakeLists.txt and run {tool} --renew {library}"
                  for each in old if each not in new]  # fmt: skip
        lines += [f"{name}: new: '{each}'; run {tool} --add {library}" for each in new if each not in old]
    return lines


def write(lists):
    for name, lines in lists.items():
        (HERE / name).write_text("\n".join([f"# libstoss.so.{soversion()}, STOSS_SOVERSION {soversion()}", *lines, ""]))


def main(words):
    if len(words) != 2 or words[0] not in ("--add", "--renew"):
        raise SystemExit(__doc__)
    now = present(words[1])
    if words[0] == "--add":
        gone = [line for line in problems(stored()[0], now, words[1]) if ": gone" in line]
        if gone:
            raise SystemExit("\n".join(gone))
    write(now)


if __name__ == "__main__":
    main(sys.argv[1:])
