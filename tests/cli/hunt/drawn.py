"""Calls of the command drawn at random: who meets whom from its schema, what a call adds from the tables here."""

import json
import random
import re
import subprocess
from pathlib import Path

BODY_FILES = sorted(Path(__file__).parents[3].glob("examples/any_body/*_30.json"))

# Options of each command, beside body and partner, by what draws a value; those of its own are given in `_drawn`.
OPTIONS = {
    "restitution": {"tolerance": (1e-9, 0.5), "absolute": (1e-9, 0.5)},
    "oblique": {"tolerance": (1e-4, 0.5), "spin": (1e-4, 0.3), "second-spin": (1e-4, 0.3), "kinematics": ("linear",)},
    "impact": {"cutoff": (0.1, 300), "step": (1e-5, 1), "nodes": (16, 4096), "tail": ("radiating", "static", "none")},
    "predict": {"tolerance": (1e-6, 0.5), "adhesion": (1e-3, 10), "uncertainty": ("young=0.1", "yield_strength=1")},
    "table": {"error": (1e-5, 0.1), "tolerance": (1e-3, 0.5), "friction": (1e-3, 5), "adhesion": (1e-3, 10),
              "format": ("c", "rust", "js", "two-column", "json"), "beyond": ("clamp", "error"), "name": ("a", "a b")},
    "bounce": {"count": (1, 1e4), "decay-time": (1, 1e4), "tail": ("radiating", "static", "none"), "cutoff": (0.1, 300)},
    "distribution": {"samples": (1, 1e5), "error": (1e-7, 0.5), "highest": (1, 300), "seed": (1, 1e9)},
    "quasistatic": {"cutoff": (1, 2000), "law": ("center", "diameter", "hertz")},
    "modes": {"cutoff": (1, 2000)},
}
RARE = {"adhesion": 0.1, "friction": 0.1, "tolerance": 0.2, "highest": 0.2, "second-spin": 0.1}
WHOLE = {"nodes", "count", "samples", "seed"}
TAKES_MATERIAL = ("predict",)
# Bodies and partners that some commands take; all others are drawn too, at times.
MOSTLY = {"predict": ["sphere"], "modes": ["disk", "sphere"], "quasistatic": ["disk", "sphere"]}
FIXED = ["wall", "half-space", "half-plane", "plate", "strip"]
FACE = ("roughness", "u0", "coat")
SELDOM = ("loss_time", "extra_mass", *FACE, "coat_young", "coat_poisson", "coat_quality", "yield_strength", "yield_hardening", "yield_rate")
LIKELY = {"Pa": (1e5, 1e12), "m": (1e-4, 1), "kg/m^3": (100, 2e4), "m^2": (1e-6, 1), "s": (1e-12, 1e-5), "kg": (1e-6, 10)}


class Drawer:
    def __init__(self, stoss):
        schema = json.loads(subprocess.run([stoss, "schema"], capture_output=True, text=True, check=True).stdout)
        self.materials = schema["$defs"]["material"]["oneOf"][0]["enum"]
        self.firsts, self.partners = ({b["properties"]["kind"]["const"]: b["properties"]
                                       for b in schema["properties"][side]["oneOf"] if "properties" in b}
                                      for side in ("first", "against"))
        # "a disk meets disks, half-planes and strips; a sphere or modal body spheres, ..."
        self.meets = {}
        for part in schema["description"].split("; ")[0:]:
            found = re.search(r"\ba (.*?)(?: meets)? ((?:disks|spheres|rods).*)", part)
            if not found:
                continue
            names = re.split(r", | and ", found[2].replace("modal bodies", "modals"))
            partners = [name.removesuffix("s").replace(" ", "-") for name in names]
            self.meets |= {first.split()[0]: partners for first in re.split(r", | or ", found[1])}

    def call(self, seed):
        """The words of a call, the same ones for the same seed."""
        rnd = random.Random(f"stoss {seed}")
        command = rnd.choice(sorted(OPTIONS))
        words = [command]
        kind = rnd.choice(MOSTLY[command] if command in MOSTLY and rnd.random() < 0.95 else sorted(self.firsts))
        si = command in TAKES_MATERIAL or rnd.random() < 0.4
        if kind == "modal":
            si = True
            words += ["--body", f"@{rnd.choice(BODY_FILES)}"]
        else:
            words += ["--body", kind, *_as_options(self._body(rnd, self.firsts[kind], si, not si), command)]
        if command != "modes" and (command != "quasistatic" or rnd.random() < 0.3):
            words += self._against(rnd, command, kind, si)
        return words + list(_drawn(rnd, command, si)) + list(_options(rnd, command))

    def _against(self, rnd, command, kind, si):
        fitting = self.meets[kind] + ["wall", "same"]
        if command == "bounce":
            fitting = [name for name in fitting if name in FIXED]
        other = rnd.choice(fitting if rnd.random() < 0.95 else sorted(self.partners))
        if other == "modal":
            return ["--against", f"@{rnd.choice(BODY_FILES)}"]
        if other == "same" or other == "wall":
            return ["--against", other]
        count = rnd.choice((1, 1, 2, 3, 20)) if other == "plate" else 1
        layers = [self._body(rnd, self.partners[other], si) for _ in range(count)]
        if count > 1:  # one holds for all of them
            shared = ("loss_time", "quality", "relaxation")
            layers = [{k: v for k, v in layer.items() if i == 0 or k not in shared} for i, layer in enumerate(layers)]
        return ["--against", other + "".join("/"[: i > 0] + _as_keys(layer, i) for i, layer in enumerate(layers))]

    def _body(self, rnd, properties, si, unit=False):
        """Parameters of a body: in SI all, otherwise some, often near those of the first, which is the unit."""
        body = {}
        named = si and rnd.random() < 0.6
        for name, what in properties.items():
            if what.get("type") == "boolean" and rnd.random() < 0.05:
                body[name] = True
            elif named and name in ("poisson", "young", "density"):
                body["material"] = rnd.choice(self.materials)
            elif "enum" in what and si and rnd.random() < 0.2:
                body[name] = rnd.choice(what["enum"])
            elif what.get("type") == "number":
                needed = "default" not in what or (si and name not in SELDOM)
                if unit and what.get("default") == 1.0:
                    continue
                if needed or rnd.random() < (0.1 if name in SELDOM else 0.3):
                    face = name in FACE
                    body[name] = _logarithmic(rnd, *((1e-9, 1e-5) if si else (1e-6, 0.5))) if face else _number(rnd, what, si)
        if "loss_time" in properties and not {"loss_time", "quality"} & set(body) and rnd.random() < 0.1:
            body["relaxation"] = rnd.choice(("0.5:1", "0.3:1e-5+0.2:1e-3", "0.9:0.1", "0.6:1+0.6:2"))
        return body


