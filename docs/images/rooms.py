"""Draws the rooms of the library, docs/images/rooms.svg: python3 docs/images/rooms.py."""

from pathlib import Path

WIDTH, HEIGHT = 1210, 495
BOX_WIDTH, BOX_HEIGHT = 150, 84

# Name: left, top, what it holds.
ROOMS = {
    "body": (20, 20, ("what a contact asks", "an elastic body")),
    "contact": (215, 20, ("who meets whom, as", "one system; the walls")),
    "impact": (422, 20, ("one collision, step by", "step; its resolution")),
    "restitution": (630, 20, ("ε with its error;", "curves")),
    "vibration": (830, 20, ("ensembles of bodies", "that vibrate")),
    "table": (830, 175, ("ε(v) as a function,", "with its error")),
    "row": (830, 330, ("several bodies on", "one line: cradles")),
    "prediction": (1040, 20, ("real balls: channels,", "yield and adhesion")),
    "encounter": (1040, 175, ("kinds, materials, units:", "who meets whom, as given")),
    "bodies": (215, 175, ("disk, sphere, rod:", "modes and the rest")),
    "quasistatic": (630, 175, ("slow contacts:", "Hertz, Rayleigh")),
}
# A room and those that include its headers (apart from what follows through a third one).
ARROWS = {
    "body": ("contact", "bodies"),
    "contact": ("impact", "quasistatic"),
    "impact": ("restitution",),
    "restitution": ("vibration", "table", "row"),
    "quasistatic": ("table",),
    "table": ("encounter",),
    "row": ("encounter",),
    "encounter": ("prediction",),
    "bodies": ("restitution", "quasistatic"),
}
FOUNDATION = "numeric, relaxation, errors, poll, material: all rooms stand on them"


def text(x, y, content, size=12, weight="normal"):
    style = f'font-size="{size}" font-weight="{weight}" text-anchor="middle"'
    return f'<text x="{x}" y="{y}" {style}>{content}</text>'


def rectangle(x, y, width, height, fill):
    return f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="6" fill="{fill}" stroke="#555"/>'


def room(name):
    left, top, lines = ROOMS[name]
    middle = left + BOX_WIDTH // 2
    yield rectangle(left, top, BOX_WIDTH, BOX_HEIGHT, "#e8f1f8")
    yield text(middle, top + 25, name, 15, "bold")
    for i, line in enumerate(lines):
        yield text(middle, top + 48 + 17 * i, line)


def arrow(start, end):
    """From the right edge of a room to the left edge of another, at heights that keep arrows
    apart."""
    (left, top, _), (to_left, to_top, _) = ROOMS[start], ROOMS[end]
    middle = BOX_HEIGHT // 2
    lean = (to_top > top) - (to_top < top)
    y, to_y = top + middle + 20 * lean, to_top + middle - 20 * lean
    line = f'x1="{left + BOX_WIDTH}" y1="{y}" x2="{to_left - 3}" y2="{to_y}"'
    return f'<line {line} stroke="#555" stroke-width="1.5" marker-end="url(#head)"/>'


def picture():
    yield f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif">'
    yield '<marker id="head" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
    yield '<path d="M0 0 8 4 0 8z" fill="#555"/></marker>'
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    for name in ROOMS:
        yield from room(name)
    for start, ends in ARROWS.items():
        yield from (arrow(start, end) for end in ends)
    yield rectangle(20, HEIGHT - 60, WIDTH - 40, 40, "#f1f1ee")
    yield text(WIDTH // 2, HEIGHT - 35, FOUNDATION, 13)
    yield "</svg>"


def main():
    lines = "\n".join(picture())
    Path(__file__).with_suffix(".svg").write_text(lines + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
