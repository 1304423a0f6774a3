"""Reports of progress."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

#: Called with the number of finished runs and the number of all runs.
Progress = Callable[[int, int], object]


def shown(progress: Progress | bool) -> Progress | None:
    """The function to call with progress: the given one, or for ``True`` one that shows a line."""
    if not progress:
        return None
    return _in_a_notebook() or _line if progress is True else progress


def _said(done: int, of: int) -> str:
    return f"{done} of {of} runs"


def _line(done: int, of: int) -> None:
    """Shows progress as one line on standard error."""
    end = "\n" if done == of else ""
    print(f"\r{_said(done, of)}", end=end, file=sys.stderr, flush=True)


def _in_a_notebook() -> Progress | None:
    """A function that rewrites one output of the notebook cell; ``None`` outside a notebook."""
    shell = sys.modules.get("IPython") and sys.modules["IPython"].get_ipython()
    if not hasattr(shell, "kernel"):
        return None
    import IPython.display

    display: Any = IPython.display.display
    output = display({"text/plain": "0 runs"}, raw=True, display_id=True)

    def tell(done: int, of: int) -> None:
        output.update({"text/plain": _said(done, of)}, raw=True)

    return tell
