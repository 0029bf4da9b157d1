"""Pint quantities: converted on input, to strings that the case reader accepts or to plain numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import CaseError

#: What quantities of cases measure, in SI.
_SI = ("m", "rad", "N", "N/m", "Pa", "rad/s", "K", "Pa*s", "Pa/m", "1/m**2")


def is_quantity(value: Any) -> bool:
    """Whether a value is a pint quantity; pint need not be installed."""
    return hasattr(value, "magnitude") and hasattr(value, "to_base_units")


def case_value(quantity: Any) -> Any:
    """A quantity, or an array of them, as in case files: strings with SI units, or plain numbers if dimensionless."""
    base = quantity.to_base_units()
    counts_radians = "radian" in str(base.units)  # for pint they are nothing, so that hertz were rad/s
    if base.dimensionless and not counts_radians:
        return _listed(base.magnitude)
    for unit in _SI:
        if quantity.is_compatible_with(unit) and counts_radians == ("rad" in unit):
            return _with_unit(_listed(_converted(quantity, unit)), unit.replace("**", "").replace("*", " "))
    return _with_unit(_listed(quantity.magnitude), f"{quantity.units:C}")  # hertz; the reader refuses others


def si_numbers(values: Any, unit: str, name: str) -> NDArray[Any]:
    """Numbers in `unit` of an array, quantities or nested sequences of either, for values that are not keys of a case.

    Raises
    ------
    CaseError
        They are texts, or measure something else.
    """
    found = _si_values(values, unit, name)
    try:
        return np.asarray(found, dtype=float)
    except (TypeError, ValueError) as error:
        raise CaseError(f"{name}: is not an array of numbers: {error}; give numbers in {unit} or quantities of pint") from None


def _si_values(values: Any, unit: str, name: str) -> Any:
    held = values if is_quantity(values) else getattr(values, "data", values)  # a DataArray of xarray may hold some
    if is_quantity(held):
        if not held.is_compatible_with(unit):
            raise CaseError(f"{name} = {held}: is not in {unit}; give numbers in {unit} or quantities that can be converted")
        return _converted(held, unit)
    if isinstance(values, str):
        raise CaseError(f"{name} = {values!r}: is a text; give numbers in {unit} or quantities of pint")
    if isinstance(values, (list, tuple)):
        return [_si_values(entry, unit, name) for entry in values]
    if isinstance(values, np.ndarray) and values.dtype.kind in "OU":  # single quantities, or texts
        return _si_values(values.tolist(), unit, name)
    return values


def _converted(quantity: Any, unit: str) -> Any:
    """The magnitude in another unit. As the reader of cases does, dividing by 1e6 gives the double nearest to the
    decimal fraction where multiplying by 1e-6 may miss it."""
    divisor = type(quantity)(1.0, unit).m_as(quantity.units)
    whole = round(divisor)
    if whole > 1 and abs(divisor - whole) < 1e-14 * whole:
        return quantity.magnitude / whole
    return quantity.m_as(unit)


def _listed(magnitude: Any) -> Any:
    return magnitude.tolist() if hasattr(magnitude, "tolist") else magnitude


def _with_unit(magnitude: Any, unit: str) -> Any:
    if isinstance(magnitude, list):
        return [_with_unit(entry, unit) for entry in magnitude]
    return f"{magnitude!r} {unit}"
