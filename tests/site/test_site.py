"""The documentation site: it builds without a warning, its links lead somewhere, its formulas can be set, it asks no
other host for anything, and its reference is complete."""

import html.parser
import importlib.util
import json
import re
import shutil
import subprocess
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
import stoss
import stoss.plot

ROOT = Path(__file__).resolve().parents[2]
SITE = ROOT / "build/docs"
pytestmark = pytest.mark.long
NEEDED = ("sphinx", "furo", "myst_parser", "breathe", "sphinx_copybutton")
if missing := [name for name in NEEDED if importlib.util.find_spec(name) is None]:
    pytest.skip(f"not installed: {', '.join(missing)}", allow_module_level=True)
if shutil.which("doxygen") is None:
    pytest.skip("not installed: doxygen", allow_module_level=True)


class Page(html.parser.HTMLParser):
    """What a page links to, loads and can be linked to by; its formulas, and its text without them."""

    def __init__(self, file):
        super().__init__()
        self.links, self.loaded, self.anchors, self.formulas, self.text = [], [], set(), [], []
        self.inside = None
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[name] for name in ("id", "name") if values.get(name))
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        elif tag == "link" and values.get("rel") in ("stylesheet", "icon", "shortcut icon", "preload"):
            self.loaded.append(values["href"])
        elif "src" in values:
            self.loaded.append(values["src"])
        if "math" in values.get("class", "").split():
            self.formulas.append({"text": "", "display": tag == "div"})
            self.inside = tag

    def handle_endtag(self, tag):
        if tag == self.inside:
            self.inside = None

    def handle_data(self, data):
        if self.inside:
            self.formulas[-1]["text"] += data
        else:
            self.text.append(data)


@pytest.fixture(scope="module")
def pages():
    done = subprocess.run([ROOT / "scripts/docs.sh"], cwd=ROOT, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stdout + done.stderr
    files = [file for file in SITE.rglob("*.html") if "page" not in file.relative_to(SITE).parts]
    return {file: Page(file) for file in files}


def test_links_lead_somewhere(pages):
    dead = []
    for file, page in pages.items():
        for target in page.links + page.loaded:
            parts = urlsplit(target)
            if parts.scheme:
                continue
            there = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            anchor = unquote(parts.fragment)
            if not there.is_file() or anchor and there in pages and anchor not in pages[there].anchors:
                dead.append((str(file.relative_to(SITE)), target))
    assert not dead


def test_nothing_is_loaded_from_another_host(pages):
    loaded = {target for page in pages.values() for target in page.loaded}
    assert loaded and not [target for target in loaded if re.match(r"(\w+:)?//", target)]
    for style in SITE.rglob("*.css"):
        assert not re.search(r"(@import|url\()\s*['\"]?(https?:)?//", style.read_text(encoding="utf-8")), style


def test_text_of_a_link_is_no_name_of_a_page(pages):
    text = "".join(file.read_text(encoding="utf-8") for file in pages)
    links = re.findall(r'<a class="reference internal"[^>]*>(.*?)</a>', text, re.DOTALL)
    assert len(links) > 1000
    assert not [link for link in links if re.fullmatch(r"README|[\w/]+\.md", re.sub(r"<[^>]*>", "", link))]


def test_landing_page_names_licence_citation_and_repository(pages):
    page = pages[SITE / "index.html"]
    assert {"LICENSE", "CITATION.cff"} <= {Path(target).name for target in page.links}
    assert {"Licence", "Cite", "Repository"} <= set(page.text)


def found(queries):
    """For each query the entries, as page#anchor, that the site's own search finds by their names."""
    program = r"""
      const [tools, index, queries] = process.argv.slice(1);
      const vm = require('vm'), fs = require('fs');
      const page = {document: {}, window: {}, _ready: () => {}, _: (text) => text};
      const source = fs.readFileSync(tools, 'utf8') + ';({Search, splitQuery})';
      const {Search, splitQuery} = vm.runInNewContext(source, page);
      Search._index = JSON.parse(fs.readFileSync(index, 'utf8').replace(/^[^(]*[(]/, '').replace(/[)]\s*$/, ''));
      const results = JSON.parse(queries).map((query) => {
        const terms = new Set(splitQuery(query.toLowerCase()));
        return [...terms].flatMap((term) => Search.performObjectSearch(term, terms));
      });
      console.log(JSON.stringify(results.map((places) => places.map(([name, , anchor]) => name + anchor))));"""
    files = (SITE / "_static/searchtools.js", SITE / "searchindex.js")
    done = subprocess.run(
        ["node", "-e", program, *files, json.dumps(queries)], capture_output=True, encoding="utf-8", check=True
    )
    return json.loads(done.stdout)


def help_of(*names):
    command = [ROOT / "build/release/cli/stoss", *names, "--help"]
    return subprocess.run(command, capture_output=True, encoding="utf-8", check=True).stdout


def test_search_finds_every_option_of_the_command(pages):
    if shutil.which("node") is None:
        pytest.skip("not installed: node")
    names = re.findall(r"^  ([a-z]+) ", help_of().partition("Subcommands:")[2], re.MULTILINE)
    options = [
        f"{name} {option}"
        for name in names
        for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_of(name), re.MULTILINE)
        if option != "--help"
    ]
    assert len(names) > 5 and len(options) > 80
    queries = [*options, "--loss-time", "loss-time", "output"]
    for query, places in zip(queries, found(queries)):
        here = [place.partition("#")[::2] for place in places if place.startswith("reference/command/")]
        assert here and all(anchor in pages[SITE / f"{name}.html"].anchors for name, anchor in here), query


