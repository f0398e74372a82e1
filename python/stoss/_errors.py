"""What stoss raises and warns of."""

from __future__ import annotations

from typing import Any


class InvalidInput(ValueError):
    """An argument that is refused: outside its range, missing, or in conflict with another.

    The message is one line of its parts, which can be read one by one.

    Attributes:
        kind (str): "out_of_range", "missing" or "conflict".
        name (str): The argument, or what it is a part of.
        got (str): What was given; "" where something is missing or does not go together.
        allowed (str): What is allowed or needed, or why it does not go together.
        hint (str): What may help, or "".
    """

    def __init__(self, kind: str, name: object, got: object, allowed: object, hint: object = "") -> None:
        self.kind = kind
        self.name, self.got, self.allowed, self.hint = str(name), str(got), str(allowed), str(hint)
        if kind == "out_of_range":
            line = f"{name}: got {got}, allowed {allowed}"
        elif kind == "missing":
            line = f"{name}: missing, {allowed}" if self.allowed else f"{name}: missing"
        else:
            line = f"{name}: {allowed}"
        super().__init__(f"{line} ({hint})" if self.hint else line)

    def __reduce__(self) -> tuple[Any, ...]:
        return InvalidInput, (self.kind, self.name, self.got, self.allowed, self.hint)

    @classmethod
    def out_of_range(cls, name: object, got: object, allowed: object, hint: object = "") -> InvalidInput:
        """A value out of its range: ``name: got …, allowed … (hint)``."""
        return cls("out_of_range", name, got, allowed, hint)

    @classmethod
    def missing(cls, name: object, needed: object = "", hint: object = "") -> InvalidInput:
        """A missing input: ``name: missing, what is needed (hint)``."""
        return cls("missing", name, "", needed, hint)

    @classmethod
    def conflict(cls, name: object, reason: object, hint: object = "") -> InvalidInput:
        """An input at odds with others: ``name: why it does not go with the rest (hint)``."""
        return cls("conflict", name, "", reason, hint)

    def renamed(self, name: str, more: str = "") -> InvalidInput:
        """The same refusal of another name, with more of a hint."""
        hint = "; ".join(each for each in (self.hint, more) if each)
        return InvalidInput(self.kind, name, self.got, self.allowed, hint)


class NotConverged(RuntimeError):
    """A computation that could not meet its own conditions.

    Attributes:
        best (Restitution, Bounces, RodChain, Row or None): The best value that was reached, or the
            impacts or collisions so far, if there are any.
        input (str): The argument of which another value may help, as in "step", or "".
        hint (str): How it may help, or "".
    """

    def __init__(self, message: str, best: Any = None, input: str = "", hint: str = "") -> None:
        super().__init__(message)
        self.best, self.input, self.hint = best, input, hint


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a curve, a distribution, a sequence, a chain or several rows.

    Attributes:
        best (Restitution, RestitutionDistribution, Bounces, RodChain or Row): The curve so far, where
            what is missing is NaN and not converged; the samples, the impacts or the collisions so
            far.
    """

    def __init__(self, message: str, best: Any = None) -> None:
        super().__init__(message)
        self.best = best


class StossWarning(UserWarning):
    """A result that should not be used without a second look."""
