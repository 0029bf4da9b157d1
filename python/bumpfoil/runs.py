"""The commands of the program."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from . import _native
from .case import Case, as_case, toml_value
from .progress import Progress, shown
from .result import Result, netcdf, warn_of

_WHAT_RUNS_TAKE = """

    Parameters
    ----------
    case : Case, path, str or mapping
        What :class:`Case` takes.
    progress : bool or callable, optional
        Whether to show how far the run is: without it on a terminal and in a notebook, after a second. Or what is to be
        called with the fraction that is done, 0 to 1; returning False ends the run, whose result is partial then.
    **tables : mapping
        Keys of the case that are changed: ``friction={"coefficient": 0.2}``.

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


def _run(command: str, case: Any, progress: Progress, tables: dict[str, Any]) -> Result:
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.run(command, source, called)
    return Result._of_run(run)


def check(case: Any = None, /, **tables: Any) -> Case:
    """Reads and checks a case; raises a CaseError that lists every fault. What it takes is what :class:`Case` takes."""
    return as_case(case, tables)


def properties(case: Any, /, **tables: Any) -> dict[str, Any]:
    """Truss constants, single-bump stiffnesses, softest and stiffest modes: what ``bumpfoil properties --json`` prints.

    Units are at the ends of the keys; None is what is not known.
    """
    found: dict[str, Any] = json.loads(as_case(case, tables)._source.properties())
    return found


def run_cycle(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Pushes the journal in each direction of [cycle] and pulls it back."""
    return _run("cycle", case, progress, tables)


def run_strip(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Compresses a flat strip of the foils between two plates, as [strip] says."""
    return _run("strip", case, progress, tables)


def run_path(
    case: Any, /, positions: Any = None, loads: Any = None, *, progress: Progress = None, **tables: Any
) -> Result:
    """Takes the journal along the path of [path], or along one of NumPy.

    With `positions` (m) or `loads` (N), arrays of the shape (points, 2), these are the path; the first increment is the
    assembly at the centre of the bearing."""
    if positions is not None:
        tables["path"] = {**tables.get("path", {}), "points": np.asarray(positions, dtype=float)}
    if loads is not None:
        points = [[f"{force!r} N" for force in load] for load in np.asarray(loads, dtype=float).tolist()]
        tables["path"] = {**tables.get("path", {}), "points": points}
    return _run("path", case, progress, tables)


def run_vibration(case: Any, /, *, progress: Progress = None, **tables: Any) -> Result:
    """Lets the journal vibrate about static loads, as [vibration] says: stiffness, damping and loss factor."""
    return _run("vibration", case, progress, tables)


def run_equilibrium(
    case: Any, /, *, all_paths: bool = False, limits: bool = False, progress: Progress = None, **tables: Any
) -> Result:
    """Finds where the journal of a running bearing is, with gas film, foils and friction, as [equilibrium] says.

    With `all_paths` every state is come to by every path that leads there, and ``summary["spreads"]`` tells how far they
    lie apart. With `limits` lift-off speeds and load capacities are found, too, where the film is film.h_lift_off thin:
    ``summary["limits"]``."""
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.run_equilibrium(source, all_paths, limits, called)
    return Result._of_run(run)


def run_sweep(
    case: Any,
    /,
    over: Mapping[str, Any],
    *,
    command: str = "cycle",
    threads: int | None = None,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Runs a command for every combination of the values of some keys, on all cores.

    `over` has the values by their dotted keys: ``{"friction.coefficient": numpy.linspace(0, 0.5, 11)}``, or a range as
    the program takes it, ``"60 um:90 um:10 um"`` (its end included). `command` is cycle, strip, vibration or
    equilibrium. What is kept of every point are its quantities and loops, see :meth:`Result.to_xarray`."""
    if command not in _native.swept_commands():
        raise ValueError(f"{command!r} is not swept; give one of {', '.join(_native.swept_commands())}")
    swept = [f"{key}={values if isinstance(values, str) else toml_value(values)}" for key, values in over.items()]
    source = as_case(case, tables)._source
    with shown(progress) as called:
        run = _native.sweep(source, command, swept, threads, called)
    return Result._of_run(run)


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
    """Runs the cycles of many bearings that differ within the tolerances of [montecarlo].

    With a `folder` the samples are kept there as they come: `resume` goes on where a run was interrupted, `force` begins
    anew. `samples` and `seed` change those of the case; `target_error` ends the run when the standard error of the mean
    of the maximum force is below that part of it; `limits` are what a bearing is to keep, ``"clearance_5N > 20 um"``.
    Samples depend on their number and the seed alone. See :meth:`Result.to_xarray` and ``summary["statistics"]``."""
    if folder is None:
        with tempfile.TemporaryDirectory(prefix="bumpfoil-") as temporary:
            return run_montecarlo(
                case, temporary, samples=samples, seed=seed, threads=threads, target_error=target_error, limits=limits,
                progress=progress, **tables,
            )  # fmt: skip
    tables["montecarlo"] = {**tables.get("montecarlo", {}), "samples": samples, "seed": seed}
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


for _function in (run_cycle, run_strip, run_path, run_vibration, run_equilibrium, run_sweep, run_montecarlo):
    _function.__doc__ = (_function.__doc__ or "") + _WHAT_RUNS_TAKE
