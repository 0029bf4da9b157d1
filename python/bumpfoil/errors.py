"""What goes wrong, with the messages of the program."""

from __future__ import annotations


class Error(Exception):
    """Base of all errors of this package.

    Attributes
    ----------
    faults : list of str
        Everything that is wrong, one line each: where, the value met, what to change.
    """

    def __init__(self, message: str, faults: list[str] | None = None) -> None:
        super().__init__(message)
        self.faults = faults if faults is not None else [message]


class CaseError(Error, ValueError):
    """The case, or another input, is wrong."""


class FileError(Error, OSError):
    """A file cannot be read or written, or is damaged."""


class RunWarning(UserWarning):
    """A run that ended before its time, or whose results are to be taken with care; the message says why."""