def test_formulas_can_be_set(pages):
    node = shutil.which("node")
    if node is None:
        pytest.skip("not installed: node")
    formulas = [formula for page in pages.values() for formula in page.formulas]
    assert len(formulas) > 1000
    program = """
      const katex = require(process.argv[1]);
      for (const {text, display} of JSON.parse(require('fs').readFileSync(0))) {
        try { katex.renderToString(text, {displayMode: display, strict: 'error'}); }
        catch (error) { console.log(error.message); }
      }"""
    command = [node, "-e", program, SITE / "_static/katex/katex.min.js"]
    done = subprocess.run(command, input=json.dumps(formulas), capture_output=True, encoding="utf-8", check=True)
    assert not done.stdout


def test_no_formula_is_left_as_it_was_typed(pages):
    typed = re.compile(r"\$[^$\n]*\\[a-z]+[^$\n]*\$|\\(?:frac|sqrt|omega|begin)\b")
    for file, page in pages.items():
        found = typed.search("".join(page.text))
        assert not found, (file, found)


def test_reference_has_every_public_name(pages):
    anchors = set().union(*(page.anchors for file, page in pages.items() if "python" in file.parts))
    names = {f"stoss.{name}" for name in set(stoss.__all__) - {"__version__", "plot", "quasistatic", "animate"}}
    names |= {f"stoss.{module}.{name}" for module in ("plot", "quasistatic") for name in getattr(stoss, module).__all__}
    assert len(names) > 90 and names <= anchors, names - anchors


def test_reference_has_every_header(pages):
    text = "".join("".join(page.text) for file, page in pages.items() if "cpp" in file.parts)
    rooms = {folder.name for folder in (ROOT / "include/stoss").iterdir() if folder.is_dir()}
    for header in (ROOT / "include").rglob("*.hpp"):
        if header.parent.name != "stoss" or header.stem not in rooms:
            assert str(header.relative_to(ROOT / "include")) in text


def test_every_program_is_in_the_gallery(pages):
    for program in (ROOT / "examples").glob("*.py"):
        page = pages[SITE / f"examples/{program.stem}.html"]
        assert any(source.endswith(".png") for source in page.loaded)
        assert "What it prints" in "".join(page.text)
