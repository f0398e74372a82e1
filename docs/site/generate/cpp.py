"""The pages of the C++ interface, one for each room, and of the C interface."""

import re
import xml.etree.ElementTree as xml
from collections import defaultdict
from pathlib import Path

from tree import ROOT, Tree

FACE = ROOT / "include/stoss"
XML = ROOT / "build/docs-doxygen/xml"


def heading(text: str, line: str) -> list[str]:
    return [text, line * len(text), ""]


def text_of(element: xml.Element | None) -> str:
    return "".join(element.itertext()) if element is not None else ""


def directive(member: xml.Element) -> str:
    """What shows a member of a namespace; a function is told from its like by the types that it takes."""
    kind, name = member.get("kind"), member.findtext("qualifiedname") or member.findtext("name")
    if kind == "function":
        types = ", ".join(text_of(parameter.find("type")) for parameter in member.iterfind("param"))
        return f".. doxygenfunction:: {name}({types})"
    return f".. doxygen{kind}:: {name}"


def shown_class(compound: xml.Element) -> str:
    lines = [f".. doxygen{compound.get('kind')}:: {compound.findtext('compoundname')}", ":members:", ":undoc-members:"]
    return "\n   ".join(lines)


def declared() -> dict[str, list[str]]:
    """For each header the directives that show what it declares, in its order."""
    compounds = [compound for file in sorted(XML.glob("*.xml")) for compound in xml.parse(file).iter("compounddef")]
    classes = {text_of(each.find("compoundname")) for each in compounds if each.get("kind") in ("class", "struct")}
    found: dict[str, list[tuple[int, str]]] = defaultdict(list)

    def add(element: xml.Element, shown: str) -> None:
        for place in element.iterfind("location"):
            header, line = place.get("declfile") or place.get("file"), place.get("declline") or place.get("line")
            found[str(header)].append((int(line or 0), shown))

    for compound in compounds:
        name = text_of(compound.find("compoundname"))
        if compound.get("kind") == "file" or compound.get("kind") == "namespace" and name.startswith("stoss"):
            for member in compound.iter("memberdef"):
                if member.findtext("name") not in classes:  # in C a struct and its typedef have one name
                    add(member, directive(member))
        elif name in classes and name.startswith("stoss") and name.rpartition("::")[0] not in classes:
            add(compound, shown_class(compound))  # with the classes in it
    return {header: [shown for _, shown in sorted(entries)] for header, entries in found.items()}


def offers(shown: list[str]) -> str:
    """The names of what a header declares."""
    names = [re.sub(r"^.*:: (?:[a-z_0-9]+::)*(\w+).*$", r"`\1`", directive.partition("\n")[0]) for directive in shown]
    return ", ".join(dict.fromkeys(names))


def page(title: str, introduction: str, headers: list[str], shown: dict[str, list[str]]) -> str:
    lines = [*heading(title, "="), introduction, ""]
    for header in headers:
        lines += [*heading(f"stoss/{header}", "-"), "\n\n".join(shown.get(f"stoss/{header}", [])), ""]
    return "\n".join(lines)


def headers_in(folder: Path) -> list[str]:
    return sorted(str(file.relative_to(FACE)) for file in folder.rglob("*.hpp"))


def write(tree: Tree) -> None:
    rooms = {room.name: room for room in sorted(FACE.iterdir()) if room.is_dir()}
    common = [file.name for file in sorted(FACE.glob("*.hpp")) if file.stem not in rooms]
    said = "``#include <stoss/{0}.hpp>`` has the whole room."
    shown = declared()
    pages = {name: page(name, said.format(name), headers_in(room), shown) for name, room in rooms.items()}
    pages["common"] = page("common", "What all rooms stand on.", common, shown)
    pages["c"] = page("C", "The library in C; `stoss.f90` has the same for Fortran.", ["stoss.h"], shown)
    for name, text in pages.items():
        tree.write(f"reference/cpp/{name}.rst", text)
    headers = [*common, *(name for room in rooms.values() for name in headers_in(room)), "stoss.h"]
    table = [f"| `stoss/{name}` | {offers(shown.get(f'stoss/{name}', []))} |" for name in headers]
    index = ["# C++ and C", "", "A page for each room of the library ([architecture](../../architecture.md)).", ""]
    index += ["```{toctree}", ":maxdepth: 1", "", *pages, "```", "", "| header | what it offers |", "|---|---|", *table]
    tree.write("reference/cpp/index.md", "\n".join(index) + "\n")
