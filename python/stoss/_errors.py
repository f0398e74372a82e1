"""What stoss raises and warns of."""

from __future__ import annotations

from typing import Any


class InvalidInput(ValueError):
    """An argument outside its range, or of the wrong kind.

    The message is one line: name, what was got, what is allowed, and often a hint.
    """


class NotConverged(RuntimeError):
    """A computation that could not meet its own conditions.

    Attributes:
        best (Restitution, Bounces, RodChain or None): The best value that was reached, or the
            impacts or collisions so far, if there are any.
    """

    def __init__(self, message: str, best: Any = None) -> None:
        super().__init__(message)
        self.best = best


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a curve, a distribution, a sequence or a chain.

    Attributes:
        best (Restitution, RestitutionDistribution, Bounces or RodChain): The curve so far, where
            what is missing is NaN and not converged; the samples, the impacts or the collisions so
            far.
    """

    def __init__(self, message: str, best: Any = None) -> None:
        super().__init__(message)
        self.best = best


class StossWarning(UserWarning):
    """A result that should not be used without a second look."""
