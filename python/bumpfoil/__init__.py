"""Mechanics of bump-type gas foil bearings: contact, friction, hysteresis and gas film.

>>> import bumpfoil
>>> result = bumpfoil.run_cycle("case.toml", friction={"coefficient": 0.2})
>>> result.cycles[0].loop_energy, result.cycles[0].force_direct  # J, N
"""

from . import _native
from .case import Case, template
from .cycle import Cycle
from .errors import CaseError, Error, FileError, RunWarning
from .result import Result, write_report
from .ross_rotor import write_ross_rotor
from .running_stepper import Instant, RunningStepper
from .runs import (
    check,
    fit,
    optimise,
    properties,
    run,
    run_cycle,
    run_equilibrium,
    run_montecarlo,
    run_path,
    run_stability,
    run_strip,
    run_sweep,
    run_transient,
    run_unbalance,
    run_vibration,
)
from .stepper import State, Stepper

__version__: str = _native.version
load = Result.load

__all__ = [
    "Case",
    "CaseError",
    "Cycle",
    "Error",
    "FileError",
    "Instant",
    "Result",
    "RunWarning",
    "RunningStepper",
    "State",
    "Stepper",
    "check",
    "fit",
    "load",
    "optimise",
    "properties",
    "run",
    "run_cycle",
    "run_equilibrium",
    "run_montecarlo",
    "run_path",
    "run_stability",
    "run_strip",
    "run_sweep",
    "run_transient",
    "run_unbalance",
    "run_vibration",
    "template",
    "write_report",
    "write_ross_rotor",
]
