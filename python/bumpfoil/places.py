"""Bumps and feet side by side on an axis, pad after pad."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MOST_TICKS = 8


def pads_of(variables: Mapping[str, Any]) -> dict[str, NDArray[Any]]:
    """The pad of each bump and foot, 1 for the first, from the variables of a result.nc with several pads."""
    pads = {name: np.asarray(variables[name][...], dtype=int) for name in ("bump_pad", "foot_pad") if name in variables}
    for numbers in pads.values():
        numbers.flags.writeable = False
    return pads


class Places:
    """Where bumps or feet lie on an axis: at 1, 2, ..., with some room from pad to pad.

    Parameters
    ----------
    pads : ndarray, (places,)
        The pad of each.
    kind : str
        What they are: "bump" or "foot".
    room : int
        Between pads, in places.
    """

    def __init__(self, pads: NDArray[Any], kind: str = "bump", room: int = 1) -> None:
        self._pads, self._kind, self._room = pads, kind, room
        self._starts = np.flatnonzero(np.diff(pads, prepend=pads[:1])).tolist()  # of all pads but the first
        self.at: NDArray[Any] = 1.0 + np.arange(len(pads)) + room * np.searchsorted(self._starts, np.arange(len(pads)), "right")

    def line(self, values: Any) -> tuple[NDArray[Any], NDArray[Any]]:
        """Abscissa and ordinate of a line that is broken between pads."""
        numbers: NDArray[Any] = np.asarray(values, dtype=float)
        return np.insert(self.at, self._starts, np.nan), np.insert(numbers, self._starts, np.nan)

    def mark(self, ax: Axes) -> None:
        """Labels the axis: with several pads ticks such as 2.3, the third bump of pad 2, and lines between them."""
        if not self._starts:
            ax.set_xlabel(f"{self._kind}, counted from the weld")
            return
        step = -(-len(self._pads) // _MOST_TICKS)
        places, names = [], []
        for first, end in zip([0, *self._starts], [*self._starts, len(self._pads)]):
            shown = [first, *range(first + step, end - step + self._room + 1, step)]
            places += self.at[shown].tolist()
            names += [f"{self._pads[first]}.{place - first + 1}" for place in shown]
        ax.set_xticks(places, names)
        ax.set_xlabel(f"pad.{self._kind}, counted from the weld")
        for start in self._starts:
            ax.axvline(0.5 * (self.at[start - 1] + self.at[start]), color="black", linewidth=0.6)
