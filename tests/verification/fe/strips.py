"""Strips of bumps between plates: CalculiX with its own contact, and the same foils with contact at nodes."""

import re
import time
from pathlib import Path

import numpy as np

from calculix import run
from records import write_records
from strip_deck import STICK_SLOPE, STIFFNESS, Strip, make_deck
from strip_nodes import run_strip

STRIPS = [Strip(bumps, friction, large, top_foil) for top_foil in (False, True) for bumps in (1, 3, 10)
          for large in (False, True) for friction in (0.0, 0.1, 0.3)]
TOTALS = re.compile(r"set BUMP\d+\s+and time\s+(\S+)\s+\S+\s+(\S+)")


def read_deck_results(folder, strip):
    """Forces per increment from the printed results of a deck; the last ones that are there if it broke off."""
    loads = {}
    for moment, force in TOTALS.findall((Path(folder) / f"{strip.name}.dat").read_text()):
        loads.setdefault(float(moment), []).append(-float(force))
    moments = np.array(sorted(loads))
    pressed = np.where(moments <= 1.0, moments, 2.0 - moments)
    record = {"displacement_m": np.concatenate([[0.0], pressed * strip.compression]),
              "force_N": np.concatenate([[0.0], [sum(loads[moment]) for moment in moments]])}
    if len(moments) and moments[-1] >= 1.0:
        turn = np.argmin(np.abs(moments - 1.0))
        record.update(max_force_N=record["force_N"][turn + 1], bump_loads_N=loads[moments[turn]])
    finished = len(moments) > 0 and moments[-1] > 2.0 - 1e-6
    if finished:
        record["loop_energy_J"] = np.trapz(record["force_N"], record["displacement_m"])
        # A strip that is released cannot push harder: friction has gone astray.
        record["jumps"] = np.count_nonzero(np.diff(record["force_N"][turn + 1:]) > 0)
    return {"converged": finished, "increments": len(moments), **record}


def methods_for(strip):
    """Contact at nodes is for small displacements; decks of ten bumps with a top foil take too long."""
    decks = not (strip.top_foil and strip.bumps == 10)
    return (["nodes"] if not strip.large else []) + (["surface"] if decks else [])


def measure(folder, file):
    """Runs all strips and writes what came out after each."""
    rows = []
    for strip in STRIPS:
        for method in methods_for(strip):
            started = time.monotonic()
            if method == "nodes":
                result = run_strip(folder, strip)
            else:
                output = run(folder, strip.name, make_deck(strip))
                result = {"iterations": output.count("iteration"), **read_deck_results(folder, strip)}
            seconds = time.monotonic() - started
            rows.append({"bumps": strip.bumps, "friction": strip.friction, "top_foil": strip.top_foil,
                         "displacements": "large" if strip.large else "small", "contact": method, **result})
            write_records(file, {"source": "CalculiX 2.20", "compression_m": strip.compression,
                                 "increments_each_way": strip.increments, "arc_elements": strip.arc_elements,
                                 "flat_elements": strip.flat_elements, "pressure_stiffness_MPa_per_mm": STIFFNESS,
                                 "stick_slope_MPa_per_mm": STICK_SLOPE}, rows)
            print(f"{strip.name}, contact at {method}: {result.get('max_force_N', 'failed')} N, {seconds:.0f} s",
                  flush=True)
