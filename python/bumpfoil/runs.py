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
    Whether to show the progress; by default on a terminal and in a notebook, after a second. Or a function of the
    completed fraction, 0 to 1; if it returns False the run stops, and its result is partial.
**tables : mapping
    Keys of the case to change: ``friction={{"coefficient": 0.2}}``.

Returns
-------
Result
    A numerical failure raises no exception: it is a status of the result, and a RunWarning.

Raises
------
CaseError
    The case is invalid, or lacks the table of the command.
KeyboardInterrupt
    Ctrl-C was pressed.
"""

_Running = TypeVar("_Running", bound=Callable[..., Result])


def _documented(parameters: str = "") -> Callable[[_Running], _Running]:
    """Appends the common parameters and results to the summary of a run, with its own `parameters` among them."""

    def document(function: _Running) -> _Running:
        words, own = inspect.cleandoc(function.__doc__ or ""), inspect.cleandoc(parameters)
        function.__doc__ = _DOCUMENT.format(words, f"{own}\n" if own else "")
        return function

    return document


def _run(command: str, case: Any, progress: Progress, tables: dict[str, Any]) -> Result:
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.run(command, source, called)
    return Result._of_run(run)


def check(case: Any = None, /, **tables: Any) -> Case:
    """Reads and validates a case.

    Parameters
    ----------
    case : Case, path, str or mapping, optional
        What :class:`Case` takes.
    **tables : mapping
        Keys of the case to change: ``friction={"coefficient": 0.2}``.

    Returns
    -------
    Case

    Raises
    ------
    CaseError
        With every error, its place, the value found, what to change.
    """
    checked = as_case(case, tables)
    checked._source.check()
    return checked


def properties(case: Any, /, **tables: Any) -> dict[str, Any]:
    """Truss constants, single-bump stiffnesses, softest and stiffest modes, as ``bumpfoil properties``.

    Parameters
    ----------
    case : Case, path, str or mapping
        What :class:`Case` takes.
    **tables : mapping
        Keys of the case to change: ``friction={"coefficient": 0.2}``.

    Returns
    -------
    dict
        Keys end with their unit; missing values are None.

    Raises
    ------
    CaseError
        The case is invalid.
    """
    found: dict[str, Any] = json.loads(as_case(case, tables)._source.properties())
    return found


@_documented(
    """
    command : str
        The experiment, by the name of its command: ``cycle``, ``film``, ...
    """
)
def run(command: str, case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Runs an experiment by its name, as the command of that name does."""
    if command not in _native.experiments():
        raise ValueError(f"there is no experiment {command!r}; use one of {', '.join(_native.experiments())}")
    return _run(command, case, progress, tables)


