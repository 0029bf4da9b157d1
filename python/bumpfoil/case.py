"""Cases: a bearing and the runs to compute."""

from __future__ import annotations

import html
import json
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from . import _native
from .units import case_value, is_quantity

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def toml_value(value: Any) -> str:
    """A value as TOML writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (int, float)):
        return repr(value)
    if is_quantity(value):
        return toml_value(case_value(value))
    if isinstance(value, Mapping):
        pairs = (f"{_key(key)} = {toml_value(entry)}" for key, entry in value.items() if entry is not None)
        return "{" + ", ".join(pairs) + "}"
    if hasattr(value, "tolist"):  # of NumPy, also its scalars
        return toml_value(value.tolist())
    if isinstance(value, os.PathLike):
        return toml_value(os.fspath(value))
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    raise TypeError(f"a case cannot hold {value!r}, of the type {type(value).__name__}")


def _key(name: str) -> str:
    return name if _BARE_KEY.fullmatch(name) else json.dumps(name)


def _pairs(tables: Mapping[str, Any], path: str = "") -> Iterator[str]:
    """``table.key=value`` of everything in nested tables; None leaves a key unchanged."""
    for name, value in tables.items():
        key = path + (name if not path else _key(name))
        # Laws and ranges replace a value.
        ends = ({"start", "end"}, {"from", "to"})
        if isinstance(value, Mapping) and not any(pair <= value.keys() for pair in ends):
            yield from _pairs(value, key + ".")
        elif value is not None:
            yield f"{key}={toml_value(value)}"


class Case:
    """A bearing and the runs to compute, as in a case file: validated and immutable.

    Numbers are in SI; strings carry their unit, ``"31.8 um"``; pint quantities are converted. Arrays are lists. The
    keys are those of docs/case_file.md.

    Parameters
    ----------
    source : path, str, mapping or Case, optional
        A case file; its text, if a string of several lines; or its tables as a nested dictionary.
    **tables : mapping
        Keys that are added or changed: ``friction={"coefficient": 0.2}``.

    Raises
    ------
    CaseError
        With the message of ``bumpfoil check``: every error, its place, the value found, what to change.
    FileError
        A file cannot be read.

    Examples
    --------
    >>> case = Case("case.toml", friction={"coefficient": 0.2})
    >>> slippery = case.replace({"friction.coefficient": 0.0})
    """

    _source: _native.CaseSource

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any] | Case | None = None, /, **tables: Any) -> None:
        changes: list[str] = []
        if isinstance(source, Case):
            held = source._source
            text, name, changes = held.text, held.name, held.changes
        elif isinstance(source, str) and "\n" in source:
            text, name = source, "TOML text"
        elif isinstance(source, (str, os.PathLike)):
            name = os.fspath(source)
            text = _native.read_case_text(name)
        else:
            if source is None:
                source, tables = tables, {}
            text, name = "\n".join(_pairs(source)), ""
        self._source = _native.CaseSource(text, name, [*changes, *_pairs(tables)])
        self._toml: str = self._source.toml()

    def replace(self, changes: Mapping[str, Any] | None = None, /, **tables: Any) -> Case:
        """A copy with other values.

        Parameters
        ----------
        changes : mapping, optional
            Values by their dotted keys: ``{"friction.coefficient": 0.2}``.
        **tables : mapping
            Values by table: ``friction={"coefficient": 0.2}``.
        """
        return Case(self, **{**(changes or {}), **tables})

    @property
    def toml(self) -> str:
        """The case as interpreted, as a case file in SI with defaults filled in: the output of ``bumpfoil check``
        without its last lines on commands."""
        return self._toml

    def to_dict(self) -> dict[str, Any]:
        """The same as nested dictionaries, SI."""
        tables: dict[str, Any] = json.loads(self._source.json())
        return tables

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the case as interpreted.

        Parameters
        ----------
        path : path
            Of a file that does not exist yet.
        """
        with open(path, "x", encoding="utf-8") as file:
            file.write(self._toml)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self._toml == other._toml

    def __hash__(self) -> int:
        return hash(self._toml)

    def __reduce__(self) -> tuple[Any, ...]:
        return Case, (self._toml,)

    def __repr__(self) -> str:
        return f"<bumpfoil.Case {Path(self._source.name).name or 'of Python'}>"

    def _repr_html_(self) -> str:
        return f"<details><summary>{html.escape(repr(self))}</summary><pre>{html.escape(self._toml)}</pre></details>"

    def __str__(self) -> str:
        return self._toml


def as_case(source: Any, tables: Mapping[str, Any]) -> Case:
    """A case from whatever the functions of this package accept."""
    return source if isinstance(source, Case) and not tables else Case(source, **tables)


def template(name: str = "gen1") -> str:
    """A commented case file to start from, with every key: what ``bumpfoil init --preset`` writes.

    Parameters
    ----------
    name : str
        Of the preset, such as ``gen1``, ``gen3-three-pad`` or ``larsen-strip``.

    Returns
    -------
    str
        Its text.

    Raises
    ------
    CaseError
        There is no such preset.
    """
    return _native.case_template(name)
