"""Results of a command, in memory and in files."""

from __future__ import annotations

import io
import json
import math
import os
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable, Mapping
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _native, notebook, plots, tables
from .case import Case
from .cycle import Cycle
from .errors import FileError, RunWarning
from .places import pads_of

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.axes import Axes

#: netCDF is not thread-safe, and its package for Python lets other threads go on: who reads or writes holds this.
netcdf = threading.RLock()

_PAGE = Path(__file__).with_name("report.html")

class Result:
    """Result of a command: its cycles, if it has any, and its files.

    Attributes
    ----------
    command : str
        ``cycle``, ``strip``, ``path``, ``vibration``, ...
    cycles : list of Cycle
        In the order of the case; only for ``cycle``, ``strip`` and ``path``.
    files : dict of bytes
        The files of the result by name, as :meth:`save` writes them.
    """

    def __init__(self, command: str, cycles: list[Cycle], run: _native.Run | None = None, files: dict[str, bytes] | None = None) -> None:
        self.command = command
        self.cycles = cycles
        self._run = run
        if files is not None:
            self.files = files  # in place of the property, which would make them

    @classmethod
    def _of_run(cls, run: _native.Run) -> Result:
        warn_of(run.status, [*run.failures, *run.warnings])
        pads = partial(_pads_of_run, run)
        return cls(run.command, [Cycle(**views, pads=pads) for views in run.cycles()], run=run)

    @cached_property
    def files(self) -> dict[str, bytes]:
        assert self._run is not None  # those of a file are there
        with netcdf:
            return self._run.files()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Contents of summary.json."""
        summary: dict[str, Any] = json.loads(self.files["summary.json"])
        return summary

    @property
    def status(self) -> str:
        """``complete``, ``failed`` or ``interrupted``; the results of the last two are partial."""
        return self._run.status if self._run is not None else str(self.summary["status"])

    @cached_property
    def case(self) -> Case:
        """The case that was run."""
        return Case(self.summary["case"])

    def save(self, folder: str | os.PathLike[str], *, force: bool = False) -> None:
        """Writes the files of the result, all or none.

        Parameters
        ----------
        folder : path
            Created if it does not exist.
        force : bool
            Whether to replace existing results; refused otherwise.

        Raises
        ------
        FileError
        """
        _native.save(os.fspath(folder), self.files, force)

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Result:
        """Reads what :meth:`save`, or the program, wrote.

        Parameters
        ----------
        folder : path
            Of the result.

        Raises
        ------
        FileError
            There is no result, or it is damaged.
        """
        files = {"summary.json": _read(folder, "summary.json")}
        try:
            summary = json.loads(files["summary.json"])
            command, listed = summary["command"], dict(summary["files"])
            whole = _native.is_sealed(files["summary.json"], summary["xxh3_128"])
        except (ValueError, KeyError, TypeError):
            raise FileError(f"{os.fspath(folder)}/summary.json: is not a summary of a result of this version") from None
        if not whole:
            raise FileError(f"{os.fspath(folder)}/summary.json: is damaged")
        for name, entry in listed.items():
            files[name] = _read(folder, name)
            if _native.checksum(files[name]) != entry["xxh3_128"]:
                raise FileError(f"{os.fspath(folder)}/{name}: is damaged, or of another run than summary.json")
        cycles = read_cycles(files["result.nc"], summary) if command in ("cycle", "strip", "path") else []
        return cls(command, cycles, files=files)

    @property
    def _data_file(self) -> bytes:
        """result.nc; of a sweep sweep.nc, of an ensemble ensemble.nc."""
        (contents,) = (contents for name, contents in self.files.items() if name.endswith(".nc"))
        return contents

    @cached_property
    def data(self) -> dict[str, NDArray[Any]]:
        """The variables of result.nc (of a sweep sweep.nc, of an ensemble ensemble.nc) by their names, docs/results.md.

        Read-only arrays in SI over the dimensions documented there, created once and shared. Missing values are NaN;
        flags, such as ``status``, are numbers. :meth:`to_xarray` also has their meanings, units and coordinates. Fields of
        cycles are views of the run itself in ``cycles[i].fields``."""
        import netCDF4

        with netcdf, netCDF4.Dataset("data.nc", memory=self._data_file) as file:
            return {name: _plain(variable[...]) for name, variable in file.variables.items()}

    def to_xarray(self) -> xarray.Dataset:
        """result.nc (of a sweep sweep.nc, of an ensemble ensemble.nc) as a data set in memory."""
        import netCDF4
        import xarray

        make_store: Any = xarray.backends.NetCDF4DataStore
        with netcdf, xarray.open_dataset(make_store(netCDF4.Dataset("data.nc", memory=self._data_file))) as dataset:
            return dataset.load()

    def to_dataframe(self, table: str | None = None) -> pandas.DataFrame:
        """A CSV file of the result as a table, to the last bit; for an ensemble its samples, for an optimisation its points.

        Parameters
        ----------
        table : str, optional
            Name of the file without extension; by default that of the command, of ``optimise`` ``points``.

        Returns
        -------
        DataFrame
            Column names end with their unit. For an ensemble a row per sample and direction, state or rotor.

        Raises
        ------
        ValueError
            The result has no such table.
        """
        name = table or ("points" if self.command == "optimise" else self.command)
        if name == self.command == "montecarlo":
            return tables.of_samples(self.to_xarray())
        return tables.of_csv(self, name)

    def report(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Writes the page of ``bumpfoil report``: one HTML file to open in a browser.

        Parameters
        ----------
        path : path
            Of the file.
        force : bool
            Whether to replace an existing file; refused otherwise.
        """
        write_report({self.command: self}, path, force=force)

    def to_vtk(self, folder: str | os.PathLike[str], *, force: bool = False) -> int:
        """Writes files for ParaView, PyVista or meshio, as ``bumpfoil export --to vtk`` does: foils, journal, pressure, film
        thickness and contact forces of every state of ``cycle``, ``path``, ``equilibrium`` or ``film``.

        Parameters
        ----------
        folder : path
            Created if it does not exist; has ``cylinder.pvd`` and ``unwrapped.pvd``, which list the files of the states.
        force : bool
            Whether to replace existing files; refused otherwise.

        Returns
        -------
        int
            Number of states.
        """
        with netcdf:
            return _native.write_vtk(self._data_file, Path(folder), force)

    def plot_loops(self, *, ax: Axes | None = None) -> Axes:
        """Plots the direct force (N) against the displacement (µm), cycle by cycle.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.loops(self, ax)

    def plot_bump_loads(self, *, ax: Axes | None = None) -> Axes:
        """Plots the bump loads at full displacement (N), cycle by cycle.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.bump_loads(self, ax)

    def plot_coefficients(self, *, ax: Axes | None = None) -> Axes:
        """Plots direct stiffnesses (MN/m): of vibrations against amplitude; of running bearings, for full stick,
        against frequency, speed or load, whichever varies.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.coefficients(self, ax)

    def plot_ensemble(self, quantity: str | None = None, *, ax: Axes | None = None) -> Axes:
        """Plots the distribution of a quantity of an ensemble, by direction, by state of running bearings, or of rotors.

        Parameters
        ----------
        quantity : str, optional
            A variable of ensemble.nc over samples and directions, states or rotor, such as ``loss_factor``; by default
            the one that the target error refers to: the maximum force, the minimum film thickness, ...
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.ensemble(self, quantity, ax)

    def plot_sweep(self, quantity: str = "max_force", *, ax: Axes | None = None) -> Axes:
        """Plots a quantity of a sweep against its first key, a line for each combination of the other keys.

        Parameters
        ----------
        quantity : str
            A variable of sweep.nc over its keys, such as ``loss_factor``.
        ax : matplotlib axes, optional
            Axes to draw on; by default new ones.
        """
        return plots.sweep(self, quantity, ax)

    def __repr__(self) -> str:
        counted = f" of {len(self.cycles)} cycles" if len(self.cycles) > 1 else ""
        return f"<bumpfoil.Result of {self.command}{counted}, {self.status}>"

    def _repr_html_(self) -> str:
        return notebook.of_result(self)


