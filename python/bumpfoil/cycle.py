"""Cycles: the hysteresis loop of one direction, increment by increment."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import notebook, plots

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Cycle:
    """A cycle of the journal in one direction, one of a strip, or a path.

    Names are those of result.nc, docs/results.md: as attributes, ``cycle.loop_energy``, or in the
    dictionaries below. SI; directions in degrees. Arrays are read-only.

    Attributes
    ----------
    quantities : dict
        Of the whole cycle: ``max_force`` (N), ``loop_energy`` (J), ``loss_factor``, ``status`` (a word), ...; loads at
        full displacement, ``bump_loads`` (N, one per bump), of several pads ``pad_forces_x`` (N, one per pad), of a path
        ``max_pad_forces``, ... Missing values are NaN or None.
    series : dict of ndarray, (increments,)
        ``displacement`` (m), ``force_direct`` (N), ``dissipated_energy`` (J), ...
    fields : dict of ndarray, (increments, bumps, feet or pads)
        ``crest_v`` (m), ``normal_force_top_bump`` (N), ``state_bump_sleeve`` (0 open, 1 stick, 2 slip_forward,
        3 slip_backward), ... In a run, views of its result without a copy. Rows are the solved increments.
    events : dict of ndarray, (events,)
        Changes of contact states; only with the solver ``events``.
    """

    def __init__(
        self,
        quantities: dict[str, Any],
        series: dict[str, NDArray[Any]],
        fields: dict[str, NDArray[Any]],
        events: dict[str, NDArray[Any]],
        pads: Callable[[], dict[str, NDArray[Any]]] = dict,
    ) -> None:
        self.quantities = quantities
        self.series = series
        self.fields = fields
        self.events = events
        self._find_pads = pads

    def _places(self) -> tuple[Mapping[str, Any], ...]:
        return self.quantities, self.series, self.fields

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_") and name not in ("quantities", "series", "fields", "events"):
            for place in self._places():
                if name in place:
                    return place[name]
        raise AttributeError(f"a cycle has no {name!r}; dir(cycle) lists those it has")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for place in self._places() for name in place)]

    @property
    def name(self) -> str:
        """Its name among the cycles of a result, such as "+X", "37.5 deg", "cycle 2", "path"."""
        if "direction" in self.quantities:
            degrees = self.quantities["direction"]
            return {0.0: "+X", 90.0: "+Y", 180.0: "-X", 270.0: "-Y"}.get(degrees, f"{degrees:g} deg")
        return f"cycle {self.quantities['cycle']}" if "cycle" in self.quantities else "path"

    @cached_property
    def _pads(self) -> dict[str, NDArray[Any]]:
        return self._find_pads() if "pad_force_x" in self.fields else {}

    @property
    def bump_pad(self) -> NDArray[Any]:
        """The pad of each bump, (bumps,): 1 for the first, and for a single foil."""
        return self._pads.get("bump_pad", np.ones(self.fields["crest_v"].shape[1], dtype=int))

    @property
    def foot_pad(self) -> NDArray[Any]:
        """The pad of each foot, (feet,)."""
        return self._pads.get("foot_pad", np.ones(self.fields["foot_u"].shape[1], dtype=int))

    def plot_contacts(self, interface: str = "bump_sleeve", *, ax: Axes | None = None) -> Axes:
        """Plots which contacts are open, stick or slip, increment by increment.

        Parameters
        ----------
        interface : str
            ``journal_top``, ``top_bump`` or ``bump_sleeve``.
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.contacts(self, interface, ax)

    def plot_foils(self, increment: int | None = None, *, ax: Axes | None = None) -> Axes:
        """Plots the radial displacements of top foil and crests at an increment.

        Parameters
        ----------
        increment : int, optional
            Default: that of the largest displacement.
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.foils(self, increment, ax)

    def _repr_html_(self) -> str:
        return notebook.of_cycles([self])

    def __repr__(self) -> str:
        return f"<bumpfoil.Cycle {self.name}: {len(self.series['displacement'])} increments, {self.status}>"
