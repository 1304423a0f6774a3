"""What is raised and what is warned of."""

from __future__ import annotations

from typing import Any

__all__ = ["PoundingWarning", "Refused"]


class Refused(ValueError):
    """An input that is refused, or a run that failed, in the words of the program.

    Attributes
    ----------
    place
        The field, with file and line where it stands in a file; ``None`` where no field is to blame.
    found
        What stands there.
    allowed
        What may stand there.
    help
        What to do.
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
    """A file that is not there."""


class PoundingWarning(UserWarning):
    """What to know before believing the numbers of a run."""
