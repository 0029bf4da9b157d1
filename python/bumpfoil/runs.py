"""The commands of the program."""

from __future__ import annotations

import inspect
import json
import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from . import _native
from .case import Case, as_case, toml_value
from .errors import CaseError
from .progress import Progress, shown
from .result import Result, netcdf, warn_of
from .units import si_numbers

_DOCUMENT = """{0}

Parameters
----------
case : Case, path, str or mapping
    What :class:`Case` takes.
{1}progress : bool or callable, optional
    Whether to show how far the run is: without it on a terminal and in a notebook, after a second. Or what is to be
    called with the fraction that is done, 0 to 1; returning False ends the run, whose result is partial then.
**tables : mapping
    Keys of the case that are changed: ``friction={{"coefficient": 0.2}}``.

Returns
-------
Result
    A numerical failure is no exception but a status of the result, and a RunWarning.

Raises
------
CaseError
    The case is wrong, or has not the table that says what is to be run.
KeyboardInterrupt
    Ctrl-C was pressed.
"""

_Running = TypeVar("_Running", bound=Callable[..., Result])


def _documented(parameters: str = "") -> Callable[[_Running], _Running]:
    """Puts what all runs take and give behind the first words of one, with its own `parameters` among them."""

    def document(function: _Running) -> _Running:
        words, own = inspect.cleandoc(function.__doc__ or ""), inspect.cleandoc(parameters)
        function.__doc__ = _DOCUMENT.format(words, f"{own}\n" if own else "")
        return function

    return document


def _run(
    command: str, case: Any, progress: Progress, tables: dict[str, Any], switches: Sequence[str] = ()
) -> Result:
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.run(command, source, list(switches), called)
    return Result._of_run(run)


def check(case: Any = None, /, **tables: Any) -> Case:
    """Reads and checks a case.

    Parameters
    ----------
    case : Case, path, str or mapping, optional
        What :class:`Case` takes.
    **tables : mapping
        Keys of the case that are changed: ``friction={"coefficient": 0.2}``.

    Returns
    -------
    Case

    Raises
    ------
    CaseError
        With every fault, its place, the value met, what to change.
    """
    checked = as_case(case, tables)
    checked._source.check()
    return checked


def properties(case: Any, /, **tables: Any) -> dict[str, Any]:
    """Truss constants, single-bump stiffnesses, softest and stiffest modes: what ``bumpfoil properties --json`` prints.

    Parameters
    ----------
    case : Case, path, str or mapping
        What :class:`Case` takes.
    **tables : mapping
        Keys of the case that are changed: ``friction={"coefficient": 0.2}``.

    Returns
    -------
    dict
        Units are at the ends of the keys; None is what is not known.

    Raises
    ------
    CaseError
        The case is wrong.
    """
    found: dict[str, Any] = json.loads(as_case(case, tables)._source.properties())
    return found


