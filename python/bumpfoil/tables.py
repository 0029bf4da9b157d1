"""Tables of results as data frames."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native

if TYPE_CHECKING:
    import pandas
    import xarray

    from .result import Result


def of_csv(result: Result, name: str) -> pandas.DataFrame:
    """A CSV file of a result, to the last bit."""
    import pandas

    file = f"{name}.csv"
    if file not in result.files:
        known = [name[:-4] for name in result.files if name.endswith(".csv")]
        if result.command == "montecarlo":
            known.append(result.command)
        raise ValueError(f"a result of {result.command} has no table {name!r}; it has {', '.join(known)}")
    return pandas.read_csv(io.BytesIO(result.files[file]), float_precision="round_trip")


def place_of(ensemble: xarray.Dataset) -> str:
    """The second dimension of an ensemble besides its samples: directions of cycles, states of running bearings, or the rotor."""
    return next(place for place in ("rotor", "state", "direction") if place in ensemble.dims)


def sampled_command(summary: Mapping[str, Any]) -> str:
    """The command that was run for each bearing of an ensemble. Version 0.2.0 ran cycles alone, without saying so."""
    return str(summary.get("sampled_command", "cycle"))


def target_of(ensemble: xarray.Dataset) -> str:
    """The quantity whose mean ``--target-error`` refers to, also of ensembles by version 0.2.0."""
    return str(ensemble.attrs.get("target_quantity", "max_force"))


def of_samples(ensemble: xarray.Dataset) -> pandas.DataFrame:
    """A row for each sample and direction, state or rotor, of an ensemble.nc, with columns named as those of CSV files."""
    place = place_of(ensemble)
    shapes = (("sample",), (place,), ("sample", place))
    names = [name for name, values in ensemble.data_vars.items() if values.dims in shapes]
    table = ensemble[names].to_dataframe(dim_order=["sample", place]).reset_index()
    for name in names:
        words = ensemble[name].attrs.get("flag_meanings", "").split()
        if words:
            table[name] = [None if np.isnan(number) else _meant(words, int(number)) for number in table[name]]
    return table.rename(columns={name: _native.key_of(name, ensemble[name].attrs.get("units", "")) for name in [place, *names]})


def _meant(words: list[str], number: int) -> Any:
    return bool(number) if words == ["no", "yes"] else words[number]
