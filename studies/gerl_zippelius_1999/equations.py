"""The equations of the report, in MathML, which browsers show without any script."""

from __future__ import annotations


def i(name: str) -> str:
    """A symbol: italic if it is one letter."""
    return f"<mi>{name}</mi>"


def n(number: object) -> str:
    return f"<mn>{number}</mn>"


def o(sign: str) -> str:
    return f"<mo>{sign}</mo>"


def row(*parts: str) -> str:
    return f"<mrow>{''.join(parts)}</mrow>"


def frac(above: str, below: str) -> str:
    return f"<mfrac>{above}{below}</mfrac>"


def sub(base: str, below: str) -> str:
    return f"<msub>{base}{below}</msub>"


def sup(base: str, above: str) -> str:
    return f"<msup>{base}{above}</msup>"


def both(base: str, below: str, above: str) -> str:
    return f"<msubsup>{base}{below}{above}</msubsup>"


def fenced(*parts: str, left: str = "(", right: str = ")") -> str:
    return row(o(left), *parts, o(right))


def at(*parts: str) -> str:
    """The argument of a function, in brackets that keep their size."""
    return row('<mo stretchy="false">(</mo>', *parts, '<mo stretchy="false">)</mo>')


def display(spoken: str, *parts: str) -> str:
    """An equation on its own line; `spoken` is read aloud."""
    return f'<math display="block" alttext="{spoken}">{row(*parts)}</math>'


_THIN = '<mspace width="0.17em"/>'


def function(name: str, *argument: str) -> str:
    return row(_THIN, i(name), o("&#8289;"), _THIN, *argument)


_NL = row(i("n"), o(","), i("l"))
_Q, _P, _C, _S, _OMEGA = (sub(i(letter), _NL) for letter in ("Q", "P", "C", "S", "ω"))
_X = row(i("x"), at(i("φ")))
_NPHI = row(i("n"), i("φ"))
_SUM = f"<munder>{o('∑')}{_NL}</munder>"
_LOST = row(n(1), o("−"), sup(i("ε"), n(2)))
_PIRE = row(i("π"), i("R"), i("E"))
_F_PIE = frac(i("F"), row(i("π"), i("E")))

POSITION = display(
    "x(φ) = x₀ + R cos φ + Σ Q (C cos nφ cos φ − S sin nφ sin φ)",
    _X, o("="), sub(i("x"), n(0)), o("+"), i("R"), function("cos", i("φ")), o("+"), _SUM, _Q,
    fenced(
        _C, function("cos", _NPHI), function("cos", i("φ")),
        o("−"), _S, function("sin", _NPHI), function("sin", i("φ")),
    ),
)  # fmt: skip

HAMILTONIAN = display(
    "H = p₀²/2m + Σ (P²/2m + ½ m ω² Q²) + V₀ ∫ exp(α x(φ)) dφ from −π/2 to π/2",
    i("H"), o("="), frac(both(i("p"), n(0), n(2)), row(n(2), i("m"))), o("+"), _SUM,
    fenced(
        frac(both(i("P"), _NL, n(2)), row(n(2), i("m"))), o("+"), frac(n(1), n(2)), i("m"), both(i("ω"), _NL, n(2)),
        both(i("Q"), _NL, n(2)),
    ),
    o("+"), sub(i("V"), n(0)),
    both(o("∫"), row(o("−"), i("π"), o("/"), n(2)), row(i("π"), o("/"), n(2))),
    sup(i("e"), row(i("α"), _X)), i("d"), i("φ"),
)  # fmt: skip

HARD_WALL = display(
    "x(φ) ≤ 0, p(φ) ≥ 0, p(φ) x(φ) = 0",
    _X, o("≤"), n(0), o(","), "<mspace width='1em'/>", i("p"), at(i("φ")), o("≥"), n(0), o(","),
    "<mspace width='1em'/>", i("p"), at(i("φ")), _X, o("="), n(0),
)  # fmt: skip

LEDGER = display(
    "1 − ε² = Σ (P²/2m + ½ m ω² Q²) / ½ m v²",
    _LOST, o("="), frac(n(1), row(frac(n(1), n(2)), i("m"), sup(i("v"), n(2)))), _SUM,
    fenced(
        frac(both(i("P"), _NL, n(2)), row(n(2), i("m"))), o("+"), frac(n(1), n(2)), i("m"), both(i("ω"), _NL, n(2)),
        both(i("Q"), _NL, n(2)),
    ),
)  # fmt: skip

EXTRAPOLATIONS = display(
    "1 − ε² at α and N ≈ 1 − ε² at infinite α and N + a/α + b/√N",
    sub(fenced(_LOST), row(i("α"), o(","), i("N"))), o("≃"), sub(fenced(_LOST), row(n("∞"), o(","), n("∞"))), o("+"),
    frac(sub(i("a"), i("N")), i("α")), o("+"), frac(i("b"), f"<msqrt>{i('N')}</msqrt>"),
)  # fmt: skip

CENTRE = display(
    "δ = F/(πE) [ln(πRE/F) − (1+ν)/4]",
    i("δ"), o("="), _F_PIE, fenced(
        function("ln", frac(_PIRE, i("F"))), o("−"), frac(row(n(1), o("+"), i("ν")), n(4)), left="[", right="]",
    ),
)  # fmt: skip

PRINTED = display(
    "δ = F/(πE) [ln(4πRE/F) − 1 − ν]",
    i("δ"), o("="), _F_PIE, fenced(
        function("ln", frac(row(n(4), _PIRE), i("F"))), o("−"), n(1), o("−"), i("ν"), left="[", right="]",
    ),
)  # fmt: skip
