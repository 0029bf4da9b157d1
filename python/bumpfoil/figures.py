"""Publication figures: one or two columns wide, saved as PDF and SVG.

>>> from bumpfoil import figures
>>> figures.save(figures.loops(bumpfoil.run_cycle("case.toml"), width="double"), "loops")

Each function returns a matplotlib figure in its final size, in which everything can still be changed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from .figure_sheet import Sheet, arranged, save, styled
from .paper_figures import paper
from .places import Places
from .plots import _style, _words, demand, demand_fields, draw_states, known, places_of, running_lines
from .tables import of_csv, place_of, sampled_command, target_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from .cycle import Cycle
    from .result import Result

__all__ = [
    "bode",
    "bump_loads",
    "campbell",
    "coefficients",
    "contacts",
    "ensemble",
    "fitted",
    "foils",
    "loops",
    "orbits",
    "paper",
    "polar",
    "root_locus",
    "run_up",
    "save",
]

_STATES = ("open", "stick", "slip to the free end", "slip to the weld")
_STATE_COLOURS = ("#FFFFFF", "#CCCCCC", "#E69F00", "#004B87")  # in grey print 1, 0.8, 0.66 and 0.26
_INTERFACES = {"journal_top": "journal on top foil", "top_bump": "top foil on bump", "bump_sleeve": "bump on sleeve"}

#: Rows of the matrices of coefficients: forces, with their direct and their cross entry.
_FORCES = ("Fx: xx, xy", "Fy: yy, yx")
_DASHES = ("-", "--")

#: What figures call columns of measured data, where they do not have their names.
_MEASURED = {"loss_factor": "loss factor", "h_min": "film thickness"}
#: Units of figures by those of files, with their sizes.
_READ_UNITS = {
    "1": ("", 1.0), "m": ("µm", 1e-6), "N": ("N", 1.0), "N/m": ("MN/m", 1e6), "N m": ("N mm", 1e-3), "N s/m": ("N s/m", 1.0),
    "rad/s": ("Hz", 2 * np.pi),
}  # fmt: skip

#: A mark on the axis of a histogram.
_MEAN = {"linestyle": "none", "markersize": 5, "markeredgecolor": "white", "markeredgewidth": 0.4}


@styled
def loops(result: Result, *, width: str = "single") -> Figure:
    """Direct force against displacement: all cycles in one panel, or, in two columns, each in its own.

    Parameters
    ----------
    result : Result
        Of ``cycle``, ``strip`` or ``path``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand(result, "loops")
    apart = width == "double" and len(result.cycles) > 1
    least, most = (extreme(float(extreme(cycle.force_direct)) for cycle in result.cycles) for extreme in (min, max))
    sheet = Sheet(width, *arranged(width, len(result.cycles) if apart else 1), panel_height=50)
    for number, cycle in enumerate(result.cycles):
        ax = sheet.panels[number if apart else 0]
        ax.plot(1e6 * cycle.displacement, cycle.force_direct, label=_words(cycle), **_style(0 if apart else number))
        ax.set_xlabel("displacement (µm)")
        ax.set_ylabel("force (N)")
        ax.set_ylim(least - 0.05 * (most - least), most + 0.05 * (most - least))
    sheet.entitle([_words(cycle) for cycle in result.cycles] if apart else [""])
    return sheet.finish([] if apart else None)


