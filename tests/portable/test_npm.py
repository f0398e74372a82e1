"""The npm package, packed and installed without network: it says what the command says, and its types hold. The page is
made of the same files."""

import json
import re
import subprocess
import tarfile

import pytest

from conftest import OFFLINE, ROOT, VERSION, run

PACKAGE = ROOT / "build/npm"
TSC = ROOT / "web/node_modules/.bin/tsc"
MODULES = ["first.wasm", "page.wasm", "stoss.wasm"]
pytestmark = [
    pytest.mark.page,
    pytest.mark.skipif(
        not ((PACKAGE / "package.json").exists() and (PACKAGE / "stoss.wasm").exists() and TSC.exists()),
        reason="the npm package is not built here",
    ),
]

# Values of two compilers agree up to rounding (docs/architecture.md), their errors to the same share of the value.
SAME = 1e-12

SPHERE = {"kind": "sphere", "poisson": 0.3}
BALL = {"kind": "sphere", "radius": 0.005, "material": "structural steel"}


@pytest.fixture(scope="session")
def packed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("packed")
    run("npm", "pack", "--silent", "--pack-destination", folder, cwd=PACKAGE, env=OFFLINE)
    return folder / f"stoss-{VERSION}.tgz"


@pytest.fixture(scope="session")
def project(packed, tmp_path_factory):
    """An empty folder into which the package was installed."""
    folder = tmp_path_factory.mktemp("project")
    (folder / "package.json").write_text('{ "private": true, "type": "module" }')
    run("npm", "install", "--offline", "--no-audit", "--no-fund", "--ignore-scripts", packed, cwd=folder, env=OFFLINE)
    assert [path.name for path in (folder / "node_modules").iterdir() if path.name[0] != "."] == ["stoss"]
    return folder


@pytest.fixture
def node(project):
    """Runs a program there; returns what it prints, as JSON."""

    def of(program):
        (project / "program.js").write_text(f"import {{ load, CoreError }} from 'stoss';\n{program}")
        return json.loads(run("node", "program.js", cwd=project, env=OFFLINE).stdout)

    return of


def asked(encounter, question):
    return f"const stoss = await load();\nconsole.log(JSON.stringify(stoss.{question[0]}({json.dumps(encounter)}, " \
           f"{json.dumps(question[1])})));"


def test_what_is_packed(packed):
    with tarfile.open(packed) as archive:
        names = {member.name.removeprefix("package/") for member in archive}
        described = json.load(archive.extractfile("package/package.json"))
    assert {"README.md", "LICENSE", "index.js", "index.d.ts", "node.js", "stoss.mjs", *MODULES} <= names
    assert not [name for name in names if name.endswith(".ts") and not name.endswith(".d.ts")]
    assert (described["name"], described["version"]) == ("stoss", VERSION)
    assert not [key for key in described if key.endswith("ependencies") or key == "scripts"]
    for export in described["exports"]["."].values():
        assert export.removeprefix("./") in names


@pytest.mark.parametrize("encounter, speed, line", [
    ({"first": SPHERE}, 0.01, "--body sphere --poisson 0.3 --speed 0.01"),
    ({"first": {"kind": "disk", "poisson": 0.33}, "against": "same"}, 0.1, "--body disk --poisson 0.33 --against same --speed 0.1"),
    ({"first": BALL, "against": {"kind": "half-space", "material": "glass"}}, 1,
     "--body sphere --radius 0.005 --material 'structural steel' --against half-space,material=glass --speed 1"),
])
def test_restitution_is_that_of_the_command(node, record, encounter, speed, line):
    ours = node(asked(encounter, ("restitution", {"speed": speed})))
    theirs = record(f"restitution {line}")
    assert ours["converged"] is theirs["converged"] is True
    for name in ("restitution", "contact_time", "max_force", "max_compression"):
        assert ours["quantities"][name]["value"] == pytest.approx(theirs[name], rel=SAME, abs=0), name
    error = ours["quantities"]["restitution"]["error"]
    assert error == pytest.approx(theirs["restitution_error"], rel=0, abs=100 * SAME)


def test_the_rule_with_friction_is_that_of_the_command(node, record):
    ours = node(asked({"first": SPHERE}, ("oblique", {"speed": 0.01, "angle": 30, "friction": 0.3})))["quantities"]
    theirs = record("oblique --body sphere --poisson 0.3 --friction 0.3 --speed 0.01 --angle 30")
    for name in ("restitution", "tangential_restitution"):
        assert ours[name]["value"] == pytest.approx(theirs[name], rel=SAME, abs=0), name


