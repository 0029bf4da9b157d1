"""Short tables of cases, results, cycles and states in notebooks."""

from __future__ import annotations

import html
import math
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .cycle import Cycle
    from .result import Result

#: Quantities of cycles, or ends of paths: name, words, unit, its size in SI.
_HEADLINES = (
    ("max_force", "maximum force", "N", 1.0),
    ("cross_force_at_max", "cross force", "N", 1.0),
    ("loaded_stiffness", "structural stiffness", "MN/m", 1e6),
    ("loop_energy", "loop energy", "mJ", 1e-3),
    ("loss_factor", "loss factor", "", 1.0),
    ("first_contact", "first contact", "µm", 1e-6),
)

#: Of running bearings.
_RUNNING = (
    ("h_min", "minimum film thickness", "um", 1e-6),
    ("eccentricity_ratio", "eccentricity ratio", "", 1.0),
    ("attitude_angle", "attitude angle", "deg", 1.0),
    ("power", "power loss", "W", 1.0),
    ("highest_bump_load", "maximum bump load", "N", 1.0),
)

#: Of a path, whose cycle has no turning point: series at its last increment.
_ENDS = (
    ("x", "x at the end", "µm", 1e-6),
    ("y", "y at the end", "µm", 1e-6),
    ("force_x", "force along X at the end", "N", 1.0),
    ("force_y", "force along Y at the end", "N", 1.0),
    ("dissipated_energy", "dissipated energy", "mJ", 1e-3),
)

#: Columns of tables, of sweeps also behind the keys.
_COLUMNS = {
    "vibration": (
        "load_x_N", "load_y_N", "direction_deg", "amplitude_m", "stiffness_direct_N_per_m",
        "loss_stiffness_direct_N_per_m", "loss_factor", "status",
    ),
    "equilibrium": (
        "speed_rad_per_s", "load_x_N", "load_y_N", "x_m", "y_m", "h_min_m", "p_max_Pa", "torque_N_m", "status",
    ),
    "cycle": (
        "direction_deg", "max_force_N", "cross_force_at_max_N", "loaded_stiffness_N_per_m", "loop_energy_J", "loss_factor",
        "first_contact_m", "status",
    ),
    "strip": ("cycle", "max_force_N", "loaded_stiffness_N_per_m", "loop_energy_J", "loss_factor", "status"),
}  # fmt: skip
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
    for names, found in (
        (_HEADLINES, [cycle.quantities for cycle in cycles]),
        (_ENDS, [_end(cycle) for cycle in cycles if cycle.name == "path"]),
    ):
        for name, words, unit, size in names:
            values = [one.get(name) for one in found]
            if any(value is not None for value in values):
                rows.append([_words(words, unit), *(_shown(value, size) for value in values)])
    return table(rows)


def _end(cycle: Cycle) -> dict[str, float]:
    return {name: float(values[-1]) for name, values in cycle.series.items() if len(values)}


def of_ensemble(statistics: Mapping[str, Mapping[str, Any]]) -> str:
    """Means and standard deviations of summary.json, a column for each direction or state."""
    rows = [["mean ± standard deviation", *statistics]]
    for name, words, unit, size in (*_HEADLINES, *_RUNNING):
        found = [next((entry for key, entry in one.items() if key.startswith(name)), None) for one in statistics.values()]
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
    command = str(result.summary.get("swept_command", result.command))
    first = min(names.index(name) for name in _COLUMNS[command] if name in names)
    shown = names[:first] + [name for name in _COLUMNS[command] if name in names]
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
        return head + of_ensemble(result.summary["statistics"])
    return head + of_table(result)
