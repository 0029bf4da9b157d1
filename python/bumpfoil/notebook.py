"""Short tables of cases, results, cycles and states in notebooks."""

from __future__ import annotations

import html
import math
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import _native
from .tables import sampled_command

if TYPE_CHECKING:
    from .cycle import Cycle
    from .result import Result

_MOST_ROWS = 12


def table(rows: Sequence[Sequence[str]]) -> str:
    """Rows of texts, whose numbers and directions have true minus signs; nothing of none."""
    signed = [[re.sub("^-(?=[0-9XY])", "−", cell) for cell in row] for row in rows]
    cells = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in signed)
    return f"<table>{cells}</table>" if rows else ""


def _words(words: str, unit: str) -> str:
    return f"{words} ({unit})" if unit else words


def _shown(value: Any, size: float = 1.0) -> str:
    return "–" if value is None or math.isnan(value) else f"{value / size:.4g}"


def of_cycles(cycles: Sequence[Cycle]) -> str:
    """A column for each, with the quantities that any of them has."""
    rows = [["", *(cycle.name for cycle in cycles)]]
    for headlines, where, found in (
        (_native.headlines("cycle"), "", [cycle.quantities for cycle in cycles]),
        # A path has no turning point.
        (_native.headlines_of_increments(), " at the end", [_end(cycle) for cycle in cycles if cycle.name == "path"]),
    ):
        for name, _, words, unit, size in headlines:
            values = [one.get(name) for one in found]
            if any(value is not None for value in values):
                rows.append([_words(words + where, unit), *(_shown(value, size) for value in values)])
    return table(rows)


def _end(cycle: Cycle) -> dict[str, float]:
    return {name: float(values[-1]) for name, values in cycle.series.items() if len(values)}


def of_ensemble(summary: Mapping[str, Any]) -> str:
    """Means and standard deviations, a column for each direction, state or rotor."""
    statistics: Mapping[str, Mapping[str, Any]] = summary["statistics"]
    rows = [["mean ± standard deviation", *statistics]]
    for _, key, words, unit, size in _native.headlines(sampled_command(summary)):
        found = [one.get(key) for one in statistics.values()]
        if any(found):
            rows.append([_words(words, unit), *(_mean(entry, size) for entry in found)])
    return table(rows)


def _mean(entry: Mapping[str, Any] | None, size: float) -> str:
    mean, deviation = ((entry or {}).get(name) for name in ("mean", "std"))
    return _shown(mean, size) if deviation is None else f"{_shown(mean, size)} ± {_shown(deviation, size)}"


def of_table(result: Result) -> str:
    """The first rows of the table of a command, and some of its columns."""
    found = result.to_dataframe()
    names = list(found.columns)
    headlines = [key for _, key, *_ in _native.headlines(str(result.summary.get("swept_command", result.command)))]
    # What tells the rows apart comes before all that was found.
    first = min((names.index(key) for key in headlines if key in names), default=len(names))
    shown = [name for i, name in enumerate(names) if i < first or name in (*headlines, "status")]
    rows = [
        [value if isinstance(value, str) else _shown(value) for value in row]
        for row in found[shown].head(_MOST_ROWS).itertuples(index=False)
    ]
    more = f"<p>{len(found) - _MOST_ROWS} more rows: to_dataframe()</p>" if len(found) > _MOST_ROWS else ""
    return table([shown, *rows]) + more


def of_result(result: Result) -> str:
    head = f"<p><b>{html.escape(result.command)}</b>, {result.status}</p>"
    if result.cycles:
        return head + of_cycles(result.cycles)
    if result.command == "montecarlo":
        return head + of_ensemble(result.summary)
    return head + of_table(result)
