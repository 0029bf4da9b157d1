"""A running bearing advanced in time, to couple it to your own rotor."""

from __future__ import annotations

import warnings
from functools import cached_property
from typing import Any

from numpy.typing import NDArray

from . import _native
from .case import as_case
from .errors import RunWarning
from .stepper import _in_si


class Instant:
    """A state of a running bearing: immutable, can be stored and restored.

    Attributes
    ----------
    status : str
        ``converged``, or why the step failed; then all else is that of the state before it.
    time : float
        Since the start, s.
    speed : float
        Of the journal, rad/s, positive from X to Y.
    position : ndarray, (2,)
        Of the journal, m.
    force : ndarray, (2,)
        Applied force on the journal, which balances film and asperities, N.
    film_thickness : float
        Minimum film thickness, m.
    power : float
        Power loss, W.
    """

    def __init__(self, native: _native.ReachedInstant, stepper: _native.RunningStepper) -> None:
        self._native = native
        self._stepper = stepper
        self.status: str = native.status
        self.time: float = native.time
        self.speed: float = native.speed
        self.position: NDArray[Any] = native.position
        self.force: NDArray[Any] = native.force
        self.power: float = native.power
        self.film_thickness: float = stepper.thinnest_film(native)
        self.position.flags.writeable = self.force.flags.writeable = False

    @property
    def converged(self) -> bool:
        """Whether the step that led here was found."""
        return self.status == "converged"

    @cached_property
    def fields(self) -> dict[str, NDArray[Any]]:
        """``pressure`` (Pa) and ``film_thickness`` (m) over rows and columns of the mesh, ``bump_load`` (N) of each bump."""
        return self._stepper.fields(self._native)

    def __repr__(self) -> str:
        x, y = self.position * 1e6
        return (
            f"<bumpfoil.Instant {self.status} at {1e3 * self.time:.4g} ms: journal at ({x:.4g}, {y:.4g}) um, "
            f"held by ({self.force[0]:.4g}, {self.force[1]:.4g}) N>"
        )


class RunningStepper:
    """A running bearing with gas film, foils, contacts and friction, advanced in time while you prescribe its journal.

    The steps are those of ``bumpfoil transient``: BDF2, of second order also with steps of different lengths, with the
    contacts solved exactly at the end of each. Neither journal nor foils have mass: that of the rotor is yours.

    Parameters
    ----------
    case : Case, path, str or mapping
        What :class:`Case` takes.
    speed : float
        Of the journal at the beginning, rad/s.
    position, load : array_like, (2,)
        Of the journal in the equilibrium from which the bearing starts, m, or the load that it carries there, N: one of
        them. The equilibrium is found along the path of ``[equilibrium]``.
    **tables : mapping
        Keys of the case to change.

    Attributes
    ----------
    state : Instant
        Current state: set it to restore a stored one, for example to take a step again with another position.

    Examples
    --------
    >>> bearing = RunningStepper("case.toml", speed=-2000.0, load=(0, -10))
    >>> bearing.advance(30e-6, position=bearing.state.position + [1e-7, 0]).force
    """

    def __init__(self, case: Any, /, *, speed: float, position: Any = None, load: Any = None, **tables: Any) -> None:
        self._native = _native.RunningStepper(as_case(case, tables)._source)
        self.state = self._told(self._native.begin(speed, *_in_si(position=position, load=load)))

    def advance(self, dt: float, *, position: Any = None, load: Any = None, speed: float | None = None) -> Instant:
        """One step in time, from the current state.

        Parameters
        ----------
        dt : float
            Length of the step, s.
        position, load : array_like, (2,)
            Of the journal at the end of the step, m, or the load that it carries there, N: one of them.
        speed : float, optional
            At the end of the step, rad/s; by default that of the state.

        Returns
        -------
        Instant
            The new state, which becomes `state`. If the step fails, with a RunWarning, `state` does not change.

        Raises
        ------
        CaseError
            Neither or both of position and load are given, or something is not finite.
        """
        held = _in_si(position=position, load=load)
        speed = self.state.speed if speed is None else speed
        state = self._told(self._native.advance(self.state._native, dt, speed, *held))
        if state.converged:
            self.state = state
        return state

    def tangent(self) -> NDArray[Any] | None:
        """Derivative of the force by the position at the end of the last step, N/m, (2, 2): what Newton's method for your
        rotor needs. Contacts keep their modes. Of the equilibrium at the beginning its stiffness; None where the closed
        contacts leave a mechanism."""
        return self._native.tangent(self.state._native)

    def copy(self) -> RunningStepper:
        """An independent stepper in the same state."""
        other = RunningStepper.__new__(RunningStepper)
        other._native = _native.RunningStepper(self._native)
        other.state = self.state
        return other

    def __copy__(self) -> RunningStepper:
        return self.copy()

    def _told(self, native: _native.ReachedInstant) -> Instant:
        state = Instant(native, self._native)
        if not state.converged:
            warnings.warn(f"the step failed: {native.explanation}", RunWarning, stacklevel=3)
        return state

    def __repr__(self) -> str:
        return f"<bumpfoil.RunningStepper in {self.state!r}>"
