"""Sheets for figures in print: sizes in millimetres, panels with letters, one legend above them."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Widths of a column and of a page (mm), as journals of engineering have them.
WIDTHS = {"single": 90.0, "double": 190.0}

#: Type of 8 pt, which journals do not scale down as the sheet has its final width; fonts stay text in PDF.
STYLE: Mapping[str, Any] = {
    "axes.grid": False,
    "axes.labelsize": 8,
    "axes.linewidth": 0.6,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlesize": 8,
    "axes.unicode_minus": True,
    "font.family": "DejaVu Sans",
    "font.size": 8,
    "hatch.linewidth": 0.6,
    "legend.fontsize": 8,
    "lines.linewidth": 1.2,
    "lines.markersize": 3,
    "pdf.fonttype": 42,
    "svg.hashsalt": "bumpfoil",
    "xtick.labelsize": 7.5,
    "xtick.major.width": 0.6,
    "ytick.labelsize": 7.5,
    "ytick.major.width": 0.6,
}

_MM = 1 / 25.4  # inches
_LEGEND_ROW = 4.5  # mm
_LEFT, _BOTTOM, _TITLE, _RIGHT = 15.0, 10.0, 5.5, 3.0  # mm round a panel
_PAGE = 234.0 - 14.0  # mm, a page less a caption of three lines
_LOWEST = 15.0  # mm, of a panel in which anything can be read

_Drawn = TypeVar("_Drawn", bound=Callable[..., Any])


def styled(draw: _Drawn) -> _Drawn:
    """Whatever `draw` makes has the style of print, whatever the style of the session is."""

    @functools.wraps(draw)
    def drawn(*args: Any, **keywords: Any) -> Any:
        import matplotlib

        with matplotlib.rc_context(dict(STYLE)):
            return draw(*args, **keywords)

    return drawn  # type: ignore[return-value]


def arranged(width: str, panels: int) -> tuple[int, int]:
    """Columns and rows of panels."""
    columns = min(panels, 2 if width == "double" else 1)
    return columns, -(-panels // columns)


class Sheet:
    """Panels of one size, row by row; lower than wanted where they would not fit on a page."""

    def __init__(self, width: str, columns: int, rows: int, panel_height: float) -> None:
        from matplotlib.figure import Figure

        if width not in WIDTHS:
            raise ValueError(f"width is {width!r}; it is one of {', '.join(WIDTHS)}")
        self._width, self._columns, self._rows, self._panel_height = WIDTHS[width], columns, rows, panel_height
        self.figure: Figure = Figure()
        self.panels: list[Axes] = [self.figure.add_axes((0, 0, 1, 1), label=str(panel)) for panel in range(columns * rows)]
        self._arrange(0)

    def _arrange(self, legend: float) -> float:
        """Puts the panels below a legend of this height (mm). @return height of the sheet (mm)"""
        highest = (_PAGE - legend) / self._rows - _BOTTOM - _TITLE
        panel = min(self._panel_height, max(highest, _LOWEST))
        height = self._rows * (panel + _BOTTOM + _TITLE) + legend
        self.figure.set_size_inches(self._width * _MM, height * _MM)
        pitch = self._width / self._columns
        for number, ax in enumerate(self.panels):
            row, column = divmod(number, self._columns)
            bottom = (self._rows - 1 - row) * (panel + _BOTTOM + _TITLE) + _BOTTOM
            ax.set_position(((column * pitch + _LEFT) / self._width, bottom / height,
                             (pitch - _LEFT - _RIGHT) / self._width, panel / height))
        return height

    def entitle(self, titles: list[str]) -> None:
        """Letters, where there are several panels, and titles; panels beyond them are not shown."""
        for ax in self.panels[len(titles) :]:
            ax.remove()
        del self.panels[len(titles) :]
        for number, (ax, title) in enumerate(zip(self.panels, titles)):
            if len(titles) > 1:
                ax.annotate(
                    f"({chr(ord('a') + number)})",
                    (0, 1),
                    (-14 * _MM * 72, 3),
                    xycoords="axes fraction",
                    textcoords="offset points",
                    fontweight="bold",
                )
            ax.set_title(title, pad=3)

    def finish(self, handles: list[Any] | None = None) -> Figure:
        """With one legend above all panels, in as few rows as the width allows; of the first panel without `handles`."""
        shown = self.panels[0].get_legend_handles_labels()[0] if handles is None else handles
        if len(shown) > 1:
            for rows in range(1, len(shown) + 1):
                legend = self.figure.legend(
                    handles=shown, loc="upper center", ncol=-(-len(shown) // rows), frameon=False, borderpad=0, columnspacing=1.2,
                    handlelength=2.6,
                )
                if rows == len(shown) or legend.get_window_extent().width <= (self._width - 2) * _MM * self.figure.dpi:
                    break
                legend.remove()
            height = self._arrange(rows * _LEGEND_ROW + 1)
            legend.set_bbox_to_anchor((0.5, 1 - 1 / height), transform=self.figure.transFigure)
        return self.figure


@styled
def save(figure: Figure, path: str | os.PathLike[str]) -> list[Path]:
    """Writes a figure as PDF and SVG, in its size, the same bytes every time.

    Parameters
    ----------
    figure : matplotlib figure
    path : path
        Without its end: ``save(figure, "loops")`` writes ``loops.pdf`` and ``loops.svg``, over older ones.
    """
    base = Path(path)
    written = [base.with_name(base.name + end) for end in (".pdf", ".svg")]
    figure.savefig(written[0], metadata={"CreationDate": None})
    figure.savefig(written[1], metadata={"Date": None})
    return written
