"""Draws the signs of an oblique impact, docs/images/signs.svg: python3 docs/images/signs.py."""

from pathlib import Path

ARROW = '<path d="M {0} {1} L {2} {3}" stroke="{4}" stroke-width="2" marker-end="url(#{5})"/>'
INK, BLUE, RED = "#222", "#0072b2", "#d55e00"


def text(x, y, words, color=INK, more=""):
    return f'<text x="{x}" y="{y}" fill="{color}" {more}>{words}</text>'


def arrow(x, y, dx, dy, color, name):
    return ARROW.format(x, y, x + dx, y + dy, color, name)


def picture():
    heads = [f'<marker id="{name}" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
             f'<path d="M 0 0 L 8 4 L 0 8 z" fill="{color}"/></marker>'
             for name, color in (("ink", INK), ("blue", BLUE), ("red", RED))]  # fmt: skip
    return [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 660 290" font-family="sans-serif" font-size="13" fill="none">',
        "<defs>", *heads, "</defs>", '<rect width="660" height="290" fill="white"/>',
        # before
        text(60, 24, "before"), f'<path d="M 30 250 L 270 250" stroke="{INK}" stroke-width="2"/>',
        f'<circle cx="120" cy="150" r="50" stroke="{INK}" stroke-width="2"/>',
        arrow(120, 150, 80, 0, BLUE, "blue"), text(178, 142, "v_t, tangential", BLUE),
        arrow(120, 150, 0, 70, BLUE, "blue"), text(60, 228, "v, speed", BLUE),
        f'<path d="M 120 150 L 190 211" stroke="{INK}" stroke-dasharray="4 3"/>',
        f'<path d="M 120 185 A 35 35 0 0 0 146 173" stroke="{INK}"/>', text(172, 222, "angle"),
        f'<path d="M 82 158 A 39 39 0 0 0 101 184" stroke="{RED}" stroke-width="2" marker-end="url(#red)"/>',
        text(18, 150, "Ω, spin", RED),
        text(30, 272, "s = v_t + ΩR: sliding where they touch"),
        # after
        '<g transform="translate(60 0)">',
        text(330, 24, "after"), f'<path d="M 300 250 L 540 250" stroke="{INK}" stroke-width="2"/>',
        f'<circle cx="400" cy="120" r="50" stroke="{INK}" stroke-width="2"/>',
        arrow(400, 120, 45, 0, BLUE, "blue"), text(454, 124, "v_t′, tangential_after", BLUE),
        arrow(400, 120, 0, -62, BLUE, "blue"), text(408, 52, "ε v", BLUE),
        f'<path d="M 383 155 A 39 39 0 0 1 362 128" stroke="{RED}" stroke-width="2" marker-end="url(#red)"/>',
        text(302, 146, "Ω′ &lt; 0", RED),
        text(300, 272, "ε_t = −s′/s: −1 slides on, 1 is reversed"),
        '</g>', "</svg>",
    ]  # fmt: skip


if __name__ == "__main__":
    Path(__file__).with_suffix(".svg").write_text("\n".join(picture()) + "\n", encoding="utf-8")
