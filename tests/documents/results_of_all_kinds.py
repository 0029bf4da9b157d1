"""Prints, as JSON, the variables of results of all kinds, in other cases than the reference of variables is made of.

Usage: results_of_all_kinds.py EXAMPLES
"""

import json
import sys
import warnings
from pathlib import Path

import bumpfoil

EXAMPLES = Path(sys.argv[1])


def results():
    push = {"directions": ["-X"], "steps": 3}
    orbit = {"centre": ["0 um", "-30 um"], "semi_axes": ["5 um", "3 um"], "steps": 6, "orbits": 1}
    motion = {"motion": "orbit", "amplitudes": ["1 um"], "steps": 3, "loads": [[0, -20]], "frequencies": ["1 Hz"]}
    frame = {"model": "frame"}
    yield bumpfoil.run_cycle(EXAMPLES / "graded.toml", cycle=push, bump_foil=frame)
    yield bumpfoil.run_cycle(EXAMPLES / "out_of_round.toml", cycle=push)
    yield bumpfoil.run_cycle(EXAMPLES / "three_pads.toml", cycle=push, solver={"name": "events"})
    yield bumpfoil.run_strip(EXAMPLES / "larsen-strip.toml", strip={"steps": 3})
    yield bumpfoil.run_path(EXAMPLES / "three_pads.toml", path=orbit)
    yield bumpfoil.run_vibration(EXAMPLES / "three_pads.toml", vibration=motion)
    states = {"speeds": ["30000 rpm"], "positions": [["10 um", "0 um"]], "steps": 1}
    mesh = {"columns_per_pitch": 4, "rows": 4}
    yield bumpfoil.run_equilibrium(EXAMPLES / "gen1.toml", film=mesh, equilibrium=states)
    yield bumpfoil.run_equilibrium(EXAMPLES / "running_pads.toml", film=mesh, equilibrium={"loads": [["10 N", "0 N"]]})
    yield bumpfoil.run_montecarlo(EXAMPLES / "tolerances.toml", samples=2, cycle=push)


warnings.simplefilter("ignore", bumpfoil.RunWarning)  # of increments that are as few as can be
print(json.dumps([[result.summary["command"], list(result.data)] for result in results()]))