def warn_of(status: str, lines: list[str]) -> None:
    """Issues the warnings of a run, at the calling line outside this package."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == os.path.dirname(__file__):
        level, frame = level + 1, frame.f_back
    interrupted = ["the run was interrupted: its result is partial"] if status == "interrupted" else []
    for line in interrupted + lines:
        warnings.warn(line, RunWarning, stacklevel=level)


def _read(folder: str | os.PathLike[str], name: str) -> bytes:
    try:
        return Path(_native.published_file(os.fspath(folder), name)).read_bytes()
    except OSError as error:
        raise FileError(f"{os.fspath(folder)}/{name}: cannot be read: {error.strerror}") from None


def write_report(results: Mapping[str, Result], path: str | os.PathLike[str], *, force: bool = False) -> None:
    """Writes a report that compares several results in the same charts, as ``bumpfoil report`` does.

    Parameters
    ----------
    results : mapping
        Results by their names in the report.
    path : path
        Of the file.
    force : bool
        Whether to replace an existing file; refused otherwise.
    """
    page = _PAGE.read_text(encoding="utf-8") if _PAGE.exists() else ""
    if not page:
        raise FileError("this package was built without the report page: Node.js and npm were not found")
    with tempfile.TemporaryDirectory(prefix="bumpfoil-") as temporary:
        folders = []
        for name, result in results.items():
            folders.append(Path(temporary, name.replace(os.sep, " ")))
            result.save(folders[-1])
        with netcdf:
            _native.write_report(folders, page, os.fspath(path), force)


def read_cycles(contents: bytes, summary: Mapping[str, Any]) -> list[Cycle]:
    """The cycles in the bytes of a result.nc, in the order of summary.json."""
    import netCDF4

    with netcdf, netCDF4.Dataset("result.nc", memory=contents) as file:
        (of_cycles,) = {"direction", "cycle"} & set(file.dimensions) or (None,)
        places: list[Any] = [()]
        if of_cycles is not None:
            known = file[of_cycles][:].tolist()
            key = {"direction": "direction_deg", "cycle": "cycle"}[of_cycles]
            places = [known.index(cycle[key]) for cycle in summary["cycles"]]
        names = {*_native.quantity_names(summary["command"]), *filter(None, [of_cycles])}
        pads = pads_of(file.variables).copy
        return [_read_cycle(file, names, of_cycles, place, pads) for place in places]


def _pads_of_run(run: _native.Run) -> dict[str, NDArray[Any]]:
    import netCDF4

    with netcdf, netCDF4.Dataset("result.nc", memory=run.files()["result.nc"]) as file:
        return pads_of(file.variables)


def _read_cycle(
    file: Any, names: set[str], of_cycles: str | None, place: Any, pads: Callable[[], dict[str, NDArray[Any]]]
) -> Cycle:
    quantities: dict[str, Any] = {}
    series: dict[str, NDArray[Any]] = {}
    fields: dict[str, NDArray[Any]] = {}
    events: dict[str, NDArray[Any]] = {}
    for name, variable in file.variables.items():
        dims = [dim for dim in variable.dimensions if dim != of_cycles]
        values = variable[place] if of_cycles in variable.dimensions else variable[...]
        if name in dims or (not dims and name not in names):
            continue  # numbers of increments, bumps and feet; geometry
        if dims == ["event"]:
            events[name] = _plain(values)
        elif dims == ["increment"] and name in ("stress_top_foil_weld", "stress_bump_foil_weld"):
            fields[name] = _plain(values)
        elif dims[:1] == ["increment"]:
            (series if len(dims) == 1 else fields)[name] = _plain(values)
        elif dims == ["clearance_force"]:
            forces = file["clearance_force"][:]
            quantities.update({f"clearance_{force:.6g}N": value for force, value in zip(forces, _plain(values).tolist())})
        elif not dims:
            quantities[name] = int(values) if name == "cycle" else _word(variable, values)
        elif name.endswith("_loads") or "pad_forces" in name:
            quantities[name] = _plain(values)
    return Cycle(quantities, series, fields, events, pads)


def _plain(values: Any) -> NDArray[Any]:
    """Without a mask: missing values are NaN."""
    if isinstance(values, np.ma.MaskedArray) and values.mask.any():
        numbers: Any = values.astype(float)
        values = numbers.filled(np.nan)
    plain: NDArray[Any] = np.asarray(values)
    plain.flags.writeable = False
    return plain


def _word(variable: Any, value: Any) -> Any:
    if value is np.ma.masked:
        return math.nan if variable.dtype.kind == "f" else None
    if "flag_meanings" not in variable.ncattrs():
        return value.item()
    words = variable.flag_meanings.split()
    return bool(value) if words == ["no", "yes"] else words[int(value)]