@styled
def fitted(result: Result, *, width: str = "double") -> Figure:
    """Measured values, fitted model, and residuals in standard deviations: two panels for each quantity.

    Parameters
    ----------
    result : Result
        Of ``fit``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand(result, "fitted data")
    table = of_csv(result, "fit")
    panels = list(table.groupby(["data", "quantity"], sort=False))
    # A curve has the same look in all panels of its data.
    looks: dict[tuple[Any, ...], int] = {}
    handles: dict[str, Any] = {}
    sheet = Sheet(width, *arranged(width, 2 * len(panels)), panel_height=50)
    titles: list[str] = []
    for ((number, quantity), points), values, residuals in zip(panels, sheet.panels[::2], sheet.panels[1::2]):
        name, (unit, size) = _MEASURED.get(quantity, quantity), _READ_UNITS[points.unit.iloc[0]]
        axis = points.axis.iloc[0]
        axis_unit, axis_size = ("rpm", np.pi / 30) if axis == "Speed" else _READ_UNITS[points.axis_unit.iloc[0]]
        for series, curve in points.groupby("series", sort=False):
            look = looks.setdefault((number if len(points.series.unique()) > 2 else 0, series), len(looks))
            marks = {**_style(look, marked=True), "linestyle": "none"}
            place, named = curve.point_place / axis_size, series.replace("-", "−")
            (mark,) = values.plot(place, curve.measured_value / size, label=f"measured, {named}", **marks)
            (line,) = values.plot(place, curve.model_value / size, label=f"fitted, {named}", **_style(look))
            residuals.plot(place, curve.value_residual / curve.value_deviation, **marks)
            handles.update({mark.get_label(): mark, line.get_label(): line})
        for bound in (-2, 2):
            residuals.axhline(bound, color="#888888", linewidth=0.6, linestyle=":")
        for ax, words in ((values, f"{name} ({unit})" if unit else name), (residuals, "residual / standard deviation")):
            ax.set_xlabel(f"{axis.lower()} ({axis_unit})")
            ax.set_ylabel(words)
        of_data = f"data {number}, {name}" if len(result.summary["data"]) > 1 else name
        titles += [of_data, f"{of_data}: residuals"]
    sheet.entitle(titles)
    return sheet.finish(list(handles.values()))


@styled
def optimised(result: Result, *, width: str = "double") -> Figure:
    """The points that were evaluated: the first aim over every key and, with two aims, their front.

    Parameters
    ----------
    result : Result
        Of ``optimise``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand(result, "evaluated points")
    data = result.to_xarray()
    keys, aims = ([(one[name], one["unit"]) for one in result.summary[part]] for part, name in (("keys", "key"), ("aims", "quantity")))
    values = [*data.key_value.values.T, *data.aim_value.values.T]
    named = [*keys, *aims]
    first = len(keys)
    pairs = [(number, first) for number in range(first)] + ([(first, first + 1)] if len(aims) > 1 else [])
    sheet = Sheet(width, *arranged(width, len(pairs)), panel_height=55)
    feasible = data.feasible.values == 1
    best = result.summary["best_point"]
    for ax, (across, upwards) in zip(sheet.panels, pairs):
        (x, x_words), (y, y_words) = (_shown(values[number], *named[number]) for number in (across, upwards))
        if not feasible.all():
            ax.plot(x[~feasible], y[~feasible], "o", markerfacecolor="none", color="#888888", label="misses a limit")
        ax.plot(x[feasible], y[feasible], label="meets all limits", **{**_style(0, marked=True), "linestyle": "none"})
        if upwards > first:
            ax.plot(x[result.summary["front"]], y[result.summary["front"]], label="front", zorder=3, **_style(1, marked=True))
        if best is not None:
            ax.plot(x[best], y[best], "s", markerfacecolor="none", color="#000000", markersize=9, label="best")
        ax.set_xlabel(x_words)
        ax.set_ylabel(y_words)
    sheet.entitle([f"{named[upwards][0]} over {named[across][0]}" for across, upwards in pairs])
    return sheet.finish(sheet.panels[-1].get_legend_handles_labels()[0])  # the last has the front, too


def _shown(values: Any, name: str, unit: str) -> tuple[Any, str]:
    """Values in a unit that people read, with the words of their axis."""
    factor, shown = {"m": (1e6, "µm"), "rad": (180 / np.pi, "°"), "N/m": (1e-6, "MN/m"), "1": (1, "")}.get(unit, (1, unit))
    return factor * values, f"{name} ({shown})" if shown else name


