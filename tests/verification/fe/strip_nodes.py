"""Strips between plates with contact at nodes: small displacements, the same stiffness as the decks."""

import numpy as np

from node_contact import NotConverged
from node_model import SHAPE, Foils, build


def run_strip(folder, strip):
    """Presses and releases a strip (strip_deck.Strip); returns a record like that of a deck."""
    model = build(folder, Foils(strip.bumps, top_foil=strip.top_foil, top_lead=SHAPE.flat / 2))
    contacts = model.contacts(strip.friction)
    pressed = model.kind == "journal"
    fractions = np.concatenate([np.arange(strip.increments + 1), np.arange(strip.increments - 1, -1, -1)])
    fractions = fractions / strip.increments
    state, gap_before = contacts.unstressed(), model.gap
    forces = []
    record = {}
    for number, fraction in enumerate(fractions):
        gap = model.gap - np.where(pressed, fraction * strip.compression, 0.0)
        try:
            state, _ = contacts.advance(gap_before, gap, state)
        except NotConverged:
            return {"converged": False, "increments": number}
        gap_before = gap
        loads = model.loads(state, "journal")
        forces.append(loads.sum())
        if number == strip.increments:
            record = {"max_force_N": loads.sum(), "bump_loads_N": loads}
            if strip.top_foil:
                record["crest_loads_N"] = model.loads(state, "crest")
    displacements = fractions * strip.compression
    return {"converged": True, "increments": len(fractions) - 1, **record,
            "loop_energy_J": np.trapz(forces, displacements),
            "displacement_m": displacements, "force_N": np.array(forces)}
