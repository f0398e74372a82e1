"""Counts patterns of hard prose in Markdown pages, docstrings, headers and help texts, as far as a machine can see.

    python3 scripts/prose.py [-v] [PAGE ... | python | headers | help]

prints, for each page, how often each pattern occurs per 1000 words; -v prints the sentences. Without pages it takes
all pages for users. The other words stand for the docstrings of the package, the doc comments of public headers, and
what `stoss … --help` prints. tests/docs/test_prose.py holds all below CEILINGS. Tables, code and formulas do not count.
"""

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = ("start", "tutorials", "howto", "understand", "theory", "reference")
PRONOUNS = r"\b(?:it|its|they|them|their|this|these|that|those|one|ones|both|another|other|others)\b"
VERBS = (
    "is are was were be been has have had do does did can may must will would should cannot need needs take takes "
    "give gives say says make makes show shows begin begins end ends follow follows lose loses move moves keep keeps "
    "hold holds use uses compute computes call calls draw draws print prints write writes set sets run runs stay "
    "stays fall falls rise rises add adds let lets go goes see find finds know read reads put install open ask asks "
    "state states depend depends mean means try choose meet differ slide vibrate fail "
).split()
WRONG = (
    r"\bcertif\w+|\bhonest\w*|\bmend\w*|\balike\b|\b[Bb]esides\b|\bfull disks?\b|\bdisk space\b|\bon disk\b|"
    r"\bdo not do it\b|\bill\b(?!-)|\bprovably\b|\bguarantee\w*|\bpromises?\b|\bbulletproof\b"
)
NOUN = r"\b[Ww]hat\b(?! to\b| if\b)(?:(?!\b[Ww]hat\b).)+?\b(?:is|are|has|have|was|does)\b"
THINGS = r"(?:theor(?:y|ies)|law|rule|field|model|stoss|body|bodies|plate|code|table)s?"

# Each is a pattern that is counted in a sentence. The letters are those of the house style (A to J).
PATTERNS = {
    "A pronouns": lambda text: len(re.findall(PRONOUNS, text, re.IGNORECASE)) > 5,
    "A that of": r"\b(?:that|those) of\b",
    "B of which": r", of which\b|, which is what\b|\b[Ww]hat else\b",
    "B what": lambda text: not text.endswith("?") and re.search(NOUN, text),
    "C size": r"\bballs? of (?:some )?[\d.]+ (?:[cmµ]?m)\b",  # R = 5 mm, or Ø 10 mm
    "C as": r", as (?!long|far|soon|well|a\b|an\b|in\b)\w+",
    "D fronted": r"^(?:Of|Than|Beside|Besides) [a-zα-ω]|^In \w+ (?:stand|lie)s?\b",
    "E semicolons": lambda text: text.count(";") > 1,
    "F G words": WRONG,
    "H persons": rf"\b{THINGS} (?:knows?|wants?|asks?|thinks?)\b|\bsays? too\b",
    "I fragments": None,  # of paragraphs, see below
    "J template": r"\bgot \S+, allowed\b",
    "long": lambda text: len(text.split()) > 40,
}  # fmt: skip
CEILINGS = {"A pronouns": 2, "A that of": 5, "B of which": 0, "B what": 5, "C size": 0, "C as": 4, "D fronted": 1, "E semicolons": 0, "F G words": 0,
            "H persons": 1, "I fragments": 4, "J template": 0, "long": 2}  # fmt: skip
FEW = 2  # of a pattern, on however short a page


def pages():
    found = [ROOT / "README.md", ROOT / "docs/index.md"]
    return found + [page for folder in FOLDERS for page in sorted((ROOT / "docs" / folder).rglob("*.md"))]


