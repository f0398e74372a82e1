"""Draws what a ball can meet, and what a disk stands for, docs/images/partners.svg: python3 docs/images/partners.py."""

from pathlib import Path

INK, BLUE, GREY = "#222", "#0072b2", "#ddd"


def text(x, y, words, color=INK):
    return f'<text x="{x}" y="{y}" fill="{color}" text-anchor="middle">{words}</text>'


def ball(x, y, radius=22):
    return f'<circle cx="{x}" cy="{y}" r="{radius}" fill="white" stroke="{INK}" stroke-width="2"/>'


def waves(x, y, radii):
    return [f'<path d="M {x - r} {y} A {r} {r} 0 0 0 {x + r} {y}" stroke="{BLUE}"/>' for r in radii]


def picture():
    hatch = "".join(f'<path d="M {x} 112 l -10 12" stroke="{INK}"/>' for x in range(30, 131, 12))
    bent = "M 340 100 C 380 100, 385 112, 400 112 S 420 100, 460 100 V 116 C 420 116, 415 128, 400 128 S 380 116, 340 116 Z"
    return [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 36 800 180" font-family="sans-serif" font-size="13" fill="none">',
        '<rect width="800" height="230" fill="white"/>',
        ball(80, 90), f'<path d="M 20 112 L 140 112" stroke="{INK}" stroke-width="2"/>', hatch,
        text(80, 186, "rigid wall"), text(80, 204, "takes nothing"),
        f'<path d="M 180 112 H 300 V 165 H 180 Z" fill="{GREY}"/>', ball(240, 90), *waves(240, 112, (14, 28, 42)),
        text(240, 186, "block: half-space, half-plane"), text(240, 204, "waves run away"),
        f'<path d="{bent}" fill="{GREY}" stroke="{INK}"/>', ball(400, 90),
        text(400, 186, "plate, strip"), text(400, 204, "bends away"),
        ball(530, 70), ball(574, 98, 30), text(552, 186, "another body"), text(552, 204, "vibrates, too"),
        f'<path d="M 660 80 L 720 50 M 692 136 L 752 106" stroke="{INK}" stroke-width="2"/>',
        ball(676, 108, 32), f'<path d="M 720 50 A 32 32 0 0 1 752 106" stroke="{INK}" stroke-width="2"/>',
        text(706, 186, "disk: a slice of a cylinder"), text(706, 204, "in plane strain"),
        "</svg>",
    ]  # fmt: skip


if __name__ == "__main__":
    Path(__file__).with_suffix(".svg").write_text("\n".join(picture()) + "\n", encoding="utf-8")