def test_lists_come_whole_and_one_by_one(node, record):
    answer = node("""
const stoss = await load();
const seen = [];
const all = stoss.curve('{"first": {"kind": "disk", "poisson": 0.33}}', { speeds: [0.1, 0.02] },
  ({ speed }, index) => seen.push([speed, index]));
console.log(JSON.stringify({ all, seen, version: stoss.version, title: stoss.schema().title,
  steel: stoss.materials.find(({ name }) => name === 'structural steel') }));
""")
    assert (answer["version"], answer["title"]) == (VERSION, "stoss encounter 1")
    assert answer["steel"]["young"] > 1e11
    assert sorted(answer["seen"]) == [[0.02, 1], [0.1, 0]]
    for point in answer["all"]:
        theirs = record(f"restitution --body disk --poisson 0.33 --speed {point['speed']}")
        assert point["restitution"] == pytest.approx(theirs["restitution"], rel=SAME, abs=0)


@pytest.mark.parametrize("encounter, speed, line", [
    ({"first": {"kind": "sphere", "poisson": 7}}, 0.1, r"poisson: got 7, allowed -0\.95 to 0\.4999.*"),
    ({"first": SPHERE}, 2, r"speed: got 2, allowed 1e-8 to 1 c.*"),
    ({"first": SPHERE}, None, r"speed: got nan.*"),
    ({"first": SPHERE, "vibration": [{"order": 2, "index": 0, "energy": 0.1}]}, 0.1, r"vibration: got 1 modes, .*"),
    (None, 0.1, r"encounter: got .*"),
])
def test_what_is_wrong_is_one_line(node, encounter, speed, line):
    given = {} if speed is None else {"speed": speed}
    answer = node(f"""
const stoss = await load();
try {{
  stoss.restitution({json.dumps(encounter)}, {json.dumps(given)});
}} catch (error) {{
  console.log(JSON.stringify({{ known: error instanceof CoreError, line: error.message }}));
}}
""")
    assert answer["known"] and re.fullmatch(line, answer["line"]), answer


def test_the_readme_prints_what_it_says(project):
    blocks = dict(re.findall(r"^```(\w+)\n(.*?)^```$", (PACKAGE / "README.md").read_text(), re.M | re.S))
    (project / "readme.js").write_text(blocks["js"])
    assert run("node", "readme.js", cwd=project, env=OFFLINE).stdout == blocks["text"]


TYPED = """
import { type Against, CoreError, type Encounter, load, type Stoss } from 'stoss';

const stoss: Stoss = await load({ alive: () => {} });
const block: Against = { kind: 'half-space', material: { young: 7e10, poisson: 0.22, density: 2500 } };
const encounter: Encounter = { first: { kind: 'sphere', radius: 5e-3, material: 'structural steel' }, against: block };
export const epsilon: number = stoss.restitution(encounter, { speed: 1 }).quantities['restitution']!.value;
export const speeds: number[] = stoss.curve(encounter, { speeds: [1, 2] as const }).map(({ speed }) => speed);
export const angle: number | undefined = stoss.obliqueAngles(encounter, { speed: 1, friction: 0.1, angles: [30] },
  ({ tangential }, index) => { if (index > 0) throw new CoreError(`${tangential}`); })[0]?.angle;
export const force: Float64Array = stoss.collision(encounter, { speed: 1, cutoff: 10 }).force;

// @ts-expect-error: a ball is of a material, or has a Poisson's ratio
stoss.units({ first: { kind: 'sphere', radius: 1 } });
// @ts-expect-error: what is no kind
stoss.units({ first: { kind: 'cube', poisson: 0.3 } });
// @ts-expect-error: without a speed
stoss.restitution(encounter, { tolerance: 1e-3 });
// @ts-expect-error: a word that the core does not know
stoss.restitution({ first: { kind: 'sphere', poisson: 0.3 }, gravity: 9.81 }, { speed: 0.1 });
"""


@pytest.mark.parametrize("resolution", ["nodenext", "bundler"])
def test_types_hold_without_those_of_browsers_and_node(project, resolution):
    (project / "typed.ts").write_text(TYPED)
    module = "nodenext" if resolution == "nodenext" else "esnext"
    words = ["--strict", "--noEmit", "--target", "es2022", "--lib", "es2022", "--module", module]
    done = subprocess.run(
        [TSC, *words, "--moduleResolution", resolution, "typed.ts"], cwd=project, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout


def test_the_page_is_made_of_the_package():
    built = sorted((ROOT / "build/web/assets").glob("*.wasm"))
    if not built:
        pytest.skip("the page is not built here")
    assert [path.read_bytes() for path in built] == [(PACKAGE / name).read_bytes() for name in MODULES]
    assert (ROOT / "web/node_modules/stoss").resolve() == PACKAGE
    sources = "".join(path.read_text() for path in (ROOT / "web/src").rglob("*.ts"))
    assert "from 'stoss'" in sources and "stoss.mjs" not in sources
