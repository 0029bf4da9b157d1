"""Errors and warnings, with the messages of the program."""

from __future__ import annotations


class Error(Exception):
    """Base of all errors of this package.

    Attributes
    ----------
    errors : list of str
        Every error, one line each: place, value found, what to change.
    """

    def __init__(self, message: str, errors: list[str] | None = None) -> None:
        super().__init__(message)
        self.errors = errors if errors is not None else [message]

    @property
    def faults(self) -> list[str]:
        """The former name of ``errors``."""
        return self.errors


class CaseError(Error, ValueError):
    """The case, or another input, is invalid."""


class FileError(Error, OSError):
    """A file cannot be read or written, or is damaged."""


class RunWarning(UserWarning):
    """A run that ended early, or whose results need care; the message says why."""
