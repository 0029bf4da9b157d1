"""Draws, into the folder it is run in, a picture of each case file of examples/: case_NAME.svg, and the same as PDF."""

import sys
import warnings
from pathlib import Path

import bumpfoil
from bumpfoil import figures

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
# Enough for a picture of a spread, in a tenth of the time.
COARSE = {"columns_per_pitch": 4, "rows": 6}
# What each case is about; all others are cycles, shown by their loops.
DRAWN = {
    "fit": lambda case: figures.fitted(bumpfoil.fit(case, fit={"starts": 1})),
    "graded": lambda case: figures.bump_loads(bumpfoil.run_cycle(case), width="double"),
    "larsen-strip": lambda case: figures.loops(bumpfoil.run_strip(case)),
    "optimise": lambda case: figures.optimised(bumpfoil.optimise(case, optimise={"evaluations": 40})),
    "measured": lambda case: figures.foils(bumpfoil.run_cycle(case).cycles[0]),
    "out_of_round": lambda case: figures.foils(bumpfoil.run_cycle(case).cycles[0]),
    "running": lambda case: figures.coefficients(bumpfoil.run_equilibrium(case)),
    "misaligned": lambda case: figures.coefficients(bumpfoil.run_equilibrium(case)),
    "running_from_rest": lambda case: figures.run_up(bumpfoil.run_equilibrium(case)),
    "rotor": lambda case: figures.campbell(bumpfoil.run_stability(case)),
    "rotor_unlike": lambda case: figures.campbell(bumpfoil.run_stability(case)),
    "rotor_pads": lambda case: figures.campbell(bumpfoil.run_stability(case)),
    "running_pads": lambda case: figures.coefficients(bumpfoil.run_equilibrium(case)),
    "strip": lambda case: figures.loops(bumpfoil.run_strip(case)),
    "three_pads": lambda case: figures.bump_loads(bumpfoil.run_cycle(case), width="double"),
    "tolerances": lambda case: figures.ensemble(bumpfoil.run_montecarlo(case)),
    "running_tolerances": lambda case: figures.ensemble(bumpfoil.run_montecarlo(case, samples=20, film=COARSE)),
    "coast_down": lambda case: figures.waterfall(bumpfoil.run_transient(case)),
    "rotor_tolerances": lambda case: figures.ensemble(bumpfoil.run_montecarlo(case, samples=20)),
    "vibration": lambda case: figures.coefficients(bumpfoil.run_vibration(case)),
}


def loops(case):
    return figures.loops(bumpfoil.run_cycle(case), width="double")


warnings.simplefilter("ignore", bumpfoil.RunWarning)  # gen1 is pressed beyond what its bumps can be
for case in sorted(EXAMPLES.glob("*.toml")):
    figures.save(DRAWN.get(case.stem, loops)(case), f"case_{case.stem}")