@_documented()
def run_cycle(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Pushes the journal in each direction of [cycle] and pulls it back."""
    return _run("cycle", case, progress, tables)


@_documented()
def run_strip(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Compresses a flat strip of the foils between two plates, as specified in [strip]."""
    return _run("strip", case, progress, tables)


@_documented(
    """
    positions : array_like, (points, 2), optional
        The path instead of that of [path]: journal positions, m, or pint lengths. The first increment is the assembly
        at the centre of the bearing.
    loads : array_like, (points, 2), optional
        The path as loads on the journal, N, or pint forces; instead of positions.
    """
)
def run_path(
    case: Any, /, positions: Any = None, loads: Any = None, *, progress: Progress = None, **tables: Any
) -> Result:
    """Moves the journal along a prescribed path: that of [path], or a NumPy array."""
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
    """Vibrates the journal about static loads, as specified in [vibration]: stiffness, damping and loss factor."""
    return _run("vibration", case, progress, tables)


@_documented(
    """
    all_paths : bool
        Whether to compute every state by every path that leads there: ``summary["spreads"]`` reports the spread.
    limits : bool
        Whether to also compute lift-off speeds and load capacities, at a film thickness of film.h_lift_off:
        ``summary["limits"]``.
    """
)
def run_equilibrium(
    case: Any, /, *, all_paths: bool = False, limits: bool = False, progress: Progress = None, **tables: Any
) -> Result:
    """Computes equilibria of the running bearing, with gas film, foils and friction, as specified in [equilibrium]."""
    keys: dict[str, Any] = {**({"paths": "all"} if all_paths else {}), **({"limits": True} if limits else {})}
    if keys:
        tables["equilibrium"] = {**tables.get("equilibrium", {}), **keys}
    return _run("equilibrium", case, progress, tables)


@_documented()
def run_stability(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Finds the free motions of [rotor] on its bearings, film and foils included, over the speeds of [stability].

    ``summary["onsets"]`` are the speeds at which whirl begins or ends."""
    return _run("stability", case, progress, tables)


@_documented(
    """
    orbits : bool
        Whether to also find periodic orbits with contacts and friction, by steps in time.
    """
)
def run_unbalance(case: Any, /, *, orbits: bool = False, progress: Progress = None, **tables: Any) -> Result:
    """Computes the response of [rotor] to its unbalances over the speeds of [unbalance], film and foils included.

    ``summary["peaks"]`` are the speeds at which the orbits are largest."""
    if orbits:
        tables["unbalance"] = {**tables.get("unbalance", {}), "orbits": True}
    return _run("unbalance", case, progress, tables)


@_documented()
def run_transient(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Marches [rotor] on its bearings through the speeds of [transient] in time, film, foils and friction included.

    ``to_xarray()`` has the steps over ``step``, what whole revolutions do over ``revolution``, and spectra over
    ``spectrum`` and ``order``."""
    return _run("transient", case, progress, tables)


@_documented(
    """
    data : sequence of mappings, optional
        What was measured, each with keys of [[fit.data]], in place of those of the case: a loop with ``displacements`` and
        ``forces``, a table (``experiment="vibration"`` or ``"equilibrium"``) with ``readings``, a mapping of columns; as
        arrays in SI, or from a ``file``.
    parameters : mapping, optional
        By their keys ``start``, ``lower`` and ``upper`` of the keys that are fitted, and what else [[fit.parameter]]
        has: ``{"friction.coefficient": {"start": 0.1, "lower": 0, "upper": 0.5}}``; in place of those of the case.
    """
)
def fit(
    case: Any,
    /,
    *,
    data: Sequence[Mapping[str, Any]] | None = None,
    parameters: Mapping[str, Mapping[str, Any]] | None = None,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Finds parameters of the case from measured data, with standard errors, as specified in [fit].

    ``summary["parameters"]`` has values and intervals, ``to_xarray()`` what was measured and fitted, ``files["case.toml"]``
    the fitted case."""
    given = dict(tables.get("fit", {}))
    if data is not None:
        given["data"] = [dict(one) for one in data]
    if parameters is not None:
        given["parameter"] = [{"key": key, **values} for key, values in parameters.items()]
    if given:
        tables["fit"] = given
    return _run("fit", case, progress, tables)


@_documented(
    """
    keys : mapping, optional
        By the keys that are chosen their ``lower`` and ``upper`` bounds, and what else [[optimise.key]] has:
        ``{"bearing.radial_clearance": {"lower": "20 um", "upper": "40 um"}}``; in place of those of the case.
    """
)
def optimise(
    case: Any,
    /,
    *,
    keys: Mapping[str, Mapping[str, Any]] | None = None,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Maximises or minimises a quantity over keys of the case under limits, as specified in [optimise].

    ``summary["keys"]`` has the best values, ``summary["limits"]`` their margins, ``to_xarray()`` all points that were
    evaluated, ``files["case.toml"]`` the case with the best values."""
    if keys is not None:
        given = [{"key": key, **values} for key, values in keys.items()]
        tables["optimise"] = {**tables.get("optimise", {}), "key": given}
    return _run("optimise", case, progress, tables)


@_documented(
    """
    over : mapping
        Values by their dotted keys: ``{"friction.coefficient": numpy.linspace(0, 0.5, 11)}``, pint quantities, or a
        range as for the program, ``"60 um:90 um:10 um"`` (end included). With ``equilibrium.speeds`` each point has
        one speed.
    command : str
        ``cycle``, ``strip``, ``vibration``, ``equilibrium``, ``stability``, ``unbalance`` or ``transient``.
    threads : int, optional
        To run points on; by default all cores.
    limits : bool
        For ``equilibrium``: whether to also compute lift-off speeds and load capacities, at a film thickness of
        film.h_lift_off.
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

    Every point keeps its quantities and loops, see :meth:`Result.to_xarray`."""
    if command not in _native.swept_commands():
        raise ValueError(f"{command!r} cannot be swept; use one of {', '.join(_native.swept_commands())}")
    swept = [f"{key}={values if isinstance(values, str) else toml_value(values)}" for key, values in over.items()]
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.sweep(source, command, swept, threads, limits, called)
    return Result._of_run(run)


@_documented(
    """
    folder : path, optional
        Folder where finished samples and the result are written; without it the result is in memory only.
    samples, seed : int, optional
        Number of bearings and seed of the random numbers, instead of those of the case. A sample depends only on its
        number and the seed.
    threads : int, optional
        To run samples on; by default all cores.
    target_error : float, optional
        Ends the run when the standard error of the mean of the maximum force is below this fraction of it.
    limits : sequence of str
        Limits that a bearing must meet, with units: ``"clearance_5N > 20 um"``.
    resume : bool
        Whether to continue an interrupted run in the folder.
    force : bool
        Whether to restart in a folder that contains results.
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
    """Runs the cycles of many random bearings within the tolerances of [montecarlo], their states on the film
    (``montecarlo={"command": "equilibrium", ...}``), or a rotor on them (``"stability"``, ``"unbalance"``,
    ``"transient"``).

    Every sample keeps its quantities, see :meth:`Result.to_xarray`, :meth:`Result.to_dataframe` and
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
    finally:  # partial results, also after Ctrl-C
        with netcdf:
            status, failures = ensemble.publish()
    warn_of(status, failures)
    return Result.load(folder)