@styled
def bump_loads(result: Result, *, width: str = "single") -> Figure:
    """Bump loads at full displacement, a panel for each cycle, all on the same scale.

    Parameters
    ----------
    result : Result
        Of ``cycle``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand(result, "bump loads")
    shown = [cycle for cycle in result.cycles if "bump_loads" in cycle.quantities]
    sheet = Sheet(width, *arranged(width, len(shown)), panel_height=35)
    most = max(float(np.max(cycle.bump_loads)) for cycle in shown)
    for ax, cycle in zip(sheet.panels, shown):
        places = Places(cycle.bump_pad)
        ax.bar(places.at, cycle.bump_loads, width=0.8, color="#8FB8DE", edgecolor="black", linewidth=0.5)
        ax.set(xlim=(0.3, places.at[-1] + 0.7), ylim=(0, 1.05 * most))
        places.mark(ax)
        ax.set_ylabel("bump load (N)")
    sheet.entitle([_words(cycle) for cycle in shown])
    return sheet.finish([])


@styled
def foils(cycle: Cycle, increments: Sequence[int] | None = None, *, width: str = "double") -> Figure:
    """Deformed foils, unwrapped: crests, top foil and journal over the undeformed top foil.

    Parameters
    ----------
    cycle : Cycle
        Of ``cycle`` or ``path``.
    increments : sequence of int, optional
        A panel for each; by default the start, middle and end of the path to the largest displacement.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand_fields(cycle, ["top_displacement", "gap_journal_top", "gap_top_bump"])
    turning = int(np.argmax(cycle.displacement))
    shown = [0, turning // 2, turning] if increments is None else list(increments)
    columns = min(len(shown), 3 if width == "double" else 1)
    sheet = Sheet(width, columns, -(-len(shown) // columns), panel_height=40)
    top = -1e6 * cycle.fields["top_displacement"][shown]
    journal = top + 1e6 * cycle.fields["gap_journal_top"][shown]
    crests = top - 1e6 * cycle.fields["gap_top_bump"][shown]
    lowest, highest = min(crests.min(), top.min()), max(journal.max(), top.max())
    room = 0.08 * (highest - lowest)
    places = Places(cycle.bump_pad)
    for panel, ax in enumerate(sheet.panels[: len(shown)]):
        base = lowest - room
        ax.bar(places.at, crests[panel] - base, bottom=base, width=0.8, color="#D4D4D4", edgecolor="black", linewidth=0.5,
               label="crests")
        ax.plot(*places.line(top[panel]), label="top foil", **_style(0, marked=True))
        ax.plot(*places.line(journal[panel]), label="journal", **_style(1))
        ax.set(xlim=(0.3, places.at[-1] + 0.7), ylim=(base, highest + room))
        places.mark(ax)
        ax.set_ylabel("height (µm)")
    sheet.entitle([f"{_words(cycle)}, {1e6 * cycle.displacement[k]:.3g} µm" for k in shown])
    return sheet.finish()


@styled
def contacts(cycle: Cycle, *, width: str = "double") -> Figure:
    """Contact map: which contacts are open, stick or slip at every increment, a panel for each interface.

    Parameters
    ----------
    cycle : Cycle
        Of ``cycle`` or ``path``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    from matplotlib.patches import Patch

    shown = [interface for interface in _INTERFACES if known(cycle, f"state_{interface}")]
    if not shown:
        demand_fields(cycle, [f"state_{interface}" for interface in _INTERFACES])
    columns = len(shown) if width == "double" else 1
    sheet = Sheet(width, columns, len(shown) // columns, panel_height=45 if width == "double" else 35)
    for ax, interface in zip(sheet.panels, shown):
        draw_states(cycle, interface, _STATE_COLOURS, ax)
    sheet.entitle([_INTERFACES[interface] for interface in shown])
    states = [
        Patch(facecolor=colour, edgecolor="black", linewidth=0.5, label=state)
        for colour, state in zip(_STATE_COLOURS, _STATES)
    ]
    return sheet.finish([*states, *sheet.panels[0].get_legend_handles_labels()[0]])


@styled
def ensemble(result: Result, *, width: str = "double") -> Figure:
    """Distributions of the main quantities of the sampled command, by direction, state or rotor, and their means.

    For cycles maximum force, structural stiffness, loop energy and loss factor; for running bearings minimum film thickness,
    eccentricity, attitude angle and power loss; for rotors onsets of whirl, or amplitudes and film thickness.

    Parameters
    ----------
    result : Result
        Of ``montecarlo``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand(result, "distributions")
    data = result.to_xarray()
    shown = [(name, f"{words} ({unit.replace('um', 'µm')})" if unit else words, size)
             for name, _, words, unit, size in _native.headlines(sampled_command(result.summary))
             if name in data and np.isfinite(data[name]).any()]
    target = target_of(data)
    shown.sort(key=lambda one: one[0] != target)
    sheet = Sheet(width, *arranged(width, len(shown)), panel_height=38)
    for ax, (name, words, size) in zip(sheet.panels, shown):
        values = {place: one.values[np.isfinite(one.values)] / size
                  for place, one in zip(places_of(result, data), data[name].transpose(place_of(data), "sample"))}
        together = np.concatenate(list(values.values()))
        edges = np.histogram_bin_edges(together, min(40, int(np.sqrt(len(together))) + 1))
        for number, (place, samples) in enumerate(values.items()):
            style = _style(number)
            ax.hist(samples, edges, histtype="step", linewidth=1.2, label=place, color=style["color"],
                    linestyle=style["linestyle"])
            ax.plot(samples.mean(), 0.04, transform=ax.get_xaxis_transform(), **{**_style(number, marked=True), **_MEAN})
        ax.set_xlabel(words)
        ax.ticklabel_format(axis="x", scilimits=(-2, 5))
        ax.set_ylabel("bearings")
        ax.yaxis.get_major_locator().set_params(integer=True)
        ax.margins(y=0.08)
    sheet.entitle([""] * len(shown))
    return sheet.finish(_lines(sheet, data.sizes[place_of(data)]))


def _lines(sheet: Sheet, count: int) -> list[Any]:
    """Lines in place of the frames that stand for histograms, with the marks of their means."""
    from matplotlib.lines import Line2D

    labels = sheet.panels[0].get_legend_handles_labels()[1]
    mean = Line2D([], [], label="mark: mean", linestyle="none")
    shown = enumerate(labels[:count])
    return [*(Line2D([], [], label=label, markersize=5, **_style(number, marked=True)) for number, label in shown), mean]


def _coefficients_drawn(width: str, panels: Sequence[tuple[str, str, Sequence[Any]]], words: str,
                        lines: Sequence[tuple[str, Any, Any]]) -> Figure:
    """Panels of title, ordinate and the values of both forces; lines of label, abscissa and rows of the values. Marks and
    colours tell lines apart, dashes and filled marks forces, so that the legend has an entry for each and not for all pairs."""
    from matplotlib.lines import Line2D

    sheet = Sheet(width, *arranged(width, len(panels)), panel_height=40 if width == "double" else 36)
    for ax, (_, ordinate, both) in zip(sheet.panels, panels):
        for dash, values in zip(_DASHES, both):
            for number, (_, over, rows) in enumerate(lines):
                style = {**_style(number, marked=True), "linestyle": dash}
                ax.plot(over, values[rows], **{**style, "markerfacecolor": style["color"] if dash == "-" else "white"})
        ax.set_xlabel(words)
        ax.set_ylabel(ordinate)
    sheet.entitle([title for title, *_ in panels])
    several = len(lines) > 1
    colour = "black" if several else _style(0)["color"]
    handles = [
        Line2D([], [], color=colour, linestyle=dash, marker="o", markerfacecolor=colour if dash == "-" else "white", label=force)
        for dash, force in zip(_DASHES, _FORCES)
    ]
    if several:
        handles += [
            Line2D([], [], label=label, **{**_style(number, marked=True), "linestyle": "none", "markersize": 5})
            for number, (label, *_) in enumerate(lines)
        ]
    return sheet.finish(handles)


def _running_coefficients(result: Result, width: str, contacts: str) -> Figure:
    table = result.to_dataframe("coefficients")
    words, lines = running_lines(table)
    behind = "_stuck" if contacts == "stuck" else ""
    panels = [
        (title, f"{symbol} ({unit})", [size * table[f"{symbol.lower()}{axes}{behind}_{ending}"] for axes in pair])
        for symbol, unit, size, ending, kind in (
            ("K", "MN/m", 1e-6, "N_per_m", "stiffness"),
            ("C", "kN s/m", 1e-3, "N_s_per_m", "damping"),
        )
        for title, pair in ((f"direct {kind}", ("xx", "yy")), (f"cross {kind}", ("xy", "yx")))
    ]
    return _coefficients_drawn(width, panels, words, [(label, over, rows.index) for label, over, rows in lines])


@styled
def coefficients(result: Result, *, width: str = "double", contacts: str = "stuck") -> Figure:
    """Stiffness and damping for rotor dynamics.

    For vibrations direct stiffness, cross stiffness, loss stiffness and loss factor against amplitude; for running
    bearings direct and cross stiffness and damping against frequency, speed or load, whichever varies.

    Parameters
    ----------
    result : Result
        Of ``vibration`` or ``equilibrium``.
    width : {"single", "double"}
        90 or 190 mm.
    contacts : {"stuck", "slipping"}
        For a running bearing: full stick, or sliding contacts that keep sliding.
    """
    demand(result, "coefficients")
    if contacts not in ("stuck", "slipping"):
        raise ValueError(f"contacts is {contacts!r}; it is one of stuck, slipping")
    if result.command == "equilibrium":
        return _running_coefficients(result, width, contacts)
    table = result.to_dataframe("coefficients")
    # Stiffness and frequency times damping are the same at every frequency: friction is rate-independent.
    table = table.drop_duplicates(["load_x_N", "load_y_N", "amplitude_m"])
    turn = 1e-6 * table.frequency_rad_per_s
    panels = [
        ("direct stiffness", "K (MN/m)", [1e-6 * table[f"k{axes}_N_per_m"] for axes in ("xx", "yy")]),
        ("cross stiffness", "K (MN/m)", [1e-6 * table[f"k{axes}_N_per_m"] for axes in ("xy", "yx")]),
        ("direct damping times frequency", "ωC (MN/m)", [turn * table[f"c{axes}_N_s_per_m"] for axes in ("xx", "yy")]),
        ("loss factor", "loss factor", [table[f"loss_factor_{axis}"] for axis in "xy"]),
    ]
    lines = [
        (f"load ({load_x:g}, {load_y:g}) N".replace("-", "−"), 1e6 * rows.amplitude_m, rows.index)
        for (load_x, load_y), rows in table.groupby(["load_x_N", "load_y_N"], sort=False)
    ]
    return _coefficients_drawn(width, panels, "amplitude (µm)", lines)


@styled
def waterfall(result: Result, *, width: str = "single", station: int = 1, axis: str = "x", orders: float = 3.0) -> Figure:
    """Spectra of the motion of a rotor in time, one above the other: amplitude over frequency, from speed to speed.

    Dashed lines are at half the rotation frequency, at it and at twice it.

    Parameters
    ----------
    result : Result
        Of ``transient``.
    width : {"single", "double"}
        90 or 190 mm.
    station : int
        Place on the rotor, from 1: its bearings first.
    axis : {"x", "y"}
        Direction.
    orders : float
        Highest frequency over that of rotation at the highest speed.
    """
    demand(result, "revolutions")
    if axis not in ("x", "y"):
        raise ValueError(f"axis is {axis!r}; it is one of x, y")
    data = result.to_xarray()
    spectra = 1e6 * data["spectrum_amplitude"].isel(station=station - 1, axis="xy".index(axis)).to_numpy()
    speed = abs(data["spectrum_speed"].to_numpy()) / (2.0 * np.pi)
    if len(speed) == 0:
        raise ValueError("the run has no spectrum: march more revolutions, or give fewer revolutions_per_spectrum")
    order = data["order"].to_numpy()
    sheet = Sheet(width, 1, 1, panel_height=90)
    (ax,) = sheet.panels
    rpm = 60.0 * speed
    spread = np.ptp(rpm) or 0.1 * rpm[0]
    height = spread / max(len(rpm), 4) * 3.0 / max(spectra.max(), 1e-12)
    end = orders * speed.max()
    # What is in front hides what is behind it.
    for place in np.argsort(-rpm):
        shown = order * speed[place] <= end
        base = rpm[place]
        line = base + height * spectra[place][shown]
        ax.fill_between(order[shown] * speed[place], base, line, color="white", zorder=-base)
        ax.plot(order[shown] * speed[place], line, color="black", linewidth=0.5, zorder=-base)
    for ratio, label in ((0.5, "½x"), (1.0, "1x"), (2.0, "2x")):
        if ratio <= orders:
            ends = np.array([rpm.min(), rpm.max()])
            ax.plot(ratio * ends / 60.0, ends, color="grey", linewidth=0.5, linestyle="--", zorder=1)
            ax.annotate(label, (ratio * rpm.max() / 60.0, rpm.max()), textcoords="offset points", xytext=(2, 2), color="grey")
    ax.set_xlim(0.0, end)
    ax.set_xlabel("frequency (Hz)")
    ax.set_ylabel("speed (rpm)")
    ax.set_title(f"station {station}, {axis.upper()}: largest {spectra.max():.3g} µm")
    return sheet.finish(None)


@styled
def revolutions(result: Result, *, width: str = "double", station: int = 1) -> Figure:
    """A rotor revolution by revolution: amplitudes at the rotation frequency and at half of it, half the
    peak-to-peak displacement, minimum film thickness, speed, and friction loss of the foils, over time.

    Parameters
    ----------
    result : Result
        Of ``transient``.
    width : {"single", "double"}
        90 or 190 mm.
    station : int
        Place on the rotor, from 1: its bearings first.
    """
    demand(result, "revolutions")
    data = result.to_xarray()
    time = 1e3 * data["revolution_time"].to_numpy()
    if len(time) == 0:
        raise ValueError("the run has no whole revolution")
    at = data.isel(station=station - 1)
    sheet = Sheet(width, *arranged(width, 4), panel_height=50)
    way, film, speed, friction = sheet.panels
    for number, (name, label) in enumerate(
        (("half_peak_to_peak", "half peak to peak"), ("amplitude", "1x"), ("amplitude_half", "1/2x"))
    ):
        for axis, dashes in (("x", "-"), ("y", "--")):
            key = f"amplitude_{axis}_half" if name == "amplitude_half" else f"{name}_{axis}"
            way.plot(time, 1e6 * at[key].to_numpy(), label=f"{axis.upper()}, {label}", color=_style(number)["color"], linestyle=dashes)
    way.set_ylabel("motion (µm)")
    way.set_ylim(bottom=0.0)
    film.plot(time, 1e6 * data["thinnest_film"].min("station").to_numpy(), **_style(0))
    film.set_ylabel("minimum film thickness (µm)")
    film.set_ylim(bottom=0.0)
    speed.plot(time, abs(data["revolution_speed"].to_numpy()) * 30.0 / np.pi, **_style(0))
    speed.set_ylabel("speed (rpm)")
    friction.plot(time, 1e6 * data["revolution_friction_loss"].to_numpy(), **_style(0))
    friction.set_ylabel("friction of foils (µJ)")
    friction.set_ylim(bottom=0.0)
    for ax in sheet.panels:
        ax.set_xlabel("time (ms)")
    sheet.entitle([f"motion of station {station}", "film", "speed", "loss in a revolution"])
    return sheet.finish(None)


def _modes(result: Result, contacts: str) -> Any:
    """Free motions with these contacts, mode by mode: (name, rows of stability.csv)."""
    demand(result, "free motions")
    if contacts not in ("stuck", "sliding"):
        raise ValueError(f"contacts is {contacts!r}; it is one of stuck, sliding")
    table = result.to_dataframe()
    for mode, rows in table[table.contacts == contacts].groupby("mode", sort=True):
        if not (rows.imag_rad_per_s.any() or (rows.real_rad_per_s > 0).any()):
            continue  # it neither oscillates nor grows
        yield int(mode), rows, f"mode {mode:.0f}" + (", foils" if rows.of_foils.mean() > 0.5 else "")


def _draw_mode(ax: Any, number: int, label: str, x: Any, y: Any, grows: Any) -> None:
    """A line with hollow marks, filled where the motion grows."""
    style = _style(number, marked=True)
    ax.plot(x, y, label=label, markerfacecolor="white", **style)
    ax.plot(x[grows], y[grows], linestyle="none", marker=style["marker"], color=style["color"])


def _responses(result: Result, station: str | None) -> tuple[str, list[tuple[str, dict[str, str], Any]]]:
    """A station and its responses: (words, style of lines, rows of unbalance.csv) of each kind."""
    demand(result, "responses to unbalance")
    table = result.to_dataframe()
    known = list(dict.fromkeys(table.station))
    name = known[0] if station is None else station
    if name not in known:
        raise ValueError(f"station is {station!r}; it is one of {', '.join(known)}")
    kinds = (
        ("linear_stuck", "full stick", {"linestyle": "-"}),
        ("linear_sliding", "contacts sliding", {"linestyle": "--"}),
        ("orbit", "orbit with friction", {"linestyle": "none", "marker": "o"}),
    )
    found = [(words, line, table[(table.station == name) & (table.kind == kind)]) for kind, words, line in kinds]
    return name, [one for one in found if not one[2].empty]


@styled
def bode(result: Result, *, width: str = "double", station: str | None = None) -> Figure:
    """Bode plot of the response of a rotor to unbalance: amplitudes and phases along X and Y over speed.

    Solid lines: full stick, as in a small orbit; dashed lines: sliding contacts keep sliding; marks: periodic orbits
    with friction, where the result has them.

    Parameters
    ----------
    result : Result
        Of ``unbalance``.
    width : {"single", "double"}
        90 or 190 mm.
    station : str, optional
        Place on the rotor, by its name in unbalance.csv; by default the first bearing.
    """
    name, responses = _responses(result, station)
    sheet = Sheet(width, *arranged(width, 2), panel_height=60)
    amplitude, phase = sheet.panels
    for words, line, rows in responses:
        rpm = abs(rows.speed_rad_per_s) * 30.0 / np.pi
        for number, axis in enumerate("xy"):
            label = f"{axis.upper()}, {words}"
            style = {"color": _style(number)["color"], **line}
            amplitude.plot(rpm, 1e6 * rows[f"amplitude_{axis}_m"], label=label, **style)
            unwrapped = np.degrees(np.unwrap(np.radians(rows[f"phase_{axis}_deg"].to_numpy())))
            phase.plot(rpm, unwrapped, **style)
    amplitude.set_ylabel("amplitude (µm)")
    amplitude.set_ylim(bottom=0.0)
    phase.set_ylabel("phase (degrees)")
    for ax in sheet.panels:
        ax.set_xlabel("speed (rpm)")
    sheet.entitle([f"amplitude, {name}", "phase"])
    return sheet.finish(None)


@styled
def polar(result: Result, *, width: str = "single", station: str | None = None) -> Figure:
    """Polar plot of the response of a rotor to unbalance: amplitude times cosine and sine of the phase, from speed to speed.

    Lines and marks are those of :func:`bode`; the mark of the last speed is larger.

    Parameters
    ----------
    result : Result
        Of ``unbalance``.
    width : {"single", "double"}
        90 or 190 mm.
    station : str, optional
        Place on the rotor, by its name in unbalance.csv; by default the first bearing.
    """
    name, responses = _responses(result, station)
    sheet = Sheet(width, 1, 1, panel_height=60)
    (ax,) = sheet.panels
    for words, line, rows in responses:
        for number, axis in enumerate("xy"):
            motion = 1e6 * rows[f"amplitude_{axis}_m"] * np.exp(1j * np.radians(rows[f"phase_{axis}_deg"]))
            style = {"color": _style(number)["color"], **line}
            ax.plot(motion.to_numpy().real, motion.to_numpy().imag, label=f"{axis.upper()}, {words}", **style)
            last = motion.dropna().to_numpy()[-1:]
            ax.plot(last.real, last.imag, linestyle="none", marker="o", color=style["color"], markersize=5)
    for at in (ax.axhline, ax.axvline):
        at(0.0, color="0.6", linewidth=0.6, zorder=0)
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_xlabel("amplitude · cos(phase) (µm)")
    ax.set_ylabel("amplitude · sin(phase) (µm)")
    sheet.entitle([name])
    return sheet.finish(ax.get_legend_handles_labels()[0])


@styled
def orbits(result: Result, *, width: str = "single", speed: float | None = None) -> Figure:
    """Orbits of the journals of a rotor under unbalance, about their centres in equilibrium or their means.

    Small ones at full stick and with contacts sliding, and the periodic one with friction, of two harmonics, where the result has
    it; a dot where the rotor is at angle 0.

    Parameters
    ----------
    result : Result
        Of ``unbalance``.
    width : {"single", "double"}
        90 or 190 mm.
    speed : float, optional
        One of the result, rpm, the next one to it; by default that of the largest amplitude.
    """
    demand(result, "responses to unbalance")
    data = result.to_xarray()
    rpm = np.abs(data.speed.values) * 30.0 / np.pi
    wanted = float(data.largest_amplitude_speed) * 30.0 / np.pi if speed is None else abs(speed)
    at = data.isel(speed=int(np.nanargmin(np.abs(rpm - wanted))))
    turns = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 181))
    bearings = data.sizes["bearing"]
    sheet = Sheet(width, *arranged(width, bearings), panel_height=60)
    for bearing, ax in enumerate(sheet.panels):
        for kind, words, line, number in ((1, "full stick", "-", 0), (0, "contacts sliding", "--", 0), (2, "orbit with friction", "-", 1)):
            if kind >= data.sizes["kind"]:
                continue
            own = at.isel(kind=kind, station=bearing)
            place = []
            for axis in "xy":
                once = float(own[f"amplitude_{axis}"]) * np.exp(1j * np.radians(float(own[f"phase_{axis}"])))
                mean = float(own[f"mean_{axis}"]) if kind == 2 else float(at[axis].isel(bearing=bearing))
                along = mean + (once * turns).real
                if kind == 2:
                    twice = float(own[f"amplitude_{axis}_2x"]) * np.exp(1j * np.radians(float(own[f"phase_{axis}_2x"])))
                    along = along + (twice * turns**2).real
                place.append(1e6 * along)
            colour = _style(number)["color"]
            ax.plot(*place, linestyle=line, color=colour, label=words)
            ax.plot(place[0][:1], place[1][:1], marker="o", color=colour)
        ax.set_aspect("equal", adjustable="datalim")
        ax.set_xlabel("X (µm)")
        ax.set_ylabel("Y (µm)")
    shown = abs(float(at.speed)) * 30.0 / np.pi
    sheet.entitle([f"bearing {bearing + 1}, {shown:.6g} rpm" for bearing in range(bearings)])
    return sheet.finish(sheet.panels[0].get_legend_handles_labels()[0])


@styled
def campbell(result: Result, *, width: str = "double", contacts: str = "sliding") -> Figure:
    """Campbell diagram of a rotor on its bearings, and the growth of its motions over speed.

    Damped frequencies, with lines at the rotation frequency and at half of it; growth rates over the speed of
    rotation, and those by synchronous coefficients for the motion that grows fastest. Marks are filled where a motion
    grows.

    Parameters
    ----------
    result : Result
        Of ``stability``.
    width : {"single", "double"}
        90 or 190 mm.
    contacts : {"sliding", "stuck"}
        Sliding contacts keep sliding, or full stick.
    """
    modes = list(_modes(result, contacts))
    sheet = Sheet(width, *arranged(width, 2), panel_height=60)
    frequency, growth = sheet.panels
    for number, (_, rows, label) in enumerate(modes):
        rpm = abs(rows.speed_rad_per_s) * 30.0 / np.pi
        grows = rows.real_rad_per_s > 0
        _draw_mode(frequency, number, label, rpm, rows.imag_rad_per_s / (2.0 * np.pi), grows)
        _draw_mode(growth, number, label, rpm, rows.real_rad_per_s / abs(rows.speed_rad_per_s), grows)
    data = result.data
    every = np.abs(data["speed"]) * 30.0 / np.pi
    for ratio, name in ((1.0, "1×"), (0.5, "1/2×")):
        frequency.plot(every, ratio * every / 60.0, color="0.6", linewidth=0.6, zorder=0)
        frequency.annotate(name, (every[-1], ratio * every[-1] / 60.0), (2, 0), textcoords="offset points", color="0.4", va="center")
    by_coefficients = data["growth_by_coefficients" + ("_stuck" if contacts == "stuck" else "")]
    growth.plot(every, by_coefficients, color="0.4", linestyle=(0, (1, 1)), label="by synchronous coefficients")
    growth.axhline(0.0, color="0.6", linewidth=0.6, zorder=0)
    frequency.set_ylabel("damped frequency (Hz)")
    growth.set_ylabel("growth rate / speed of rotation")
    for ax in sheet.panels:
        ax.set_xlabel("speed (rpm)")
    frequency.set_ylim(bottom=0.0)
    sheet.entitle(["damped frequencies", "growth"])
    return sheet.finish(growth.get_legend_handles_labels()[0])


@styled
def root_locus(result: Result, *, width: str = "single", contacts: str = "sliding") -> Figure:
    """Rates of the free motions of a rotor on its bearings in the complex plane, from speed to speed.

    Marks are filled where a motion grows; the mark of the last speed is larger.

    Parameters
    ----------
    result : Result
        Of ``stability``.
    width : {"single", "double"}
        90 or 190 mm.
    contacts : {"sliding", "stuck"}
        Sliding contacts keep sliding, or full stick.
    """
    modes = list(_modes(result, contacts))
    sheet = Sheet(width, 1, 1, panel_height=60)
    (ax,) = sheet.panels
    for number, (_, rows, label) in enumerate(modes):
        real, frequency = rows.real_rad_per_s, rows.imag_rad_per_s / (2.0 * np.pi)
        _draw_mode(ax, number, label, real, frequency, real > 0)
        style = _style(number, marked=True)
        ax.plot(real.iloc[-1:], frequency.iloc[-1:], linestyle="none", marker=style["marker"], color=style["color"], markersize=6)
    ax.axvline(0.0, color="0.6", linewidth=0.6, zorder=0)
    ax.set_xlabel("growth rate (1/s)")
    ax.set_ylabel("damped frequency (Hz)")
    ax.set_ylim(bottom=0.0)
    return sheet.finish(None)


@styled
def run_up(result: Result, *, width: str = "double") -> Figure:
    """Torque over speed, the Stribeck curve, and the share of the load on asperities: of states with ``[asperity]``.

    A journal at rest needs no torque: the logarithmic axes begin at the slowest speed that turns.

    Parameters
    ----------
    result : Result
        Of ``equilibrium``.
    width : {"single", "double"}
        90 or 190 mm.
    """
    demand(result, "states on asperities")
    table = result.to_dataframe()
    table = table[table.speed_rad_per_s != 0.0]
    sheet = Sheet(width, *arranged(width, 2), panel_height=50)
    torque, share = sheet.panels
    for number, ((load_x, load_y), rows) in enumerate(table.groupby(["load_x_N", "load_y_N"], sort=False, dropna=False)):
        label = f"load ({load_x:g}, {load_y:g}) N".replace("-", "−")
        rpm = abs(rows.speed_rad_per_s) * 30.0 / np.pi
        torque.plot(rpm, 1e3 * abs(rows.torque_N_m), label=label, **_style(number, marked=True))
        share.plot(rpm, rows.asperity_share, label=label, **_style(number, marked=True))
    torque.set_yscale("log")
    torque.set_ylabel("torque (N mm)")
    share.set_ylabel("share of the load")
    for ax in sheet.panels:
        ax.set_xscale("log")
        ax.set_xlabel("speed (rpm)")
    sheet.entitle(["torque", "load on asperities"])
    return sheet.finish(None)
