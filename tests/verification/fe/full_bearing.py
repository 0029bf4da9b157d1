"""The reference bearing from solid elements, pushed in four directions.

The bump foil is unwrapped onto a straight base, the top foil is a curved cantilever. Gaps, directions and signs are
those of the program: the journal at (x, y) has the gap C_r + x cos(theta) - y sin(theta) at the angle theta from the
weld.
"""

import time

import numpy as np

from node_contact import NotConverged
from node_model import SHAPE, Foils, build
from records import write_records

RADIUS = 19.05e-3
CLEARANCE = 31.8e-6
BUMPS = 26
AMPLITUDE = 79.5e-6
DIRECTIONS = (0.0, 180.0, 90.0, 270.0)

# What is varied around the first row, which makes the program's assumptions: see node_model.Foils.
VARIANTS = {
    "held": {},
    "moving": {"top_moves": True},
    "wide": {"wide_journal": True},
    "bisector": {"upright_kinks": False},
    "coarse": {"arc_elements": 8, "flat_elements": 5},
    "fine": {"arc_elements": 20, "flat_elements": 14},
}


def run_cycle(model, friction, direction, steps):
    """Pushes the journal along a direction (rad) and back, from the unstressed foils."""
    contacts = model.contacts(friction)
    state = contacts.unstressed()
    journal = model.kind == "journal"
    angle = model.along / RADIUS
    cos, sin = np.cos(angle), np.sin(angle)
    ahead, across = np.array([np.cos(direction), np.sin(direction)]), np.array([-np.sin(direction), np.cos(direction)])
    fractions = np.concatenate([np.arange(steps + 1), np.arange(steps - 1, -1, -1)]) / steps
    gap_before = model.gap + np.where(journal, CLEARANCE, 0.0)
    record = {"displacement_m": fractions * AMPLITUDE, "force_direct_N": [], "force_cross_N": [], "solved_increments": 0}
    for number, fraction in enumerate(fractions):
        x, y = fraction * AMPLITUDE * ahead
        gap = model.gap + np.where(journal, CLEARANCE + x * cos - y * sin, 0.0)
        state, solved = contacts.advance(gap_before, gap, state)
        record["solved_increments"] += solved
        gap_before = gap
        p = state.normal[journal]
        force = np.array([-(p @ cos[journal]), p @ sin[journal]])
        record["force_direct_N"].append(force @ ahead)
        record["force_cross_N"].append(force @ across)
        if number == steps:
            record["max_force_N"] = force @ ahead
            record["bump_loads_N"] = model.loads(state, "crest")
            record["journal_loads_N"] = model.loads(state, "journal")
    record["loop_energy_J"] = np.trapz(record["force_direct_N"], record["displacement_m"])
    return record


def measure(folder, file):
    """Runs all variants and writes what came out."""
    meshes, rows = {}, []
    for name, options in VARIANTS.items():
        foils = Foils(BUMPS, weld_flat=SHAPE.flat / 2, radius=RADIUS, **options)
        model = build(folder, foils)
        meshes[name] = {"arc_elements": foils.arc_elements, "flat_elements": foils.flat_elements,
                        "unknowns": model.K.shape[0], "contacts": len(model.gap)}
        in_full = name in ("held", "moving")
        for friction in (0.0, 0.1) if in_full else (0.1,):
            for direction in DIRECTIONS:
                steps = 100 if in_full else 25
                row = {"variant": name, "friction": friction, "direction_deg": direction, "steps": steps}
                started = time.monotonic()
                try:
                    row.update(converged=True, **run_cycle(model, friction, np.radians(direction), steps))
                except NotConverged:
                    row.update(converged=False)
                rows.append(row)
                print(f"bearing {name}, f = {friction}, {direction:g} deg: {row.get('max_force_N', 'failed')} N, "
                      f"{time.monotonic() - started:.0f} s", flush=True)
    write_records(file, {"source": "stiffness from CalculiX 2.20, contact at nodes", "amplitude_m": AMPLITUDE,
                         "meshes": meshes}, rows)
