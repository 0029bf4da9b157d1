"""Plots of results with matplotlib: colours safe for colour-blind readers, lines that survive greyscale print."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .places import Places
from .tables import place_of, target_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas
    import xarray
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
    """Line style: repeated colours get another dash and marker."""
    style: dict[str, Any] = dict(_STYLES[(number + number // len(_STYLES)) % len(_STYLES)])
    style["color"] = _STYLES[number % len(_STYLES)]["color"]
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


def demand(result: Result, picture: str) -> None:
    """Refuses results without the data to plot."""
    there = {
        "loops": bool(result.cycles),
        "bump loads": any("bump_loads" in cycle.quantities for cycle in result.cycles),
        "coefficients": result.command in ("vibration", "equilibrium"),
        "states on asperities": result.command == "equilibrium" and "asperity_share" in result.to_dataframe(),
        "responses to unbalance": result.command == "unbalance",
        "revolutions": result.command == "transient",
        "fitted data": result.command == "fit",
        "evaluated points": result.command == "optimise",
        "free motions": result.command == "stability",
        "distributions": result.command == "montecarlo",
        "quantities over keys": result.command == "sweep",
    }
    if not there[picture]:
        has = ", ".join(name for name in there if there[name]) or "nothing"
        raise ValueError(f"a result of {result.command} has no {picture} to draw; it has {has}")


def known(cycle: Cycle, field: str) -> bool:
    """Whether a cycle has a field, not only space for it, like a strip read from a file."""
    return field in cycle.fields and not np.isnan(cycle.fields[field].astype(float)).all()


def demand_fields(cycle: Cycle, names: Sequence[str]) -> None:
    """Refuses cycles without the fields to plot."""
    absent = [name for name in names if not known(cycle, name)]
    if absent:
        kind = absent[0].split("_")[0]
        has = ", ".join(name for name in cycle.fields if name.startswith(kind) and known(cycle, name)) or f"no {kind}"
        raise ValueError(f"{cycle.name}: has no {', '.join(absent)} to draw; it has {has}")


def direction_name(degrees: float) -> str:
    return {0.0: "+X", 90.0: "+Y", 180.0: "−X", 270.0: "−Y"}.get(degrees, f"{degrees:g}°")


def loops(result: Result, ax: Axes | None) -> Axes:
    demand(result, "loops")
    ax = _axes(ax)
    for number, cycle in enumerate(result.cycles):
        ax.plot(1e6 * cycle.displacement, cycle.force_direct, label=_words(cycle), **_style(number))
    ax.set_xlabel("displacement (µm)")
    ax.set_ylabel("force (N)")
    _legend(ax, len(result.cycles))
    return ax


def bump_loads(result: Result, ax: Axes | None) -> Axes:
    demand(result, "bump loads")
    ax = _axes(ax)
    shown = [cycle for cycle in result.cycles if "bump_loads" in cycle.quantities]
    for number, cycle in enumerate(shown):
        places = Places(cycle.bump_pad)
        ax.plot(*places.line(cycle.bump_loads), label=_words(cycle), markersize=4, **_style(number, marked=True))
    Places(shown[0].bump_pad).mark(ax)
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
    ax.set_ylabel("stiffness, full stick (MN/m)")
    _legend(ax, 2 * len(lines))
    return ax


def _quantity(result: Result, name: str, dims: Sequence[str]) -> xarray.DataArray:
    """A variable over all these dimensions and no others, in the words of the file."""
    data = result.to_xarray()
    names = [str(one) for one, values in data.data_vars.items() if set(values.dims) == set(dims) and values.attrs.get("units")]
    if name not in names:
        raise ValueError(f"a result of {result.command} has no {name!r} over {', '.join(dims)}; it has {', '.join(names)}")
    return data[name].transpose(*dims)


def _named(values: xarray.DataArray) -> str:
    unit = values.attrs.get("units", "1").replace("degree", "°")
    words = str(values.attrs.get("case_key", values.name)).replace("_", " ")
    return words if unit == "1" else f"{words} ({unit})"


def _place(coordinate: xarray.DataArray, number: float) -> str:
    if coordinate.name == "direction":
        return direction_name(number)
    unit = coordinate.attrs.get("units", "1")
    return f"{coordinate.attrs.get('case_key', coordinate.name)} {number:.6g}" + (f" {unit}" if unit != "1" else "")


def places_of(result: Result, data: xarray.Dataset) -> list[str]:
    """Legend labels of these places, in order."""
    if place_of(data) == "direction":
        return [direction_name(float(degrees)) for degrees in data.direction]
    return [name.replace("-", "−") for name in result.summary["statistics"]]


def ensemble(result: Result, quantity: str | None, ax: Axes | None) -> Axes:
    demand(result, "distributions")
    every = result.to_xarray()
    place = place_of(every)
    data = _quantity(result, quantity or target_of(every), [place, "sample"])
    ax = _axes(ax)
    edges = np.histogram_bin_edges(data.values[np.isfinite(data.values)], min(40, int(np.sqrt(data.sizes["sample"])) + 1))
    for number, (label, samples) in enumerate(zip(places_of(result, every), data)):
        ax.hist(samples.values[np.isfinite(samples.values)], edges, histtype="step", label=label, **_style(number))
    ax.set_xlabel(_named(data))
    ax.set_ylabel("bearings")
    _legend(ax, len(data))
    return ax


def sweep(result: Result, quantity: str, ax: Axes | None) -> Axes:
    demand(result, "quantities over keys")
    dims = [str(name) for name in result.to_xarray()["status"].dims]
    data = _quantity(result, quantity, dims)
    ax = _axes(ax)
    first, others = dims[0], dims[1:]
    lines = data.stack(line=others).transpose("line", first) if others else data.expand_dims("line")
    for number, line in enumerate(lines):
        parts = [_place(data[name], line.coords[name].item()) for name in others if data.sizes[name] > 1]
        ax.plot(data[first].values, line.values, label=", ".join(parts), markersize=4, **_style(number, marked=True))
    ax.set_xlabel(_named(data[first]))
    ax.set_ylabel(_named(data))
    _legend(ax, len(lines))
    return ax


def coefficients(result: Result, ax: Axes | None) -> Axes:
    demand(result, "coefficients")
    ax = _axes(ax)
    if result.command == "equilibrium":
        return running_coefficients(result, ax)
    table = result.to_dataframe("coefficients")
    table = table.drop_duplicates(["load_x_N", "load_y_N", "amplitude_m"])  # stiffness does not depend on frequency
    number = 0
    loads = list(table.groupby(["load_x_N", "load_y_N"], sort=False))
    for (load_x, load_y), rows in loads:
        for name in ("kxx", "kyy"):
            behind = f", ({load_x:g}, {load_y:g}) N".replace("-", "−") if len(loads) > 1 else ""
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
    feet = interface == "bump_sleeve"
    more = states.shape[1] > cycle.fields["crest_v"].shape[1]
    ax.pcolormesh(
        np.arange(states.shape[1] + 1) + 0.5,
        np.arange(len(states) + 1) - 0.5,
        states,
        cmap=ListedColormap(list(colours)),
        vmin=-0.5,
        vmax=3.5,
        rasterized=True,
    )
    Places(cycle.foot_pad if feet else cycle.bump_pad, "foot" if more else "bump", room=0).mark(ax)
    ax.set_ylabel("increment")
    farthest = int(np.argmax(cycle.displacement))
    if farthest < len(states) - 1:
        ax.axhline(farthest, label="largest displacement", color="black", linewidth=0.8, linestyle=(0, (4, 2)))


def contacts(cycle: Cycle, interface: str, ax: Axes | None) -> Axes:
    from matplotlib.patches import Patch

    demand_fields(cycle, [f"state_{interface}"])
    ax = _axes(ax)
    draw_states(cycle, interface, _STATE_COLOURS, ax)
    ax.set_title(f"{_words(cycle)}, {interface.replace('_', '–')}", fontsize="medium")
    handles = [
        *(Patch(facecolor=colour, edgecolor="black", linewidth=0.5, label=state) for colour, state in zip(_STATE_COLOURS, _STATES)),
        *ax.get_legend_handles_labels()[0],
    ]
    ax.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=5, frameon=False, columnspacing=1.0)
    return ax


def foils(cycle: Cycle, increment: int | None, ax: Axes | None) -> Axes:
    demand_fields(cycle, ["crest_v"])
    ax = _axes(ax)
    shown = int(np.argmax(cycle.displacement)) if increment is None else increment
    places = Places(cycle.bump_pad)
    if "top_displacement" in cycle.fields:
        top = 1e6 * cycle.fields["top_displacement"][shown]
        ax.plot(*places.line(top), label="top foil", markersize=4, **_style(0, marked=True))
    crests = 1e6 * cycle.fields["crest_v"][shown]
    ax.plot(*places.line(crests), label="crest", markersize=4, **_style(1, marked=True))
    places.mark(ax)
    ax.set_ylabel("radial displacement, outward (µm)")
    ax.set_title(f"{_words(cycle)}, {1e6 * cycle.displacement[shown]:.4g} µm", fontsize="medium")
    _legend(ax, 2)
    return ax
