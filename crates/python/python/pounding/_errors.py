"""Exceptions and warnings."""

from __future__ import annotations

from typing import Any

__all__ = ["PoundingWarning", "Refused"]


class Refused(ValueError):
    """A refused input or a failed run, in the words of the program.

    Attributes
    ----------
    place
        The field, with file and line if it is in a file; ``None`` if the fault is in no field.
    found
        The value found.
    allowed
        The values allowed.
    help
        The remedy.
    """

    def __init__(
        self,
        message: str,
        place: str | None = None,
        found: str | None = None,
        allowed: str | None = None,
        help: str | None = None,
    ) -> None:
        super().__init__(message)
        self.place = place
        self.found = found
        self.allowed = allowed
        self.help = help

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.place, self.found, self.allowed, self.help)


class NotFound(Refused, FileNotFoundError):
    """A missing file."""


class PoundingWarning(UserWarning):
    """A warning about the numbers of a run."""
