"""Pictures of results, drawn by matplotlib: colours that the colour-blind tell apart, lines that grey print does."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas
    from matplotlib.axes import Axes

    from .cycle import Cycle
    from .result import Result

#: Colours of Okabe and Ito, with a line and a mark each.
_STYLES = (
    {"color": "#0072B2", "linestyle": "-", "marker": "o"},
    {"color": "#D55E00", "linestyle": "--", "marker": "s"},
    {"color": "#009E73", "linestyle": "-.", "marker": "^"},
    {"color": "#CC79A7", "linestyle": ":", "marker": "D"},
    {"color": "#000000", "linestyle": (0, (5, 1)), "marker": "v"},
    {"color": "#E69F00", "linestyle": (0, (3, 1, 1, 1)), "marker": "x"},
)

_STATES = ("open", "stick", "slip forward", "slip backward")
_STATE_COLOURS = ("#FFFFFF", "#BBBBBB", "#D55E00", "#0072B2")


def _style(number: int, *, marked: bool = False) -> dict[str, Any]:
    style: dict[str, Any] = dict(_STYLES[number % len(_STYLES)])
    if not marked:
        del style["marker"]
    return style


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(layout="constrained")[1]


def _words(cycle: Cycle) -> str:
    return cycle.name.replace("-", "−")


def _legend(ax: Axes, entries: int) -> None:
    if entries > 1:
        ax.legend(frameon=False)


def loops(result: Result, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    for number, cycle in enumerate(result.cycles):
        ax.plot(1e6 * cycle.displacement, cycle.force_direct, label=_words(cycle), **_style(number))
    ax.set_xlabel("displacement (µm)")
    ax.set_ylabel("force (N)")
    _legend(ax, len(result.cycles))
    return ax


def bump_loads(result: Result, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    shown = [cycle for cycle in result.cycles if "bump_loads" in cycle.quantities]
    for number, cycle in enumerate(shown):
        bumps = np.arange(1, len(cycle.bump_loads) + 1)
        ax.plot(bumps, cycle.bump_loads, label=_words(cycle), markersize=4, **_style(number, marked=True))
    ax.set_xlabel("bump, counted from the weld")
    ax.set_ylabel("load at full displacement (N)")
    _legend(ax, len(shown))
    return ax


def running_lines(table: pandas.DataFrame) -> tuple[str, list[tuple[str, pandas.Series, pandas.DataFrame]]]:
    """Coefficients of running bearings over what varies: frequency, else speed, else load or displacement. Words for it,
    and of each line label, abscissa and rows."""
    by_load = bool(table.load_x_N.notna().all())
    place = ["load_x_N", "load_y_N"] if by_load else ["x_m", "y_m"]
    speed = (table.speed_rad_per_s * 30.0 / np.pi).abs()
    frequencies = table.groupby(["path", "speed_rad_per_s", *place]).frequency_rad_per_s.nunique()
    if frequencies.max() > 1:
        words, over, held = "frequency (Hz)", table.frequency_rad_per_s / (2.0 * np.pi), ["speed_rad_per_s", *place]
    elif speed.nunique() > 1:
        words, over, held = "speed (rpm)", speed, place
    elif by_load:
        words, over, held = "load (N)", np.hypot(table.load_x_N, table.load_y_N), []
    else:
        words, over, held = "displacement (µm)", 1e6 * np.hypot(table.x_m, table.y_m), []
    lines = []
    for _, rows in table.groupby([*held, "path"] if held else "path", sort=False):
        first = rows.iloc[0]
        parts = []
        if "speed_rad_per_s" in held and speed.nunique() > 1:
            parts.append(f"{speed[rows.index[0]]:.6g} rpm")
        if held and len(table[place].drop_duplicates()) > 1:
            unit, size = ("N", 1.0) if by_load else ("µm", 1e6)
            parts.append(f"({size * first[place[0]]:g}, {size * first[place[1]]:g}) {unit}".replace("-", "−"))
        if table.path.nunique() > 1:
            parts.append(first.path.replace("_", " "))
        rows = rows.loc[over[rows.index].sort_values(kind="stable").index]
        lines.append((", ".join(parts), over[rows.index], rows))
    return words, lines


def running_coefficients(result: Result, ax: Axes) -> Axes:
    words, lines = running_lines(result.to_dataframe("coefficients"))
    for number, (label, over, rows) in enumerate(lines):
        for component, name in enumerate(("kxx", "kyy")):
            style = _style(2 * number + component, marked=True)
            text = ", ".join(part for part in (name, label) if part)
            ax.plot(over, 1e-6 * rows[f"{name}_stuck_N_per_m"], label=text, markersize=4, **style)
    ax.set_xlabel(words)
    ax.set_ylabel("stiffness, contacts stuck (MN/m)")
    _legend(ax, 2 * len(lines))
    return ax


def coefficients(result: Result, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    if result.command == "equilibrium":
        return running_coefficients(result, ax)
    table = result.to_dataframe("coefficients")
    table = table.drop_duplicates(["load_x_N", "load_y_N", "amplitude_m"])  # stiffness does not depend on frequency
    number = 0
    loads = list(table.groupby(["load_x_N", "load_y_N"], sort=False))
    for (load_x, load_y), rows in loads:
        for name in ("kxx", "kyy"):
            behind = f", ({load_x:g}, {load_y:g}) N" if len(loads) > 1 else ""
            values = 1e-6 * rows[f"{name}_N_per_m"]
            label = f"{name}{behind}"
            ax.plot(1e6 * rows.amplitude_m, values, label=label, markersize=4, **_style(number, marked=True))
            number += 1
    ax.set_xlabel("amplitude (µm)")
    ax.set_ylabel("stiffness (MN/m)")
    _legend(ax, number)
    return ax


def draw_states(cycle: Cycle, interface: str, colours: Sequence[str], ax: Axes) -> None:
    """A map of the states of contacts along the path."""
    from matplotlib.colors import ListedColormap

    states = cycle.fields[f"state_{interface}"]
    increments, places = states.shape
    ax.pcolormesh(
        np.arange(places + 1) + 0.5,
        np.arange(increments + 1) - 0.5,
        states,
        cmap=ListedColormap(list(colours)),
        vmin=-0.5,
        vmax=3.5,
        rasterized=True,
    )
    feet = interface == "bump_sleeve" and places > cycle.fields["crest_v"].shape[1]
    ax.set_xlabel(f"{'foot' if feet else 'bump'}, counted from the weld")
    ax.set_ylabel("increment")


def contacts(cycle: Cycle, interface: str, ax: Axes | None) -> Axes:
    from matplotlib.patches import Patch

    ax = _axes(ax)
    draw_states(cycle, interface, _STATE_COLOURS, ax)
    ax.set_title(f"{_words(cycle)}, {interface.replace('_', '–')}", fontsize="medium")
    patches = [Patch(facecolor=colour, edgecolor="black", linewidth=0.5) for colour in _STATE_COLOURS]
    ax.legend(patches, _STATES, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=4, frameon=False)
    return ax


def foils(cycle: Cycle, increment: int | None, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    shown = int(np.argmax(cycle.displacement)) if increment is None else increment
    crests = cycle.fields["crest_v"][shown]
    bumps = np.arange(1, len(crests) + 1)
    if "top_displacement" in cycle.fields:
        top = 1e6 * cycle.fields["top_displacement"][shown]
        ax.plot(bumps, top, label="top foil", markersize=4, **_style(0, marked=True))
    ax.plot(bumps, 1e6 * crests, label="crest", markersize=4, **_style(1, marked=True))
    ax.set_xlabel("bump, counted from the weld")
    ax.set_ylabel("radial displacement, outward (µm)")
    ax.set_title(f"{_words(cycle)}, {1e6 * cycle.displacement[shown]:.4g} µm", fontsize="medium")
    _legend(ax, 2)
    return ax