def paragraphs(text):
    """Paragraphs and items of lists, without code, tables, headings and formulas, whose places hold an x."""
    text = re.sub(r"^ *```.*?^ *```$", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^(?:\||#|!\[|<|\s{4,}\S).*$", "", text, flags=re.MULTILINE)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"\$\$?[^$]+\$\$?|``?[^`]+``?", "x", text)
    for block in re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )", text):
        if words := re.sub(r"^\s*(?:[-*]|\d+\.) ", "", block.replace("**", "").strip()):
            yield " ".join(words.split())


def sentences(paragraph):
    """Not split after initials, nor after Phys., Rev. and the like, which numbers follow."""
    parts = re.split(r"(?<![A-Z]\.)(?<=[.!?:])\s+(?=[A-Zα-ω*(“]|x\b|stoss\b)", paragraph)
    return [each for each in parts if len(each.split()) > 2]


def is_fragment(sentence):
    words = re.findall(r"[\w’']+", sentence)
    verbs = [word for word in words if word in VERBS or re.search(r"..(?:ed|[^su]s)$", word)]
    return len(words) > 3 and words[0][0].isupper() and sentence.endswith(".") and not verbs


def findings(text):
    """Pattern and sentence, for each that is found, and the number of words."""
    found, words = [], 0
    for paragraph in paragraphs(text):
        for k, sentence in enumerate(sentences(paragraph)):
            words += len(sentence.split())
            for name, pattern in PATTERNS.items():
                if pattern is None:
                    hits = int(k == 0 and is_fragment(sentence))
                else:
                    hits = len(re.findall(pattern, sentence)) if isinstance(pattern, str) else bool(pattern(sentence))
                found += [(name, sentence)] * int(hits)
    return found, words


def too_many(text, but=()):
    """The patterns that a page has more often than its ceiling, with their sentences; `but` those that do not count."""
    found, words = findings(text)
    for name, ceiling in CEILINGS.items():
        if name in but:
            continue
        its = [sentence for each, sentence in found if each == name]
        if len(its) > max(FEW if ceiling else 0, ceiling * words / 1000):
            yield name, its


def docstrings():
    """Of the public classes, functions and modules of the package, and of the words that several share."""
    package = ROOT / "python/stoss"
    texts = []
    for file in sorted(package.rglob("*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            name = getattr(node, "name", file.stem)
            if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and not name.startswith("_"):
                texts.append(ast.get_docstring(node) or "")
        if file.name == "_documentation.py":
            shared = [node.value for node in tree.body if isinstance(node, ast.Assign) and isinstance(node.value, ast.Dict)]
            texts += [text for words in shared for text in ast.literal_eval(words).values()]
    text = "\n\n".join(texts)
    text = re.sub(r"^ *>>>.*\n(?: *\S.*\n)*", "\n", text, flags=re.MULTILINE)  # examples
    text = re.sub(r"^ +\*{0,2}\w[\w, ]*(?: ?\(.*?\))? ?: ", "\n\n", text, flags=re.MULTILINE)  # names of parameters
    return re.sub(r"^ +", "", text, flags=re.MULTILINE)


def headers():
    """Doc comments, each of a parameter or behind a member as a paragraph."""
    texts = []
    for file in sorted((ROOT / "include/stoss").rglob("*.h*")):
        source = file.read_text(encoding="utf-8")
        texts += re.findall(r"\S.*///< ?(.*)", source)
        text = re.sub(r"^(?!\s*///).*$|^\s*///     .*$", "", source, flags=re.MULTILINE)
        text = re.sub(r"^\s*/// ?", "", text, flags=re.MULTILINE)
        texts.append(re.sub(r"@(?:param(?:\[\w+\])? [\w,]+|return|throws|brief)\s+", "\n\n", text))
    return "\n\n".join(texts)


def help_texts():
    """What all subcommands say of themselves and of their options, without values, usage and examples."""
    stoss = os.environ.get("STOSS", ROOT / "build/release/cli/stoss")

    def said(*names):
        return subprocess.run([stoss, *names, "--help"], capture_output=True, encoding="utf-8", check=True).stdout

    general = said()
    names = re.findall(r"^  ([a-z]+) ", general.partition("Subcommands:")[2], re.MULTILINE)
    text = "\n\n".join([general, *map(said, names)])
    text = re.sub(r"^Usage: .*|^(?:Examples?|\w.*):$|^  stoss .*(?:\n {4}.*)*", "\n", text, flags=re.MULTILINE)
    text = re.sub(r"^ {2}\S.*?(?: {2,}|$)|^ {6}\S.*", "\n\n", text, flags=re.MULTILINE)  # names of options
    text = re.sub(r"^ {24,28}(?=[\w-]+: )", "\n\n", text, flags=re.MULTILINE)  # the values that they take
    return re.sub(r"^ +", "", text, flags=re.MULTILINE)


# What these texts say of a parameter is a noun, so that fragments are right there.
FACES = {"python": docstrings, "headers": headers, "help": help_texts}


def main(arguments):
    for page in [name for name in arguments if name != "-v"] or pages():
        found, words = findings(FACES[page]() if page in FACES else Path(page).read_text(encoding="utf-8"))
        counts = {name: sum(each == name for each, _ in found) for name in PATTERNS}
        shown = ", ".join(f"{name} {1000 * count / max(words, 1):.1f}" for name, count in counts.items() if count)
        print(f"{page}: {words} words; {shown}")
        if "-v" in arguments:
            print(*(f"    {name}: {sentence}" for name, sentence in found), sep="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
