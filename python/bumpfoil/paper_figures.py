"""The figures of the source paper, drawn from the tables that ``bumpfoil reproduce`` writes."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import FileError
from .figure_sheet import Sheet, arranged, styled
from .plots import _style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    import pandas

_DIRECTIONS = {0: "+X", 180: "−X", 90: "+Y", 270: "−Y"}
_BLUE, _RED, _GREEN, _BLACK = ("#0072B2", "#D55E00", "#009E73", "#000000")


@styled
def paper(folder: str | os.PathLike[str], *, width: str = "double") -> Figure:
    """A figure of the source paper, from a folder of ``bumpfoil reproduce``: ``paper/figure10``, ... 16.

    Parameters
    ----------
    folder : path
        Of one study.
    width : {"single", "double"}
        90 or 190 mm. Figures 10, 11 and 15 fit in one column, 11 with and without friction in the same panels.

    Raises
    ------
    FileError
        The folder does not contain a study of a figure.
    ValueError
        The figure does not fit in one column.
    """
    place = Path(folder)
    with _of_a_study(place):
        study = json.loads((place / "study.json").read_text(encoding="utf-8"))["study"]
        draw = _FIGURES[study]
    if width == "single" and study not in _NARROW:
        raise ValueError(f"{study} has more panels than fit in one column; it is drawn with width=\"double\"")
    return draw(place, width)


@contextlib.contextmanager
def _of_a_study(folder: Path) -> Iterator[None]:
    try:
        yield
    except (OSError, ValueError, KeyError) as error:
        raise FileError(f"{folder}: contains no figure of `bumpfoil reproduce`: {error}") from None


def _table(folder: Path, name: str) -> pandas.DataFrame:
    import pandas

    with _of_a_study(folder):
        return pandas.read_csv(folder / f"{name}.csv")


def _of(table: pandas.DataFrame, run: str, direction: int = 0) -> pandas.DataFrame:
    return table[(table.run == run) & (table.direction_deg.round() == direction)]


def _loop(ax: Axes, rows: pandas.DataFrame, name: str, colour: str, *, sign: int = 1, **style: Any) -> None:
    """Loading solid, unloading dashed from the turning point on."""
    displacement, force = sign * 1e6 * rows.displacement_m.to_numpy(), sign * rows.force_direct_N.to_numpy()
    turning = int(np.argmax(rows.displacement_m.to_numpy()))
    ax.plot(displacement[: turning + 1], force[: turning + 1], color=colour, label=f"{name}, loading", **style)
    ax.plot(displacement[turning:], force[turning:], color=colour, linestyle=(0, (4, 2)), label=f"{name}, unloading",
            **style)


def _marks(ax: Axes, rows: pandas.DataFrame, label: str, colour: str, marker: str, *, start: int = 0, sign: int = 1,
           filled: bool = True) -> None:
    every = rows.iloc[start::5]
    ax.plot(sign * 1e6 * every.displacement_m, sign * every.force_direct_N, linestyle="none", marker=marker,
            color=colour, markerfacecolor=colour if filled else "white", label=label)


def _figure10(folder: Path, width: str) -> Figure:
    table = _table(folder, "loops")
    sheet = Sheet(width, *arranged(width, 4), panel_height=48 if width == "double" else 36)
    titles = []
    for panel, ax in enumerate(sheet.panels):
        axis, friction = "XY"[panel // 2], ("friction", "frictionless")[panel % 2]
        titles.append(f"{axis}, {'friction 0.1' if panel % 2 == 0 else 'no friction'}")
        ax.axhline(0, color="black", linewidth=0.4)
        for sign, direction in ((1, 90 * (panel // 2)), (-1, 90 * (panel // 2) + 180)):
            _loop(ax, _of(table, f"present-{friction}", direction), "this model", _BLUE, sign=sign)
            former = _of(table, f"former-{friction}", direction)
            _marks(ax, former[former.branch == "loading"], "Le Lez (2007), loading", _RED, "o", sign=sign)
        ax.set(xlim=(-82, 82), ylim=(-900, 900))
        ax.set_xlabel(f"displacement along {axis} (µm)")
        ax.set_ylabel("direct force (N)")
    sheet.entitle(titles)
    return sheet.finish(sheet.panels[0].get_legend_handles_labels()[0][:3])


def _figure11(folder: Path, width: str) -> Figure:
    table = _table(folder, "loads")
    together = width == "single"
    frictions = {"friction": "friction 0.1", "frictionless": "no friction"}
    shown = [(direction, list(frictions) if together else [one]) for direction in _DIRECTIONS for one in frictions]
    shown = shown[::2] if together else shown
    sheet = Sheet(width, *arranged(width, len(shown)), panel_height=36)
    for ax, (direction, both) in zip(sheet.panels, shown):
        for number, friction in enumerate(both):
            for former, model in enumerate(("present", "former")):
                rows = _of(table, f"{model}-{friction}", direction)
                style = _style(2 * number + former, marked=True)
                if former:
                    style["markerfacecolor"] = "white"
                label = f"{model} model, {frictions[friction]}" if together else f"{model} model"
                ax.plot(rows.bump, rows.bump_load_N, label=label, **style)
        most = table.bump_load_N.max()
        ax.set(xlim=(0.3, table.bump.max() + 0.7), ylim=(-0.04 * most, 1.05 * most))
        ax.set_xlabel("bump, counted from the weld")
        ax.set_ylabel("bump load (N)")
    sheet.entitle([_DIRECTIONS[direction] + ("" if together else f", {frictions[both[0]]}") for direction, both in shown])
    return sheet.finish()


def _figure12(folder: Path, width: str) -> Figure:
    table, elements = _table(folder, "loops"), _table(folder, "finite_elements")
    sheet = Sheet(width, 2, 4, panel_height=40)
    titles = []
    for panel, ax in enumerate(sheet.panels):
        direction, behind = list(_DIRECTIONS)[panel // 2], ("", "-midsurface")[panel % 2]
        titles.append(f"{_DIRECTIONS[direction]}, {'rise of the mid-surface' if behind else 'height'} 0.508 mm")
        _loop(ax, _of(table, f"truss{behind}", direction), "truss", _BLUE)
        others = [("frame", _of(table, f"frame{behind}", direction), _RED, "o", 0)]
        others.append(("finite elements", _of(elements, "finite-elements", direction), _BLACK, "s", 2) if behind else
                      ("nonlinear frame", _of(table, "frame-nonlinear", direction), _GREEN, "^", 2))
        for name, rows, colour, marker, start in others:
            for branch, filled in (("loading", True), ("unloading", False)):
                _marks(ax, rows[rows.branch == branch], f"{name}, {branch}", colour, marker, start=start, filled=filled)
        ax.set(xlim=(22, 82), ylim=(-30, 1100))
        ax.set_xlabel("displacement (µm)")
        ax.set_ylabel("direct force (N)")
    sheet.entitle(titles)
    handles, labels = sheet.panels[0].get_legend_handles_labels()
    return sheet.finish([*handles, *sheet.panels[1].get_legend_handles_labels()[0][4:]])


def _bearings(folder: Path, width: str) -> Figure:
    """Figures 13 and 14: six bearings, the loop of each above its heights."""
    loops, heights = _table(folder, "loops"), _table(folder, "heights")
    runs = [run for run in loops.run.unique() if run != "perfect"]
    sheet = Sheet(width, 3, 4, panel_height=38)
    titles = []
    for row in range(4):
        for column in range(3):
            ax, number = sheet.panels[3 * row + column], 3 * (row // 2) + column
            titles.append(f"bearing {number + 1}")
            if row % 2 == 0:
                _loop(ax, _of(loops, "perfect"), "no height errors", "#8C8C8C", linewidth=0.9)
                _loop(ax, _of(loops, runs[number]), "with height errors", _BLUE)
                ax.set(xlim=(0, 82), ylim=(-30, 1.05 * loops.force_direct_N.max()))
                ax.set_xlabel("displacement to +X (µm)")
                ax.set_ylabel("direct force (N)")
            else:
                rows, low = _of(heights, runs[number]), 440
                ax.bar(rows.bump, 1e6 * rows.height_m - low, bottom=low, width=0.8, color="#D4D4D4", edgecolor="black",
                       linewidth=0.4, label="bumps")
                ax.plot(rows.bump, 1e6 * rows.journal_centred_m, color=_RED, linestyle=":", label="journal, centred")
                ax.plot(rows.bump, 1e6 * rows.journal_pushed_m, color=_RED, label="journal, pushed")
                ax.axhline(1e6 * _of(heights, "perfect").height_m.iloc[0], color="black", linestyle="--", linewidth=0.8,
                           label="design")
                ax.set(xlim=(0.3, rows.bump.max() + 0.7), ylim=(low, 630))
                ax.set_xlabel("bump, counted from the weld")
                ax.set_ylabel("height (µm)")
    sheet.entitle(titles)
    return sheet.finish([handle for ax in (sheet.panels[0], sheet.panels[3]) for handle in ax.get_legend_handles_labels()[0]])


def _figure15(folder: Path, width: str) -> Figure:
    table = _table(folder, "quantities")
    sheet = Sheet(width, *arranged(width, 2), panel_height=45)
    scatters = ("10", "20")
    for ax, scatter in zip(sheet.panels, scatters):
        rows = table[table.run.str.startswith(f"scatter{scatter}-")]
        bearings = np.arange(1, len(rows) + 1)
        design = 1e6 * 31.8e-6
        ax.axhline(design, color="black", linestyle=":", label="design, 31.8 µm")
        ax.plot(bearings, 1e6 * rows.clearance_5N_m, "o", color=_BLUE, markersize=5, label="at 5 N")
        ax.plot(bearings, 1e6 * rows.clearance_10N_m, "s", color=_RED, markerfacecolor="none", markersize=6, label="at 10 N")
        ax.set(xlim=(0.5, len(rows) + 0.5), ylim=(-3, 50), xticks=bearings)
        ax.set_xlabel("bearing")
        ax.set_ylabel("clearance to +X (µm)")
    sheet.entitle([f"heights scattered by {scatter} µm" for scatter in scatters])
    return sheet.finish()


def _figure16(folder: Path, width: str) -> Figure:
    table = _table(folder, "foils")
    sheet = Sheet(width, 2, 5, panel_height=29)
    increments, titles = (0, 25, 50, 75, 100), []
    from matplotlib.lines import Line2D

    marks = {"stick": ("o", "stick"), "slip_forward": ("^", "slip to the free end"), "slip_backward": ("v", "slip to the weld")}
    gaps = (("journal_top", "journal/top foil", _RED, "s"), ("top_bump", "top foil/bump", _BLUE, "o"),
            ("bump_sleeve", "bump/sleeve", _GREEN, "^"))
    for row, increment in enumerate(increments):
        rows = table[table.increment == increment]
        ax, beside = sheet.panels[2 * row : 2 * row + 2]
        place = f"journal at {1e6 * rows.displacement_m.iloc[0]:.3g} µm to +X"
        titles += [place, f"{place}: gaps and contacts"]
        ax.bar(rows.bump, 1e6 * rows.crest_height_m - 440, bottom=440, width=0.8, color="#D4D4D4", edgecolor="black",
               linewidth=0.4, label="crests")
        ax.plot(rows.bump, 1e6 * rows.top_foil_height_m, color=_BLUE, marker=".", label="top foil")
        ax.plot(rows.bump, 1e6 * rows.journal_height_m, color=_RED, linestyle="--", label="journal")
        ax.set(ylim=(440, 630))
        ax.set_ylabel("height (µm)")
        for level, (name, words, colour, marker) in zip((-17, -33, -49), gaps):
            beside.plot(rows.bump, 1e6 * rows[f"gap_{name}_m"], color=colour, marker=marker, markerfacecolor="white",
                        linewidth=0.8, label=f"gap, {words}")
            for state, (mark, _) in marks.items():
                closed = rows[rows[f"state_{name}"] == state]
                beside.plot(closed.bump, np.full(len(closed), level), linestyle="none", marker=mark, color="black")
        beside.axhline(-8, color="black", linewidth=0.4)
        beside.set(ylim=(-58, 105), yticks=[-49, -33, -17, 0, 25, 50, 75, 100])
        beside.set_yticklabels(["sleeve", "bump", "journal", "0", "25", "50", "75", "100"])
        beside.set_ylabel("gap (µm)", y=0.7, labelpad=-9)
        for one in (ax, beside):
            one.set(xlim=(0.3, rows.bump.max() + 0.7))
            one.set_xlabel("bump, counted from the weld")
    sheet.entitle(titles)
    symbols = [Line2D([], [], linestyle="none", marker=mark, color="black", label=words) for mark, words in marks.values()]
    return sheet.finish([*sheet.panels[0].get_legend_handles_labels()[0], *sheet.panels[1].get_legend_handles_labels()[0],
                         *symbols])


_FIGURES = {
    "figure10": _figure10,
    "figure11": _figure11,
    "figure12": _figure12,
    "figure13": _bearings,
    "figure14": _bearings,
    "figure15": _figure15,
    "figure16": _figure16,
}

#: Those that fit in one column.
_NARROW = ("figure10", "figure11", "figure15")
