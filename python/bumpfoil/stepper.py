"""Foils advanced from state to state, to couple them to your own film or rotor model."""

from __future__ import annotations

import warnings
from functools import cached_property
from typing import Any

from numpy.typing import NDArray

from . import _native, notebook
from .case import as_case
from .errors import CaseError, RunWarning
from .units import si_numbers


class State:
    """A state of the foils: immutable, can be stored and restored.

    Attributes
    ----------
    status : str
        ``converged``, or why the increment failed; then only the position is known.
    position : ndarray, (2,)
        Of the journal, m.
    force : ndarray, (2,)
        Applied force on the journal, N.
    elastic_energy, dissipated_energy, work : float
        Elastic energy of the foils, J; energy dissipated by friction, and work of the journal, since the assembly,
        including its dissipation.
    """

    def __init__(self, native: _native.ReachedState) -> None:
        self._native = native
        self.status: str = native.status
        self.position: NDArray[Any] = native.position
        self.force: NDArray[Any] = native.force
        self.elastic_energy: float = native.elastic_energy
        self.dissipated_energy: float = native.dissipated_energy
        self.work: float = native.work
        self.position.flags.writeable = self.force.flags.writeable = False

    @property
    def converged(self) -> bool:
        """Whether this is a state, not the end of a failed increment."""
        return self.status == "converged"

    @cached_property
    def fields(self) -> dict[str, NDArray[Any]]:
        """Displacements (m), gaps (m), forces (N), contact states and stresses (Pa), one per bump or foot, by the names
        of result.nc; read-only views without a copy."""
        return self._native.fields() if self.converged else {}

    def _repr_html_(self) -> str:
        rows = [["status", self.status], ["position (µm)", *(f"{1e6 * place:.4g}" for place in self.position)]]
        if self.converged:
            rows += [
                ["force (N)", *(f"{force:.4g}" for force in self.force)],
                ["elastic energy (mJ)", f"{1e3 * self.elastic_energy:.4g}"],
                ["dissipated energy (mJ)", f"{1e3 * self.dissipated_energy:.4g}"],
            ]
        return notebook.table(rows)

    def __repr__(self) -> str:
        x, y = self.position * 1e6
        if not self.converged:
            return f"<bumpfoil.State {self.status}>"
        return f"<bumpfoil.State at ({x:.4g}, {y:.4g}) um, held by ({self.force[0]:.4g}, {self.force[1]:.4g}) N>"


def _in_si(**given: Any) -> list[NDArray[Any] | None]:
    """Named arguments as numbers in m and N."""
    return [None if values is None else _vector(name, values) for name, values in given.items()]


def _vector(name: str, values: Any) -> NDArray[Any]:
    numbers = si_numbers(values, "m" if name == "position" else "N", name)
    if numbers.ndim != 1 or (name != "top_load" and len(numbers) != 2):
        due = "one for each bump" if name == "top_load" else "two, along X and Y"
        raise CaseError(f"{name}: is an array of the shape {numbers.shape}; give {due}")
    return numbers


class Stepper:
    """The foils of a bearing with their solver and current state.

    Parameters
    ----------
    case : Case, path, str or mapping
        What :class:`Case` takes.
    position : array_like, (2,)
        Of the journal at the assembly, m, or pint lengths: one step from the unstressed foils.
    top_load : array_like, (bumps,), optional
        Forces on the top foil over each crest at the assembly, N, positive outward.
    **tables : mapping
        Keys of the case to change.

    Attributes
    ----------
    state : State
        Current state: set it to restore a stored one.

    Several steppers share foils, see :meth:`copy`; each may be used in its own thread.

    Examples
    --------
    >>> stepper = Stepper("case.toml", position=(0, -40e-6))
    >>> before = stepper.state
    >>> stepper.advance(position=(1e-6, -40e-6)).force
    >>> stepper.state = before  # undo
    """

    def __init__(self, case: Any, /, position: Any = (0.0, 0.0), top_load: Any = None, **tables: Any) -> None:
        self._native = _native.BearingStepper(as_case(case, tables)._source)
        self.state = self._told(State(self._native.assemble(*_in_si(position=position, top_load=top_load))))

    def advance(self, *, position: Any = None, load: Any = None, top_load: Any = None) -> State:
        """One increment, straight from the current state.

        Parameters
        ----------
        position : array_like, (2,), optional
            Of the journal at its end, m.
        load : array_like, (2,), optional
            Applied to the journal at its end, N, free to move in the plane; instead of a position.
        top_load : array_like, (bumps,), optional
            Forces on the top foil over each crest at its end, N, positive outward, for example of a film; by default
            unchanged.

        Returns
        -------
        State
            The new state, which becomes `state`. If the increment fails, with a RunWarning, `state` does not change.

        Raises
        ------
        CaseError
            Both a position and a load are given, the load is zero, or the number of top loads is not that of bumps.
        """
        state = self._told(State(self._native.advance(self.state._native, *_in_si(position=position, load=load, top_load=top_load))))
        if state.converged:
            self.state = state
        return state

    def tangents(self) -> tuple[NDArray[Any] | None, NDArray[Any] | None]:
        """Tangent stiffness dF/d(x, y) of the state, N/m, (2, 2): with sliding contacts, and for full stick.

        None where the closed contacts leave a mechanism."""
        return self._native.tangents(self.state._native)

    def copy(self) -> Stepper:
        """An independent stepper in the same state."""
        other = Stepper.__new__(Stepper)
        other._native = _native.BearingStepper(self._native)
        other.state = self.state
        return other

    def __copy__(self) -> Stepper:
        return self.copy()

    def _told(self, state: State) -> State:
        if not state.converged:
            warnings.warn(f"the increment failed: {state._native.explanation}", RunWarning, stacklevel=3)
        return state

    def __repr__(self) -> str:
        return f"<bumpfoil.Stepper in {self.state!r}>"
