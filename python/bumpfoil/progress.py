"""Progress of a run."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any, Union

#: What functions take as ``progress``.
Progress = Union[bool, Callable[[float], Any], None]

_BEFORE_SHOWN = 1.0  # s


def _somebody_looks() -> bool:
    return sys.stderr.isatty() or "ipykernel" in sys.modules


class _Line:
    """A line on standard error that changes, of runs that take longer than a second."""

    def __init__(self) -> None:
        self._begin = time.monotonic()
        self._shown = False

    def __call__(self, fraction: float) -> None:
        elapsed = time.monotonic() - self._begin
        if elapsed > _BEFORE_SHOWN:
            sys.stderr.write(f"\r{fraction:4.0%}  {elapsed:.0f} s ")
            sys.stderr.flush()
            self._shown = True

    def end(self) -> None:
        if self._shown:
            sys.stderr.write("\r" + " " * 20 + "\r")
            sys.stderr.flush()


class shown:
    """While a run goes on: what it calls with the fraction that is done, or None.

    Parameters
    ----------
    progress : bool or callable, optional
        Whether to show a line; by default on a terminal and in a notebook. Or a function of the completed fraction, 0
        to 1; if it returns False the run stops, and its result is partial.
    """

    def __init__(self, progress: Progress) -> None:
        self._called: Callable[[float], Any] | None = None
        if callable(progress):
            self._called = progress
        elif progress or (progress is None and _somebody_looks()):
            self._called = _Line()

    def __enter__(self) -> Callable[[float], Any] | None:
        return self._called

    def __exit__(self, *_: object) -> None:
        if isinstance(self._called, _Line):
            self._called.end()