@_documented()
def run_cycle(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Pushes the journal in each direction of [cycle] and pulls it back."""
    return _run("cycle", case, progress, tables)


@_documented()
def run_strip(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Compresses a flat strip of the foils between two plates, as [strip] says."""
    return _run("strip", case, progress, tables)


@_documented(
    """
    positions : array_like, (points, 2), optional
        The path in place of that of [path]: where the journal goes, m, or lengths of pint. The first increment is the assembly
        at the centre of the bearing.
    loads : array_like, (points, 2), optional
        The path as loads that the journal carries, N, or forces of pint; in place of positions.
    """
)
def run_path(
    case: Any, /, positions: Any = None, loads: Any = None, *, progress: Progress = None, **tables: Any
) -> Result:
    """Takes the journal along the path of [path], or along one of NumPy."""
    if positions is not None and loads is not None:
        raise CaseError("run_path: both positions and loads are given; give one of them")
    for name, unit, values in (("positions", "m", positions), ("loads", "N", loads)):
        if values is not None:
            points = si_numbers(values, unit, name)
            if points.ndim != 2:
                raise CaseError(f"{name}: has the shape {points.shape}; give an array of the shape (points, 2)")
            texts = [[f"{number!r} {unit}" for number in point] for point in points.tolist()]
            tables["path"] = {**tables.get("path", {}), "points": texts}
    return _run("path", case, progress, tables)


@_documented()
def run_vibration(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Lets the journal vibrate about static loads, as [vibration] says: stiffness, damping and loss factor."""
    return _run("vibration", case, progress, tables)


@_documented(
    """
    all_paths : bool
        Whether every state is come to by every path that leads there: ``summary["spreads"]`` tells how far they lie apart.
    limits : bool
        Whether lift-off speeds and load capacities are found, too, where the film is film.h_lift_off thin:
        ``summary["limits"]``.
    """
)
def run_equilibrium(
    case: Any, /, *, all_paths: bool = False, limits: bool = False, progress: Progress = None, **tables: Any
) -> Result:
    """Finds where the journal of a running bearing is, with gas film, foils and friction, as [equilibrium] says."""
    switches = [name for name, on in (("paths", all_paths), ("limits", limits)) if on]
    return _run("equilibrium", case, progress, tables, switches)


@_documented(
    """
    over : mapping
        Values by their dotted keys: ``{"friction.coefficient": numpy.linspace(0, 0.5, 11)}``, quantities of pint, or a range as
        the program takes it, ``"60 um:90 um:10 um"`` (its end included). Of ``equilibrium.speeds`` each point has one.
    command : str
        ``cycle``, ``strip``, ``vibration`` or ``equilibrium``.
    threads : int, optional
        On which points are run; all cores without.
    limits : bool
        Of ``equilibrium``: whether lift-off speeds and load capacities are found, too, where the film is film.h_lift_off thin.
    """
)
def run_sweep(
    case: Any,
    /,
    over: Mapping[str, Any],
    *,
    command: str = "cycle",
    threads: int | None = None,
    limits: bool = False,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Runs a command for every combination of the values of some keys, on all cores.

    What is kept of every point are its quantities and loops, see :meth:`Result.to_xarray`."""
    if command not in _native.swept_commands():
        raise ValueError(f"{command!r} is not swept; give one of {', '.join(_native.swept_commands())}")
    swept = [f"{key}={values if isinstance(values, str) else toml_value(values)}" for key, values in over.items()]
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.sweep(source, command, swept, threads, limits, called)
    return Result._of_run(run)


@_documented(
    """
    folder : path, optional
        Where samples are kept as they come, and the result is written; without it the result is in memory alone.
    samples, seed : int, optional
        Number of bearings and seed of the random numbers, in place of those of the case. Samples depend on their number and the
        seed alone.
    threads : int, optional
        On which samples are run; all cores without.
    target_error : float, optional
        Ends the run when the standard error of the mean of the maximum force is below that part of it.
    limits : sequence of str
        What a bearing is to keep, with units: ``"clearance_5N > 20 um"``.
    resume : bool
        Whether to go on where a run in the folder was interrupted.
    force : bool
        Whether to begin anew in a folder that holds results.
    """
)
def run_montecarlo(
    case: Any,
    /,
    folder: str | os.PathLike[str] | None = None,
    *,
    samples: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    target_error: float | None = None,
    limits: Sequence[str] = (),
    resume: bool = False,
    force: bool = False,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Runs the cycles of many bearings that differ within the tolerances of [montecarlo], or their states on the film
    (``montecarlo={"command": "equilibrium", ...}``).

    What is kept of every sample are its quantities, see :meth:`Result.to_xarray`, :meth:`Result.to_dataframe` and
    ``summary["statistics"]``."""
    if folder is None:
        with tempfile.TemporaryDirectory(prefix="bumpfoil-") as temporary:
            return run_montecarlo(
                case, temporary, samples=samples, seed=seed, threads=threads, target_error=target_error, limits=limits,
                progress=progress, **tables,
            )  # fmt: skip
    given = {key: value for key, value in (("samples", samples), ("seed", seed)) if value is not None}
    tables["montecarlo"] = {**tables.get("montecarlo", {}), **given}
    source = as_case(case, tables)._source
    ensemble = _native.FolderEnsemble(source, os.fspath(folder), threads, target_error, list(limits), resume, force)
    try:
        with shown(progress) as called:
            ensemble.run(called)
    finally:  # what there is by then, also after Ctrl-C
        with netcdf:
            status, failures = ensemble.publish()
    warn_of(status, failures)
    return Result.load(folder)