def _number(rnd, what, si):
    if "maximum" in what and "minimum" in what:
        low, high = what["minimum"], min(what["maximum"], 0.4999) if si else what["maximum"]
        return rnd.choice((low, high)) if rnd.random() < 0.05 else round(rnd.uniform(low, high), 3)
    return _logarithmic(rnd, *(LIKELY[what["x-unit"]] if si else rnd.choice(((0.3, 3), (1e-3, 1e3)))))


def _logarithmic(rnd, low, high):
    return float(f"{low * (high / low) ** rnd.random():.3g}")


def _as_options(body, command):
    for name, value in body.items():
        if command in ("modes", "quasistatic") and name in ("quality", "relaxation", "rigid", *SELDOM):
            continue
        if value is True:
            yield "--rigid-body"
        else:
            yield from ("--" + name.replace("_", "-"), str(value))


def _as_keys(body, i):
    keys = ",".join(f"{name}={value}" for name, value in body.items() if value is not True)
    return keys if i else "," * bool(keys) + keys


def _drawn(rnd, command, si):
    """What the command must have."""
    slow, fast = (1e-4, 10) if si else (1e-7, 0.3)
    speed = _logarithmic(rnd, slow, fast)
    if command == "modes":
        return
    if command == "quasistatic" and rnd.random() < 0.5:
        yield from ("--compression", f"lin:{speed / 100:.3g}:{speed:.3g}:20")
    elif command == "predict" and rnd.random() < 0.3:
        yield from ("--height", str(speed))
    elif command == "table":
        yield from ("--speed", f"{speed}:{speed * rnd.choice((1.1, 10, 1000)):.3g}")
        form = rnd.choice(("", "", "--oblique", "--predict", "--ratio"))
        yield from [form, *["0.3:3"] * (form == "--ratio")] if form else []
    else:
        several = command in ("restitution", "oblique", "predict", "quasistatic") and rnd.random() < 0.2
        yield from ("--speed", f"log:{speed}:{2 * speed}:5" if several else str(speed))
    if command == "oblique":
        yield from ("--friction", str(rnd.choice((0, _logarithmic(rnd, 1e-3, 5)))))
        yield from rnd.choice((["--angle", str(rnd.randint(0, 89))], ["--tangential", str(speed)]))
    if command == "bounce":
        yield from rnd.choice((["--flight-time", "30"], ["--gravity", "9.81" if si else "1e-6"]))
    if command == "distribution":
        yield from rnd.choice((["--temperature", str(_logarithmic(rnd, 1e-4, 10))], ["--spectrum", "2,0,energy=0.1"]))
    if command in ("restitution", "impact", "bounce") and rnd.random() < 0.15:
        yield from ("--mode", rnd.choice(("2,0", "1,0", "3,2")) + ",energy=0.1")


def _options(rnd, command):
    for name, values in OPTIONS[command].items():
        if rnd.random() < RARE.get(name, 0.3):
            value = _logarithmic(rnd, *values) if isinstance(values[0], (int, float)) else rnd.choice(values)
            if rnd.random() < 0.05:
                value = rnd.choice((0, -1, "nan", 1e300))
            yield from ("--" + name, str(int(value) if name in WHOLE and isinstance(value, float) else value))
    if command in ("restitution", "oblique", "predict", "table", "distribution"):
        yield from ("--threads", "1")
