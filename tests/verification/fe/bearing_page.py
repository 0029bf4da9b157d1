"""docs/verification/fe_bearing.md: the program against the bearing of solid elements."""

import numpy as np
from matplotlib import pyplot

import program
from page import STYLES, fill, percent, save, table
from records import read_records

NAMES = {0: "+X", 180: "−X", 90: "+Y", 270: "−Y"}
VARIANT_TEXT = {
    "held": "as above",
    "moving": "the top foil may move tangentially",
    "wide": "the journal touches the top foil up to 0.33 mm beside each crest",
    "bisector": "kinks cut along their bisector",
    "coarse": "coarser mesh",
    "fine": "finer mesh",
}


def run_program(binary, folder, model, friction, steps):
    """Summaries of the four directions, by degrees, with the forces of all increments."""
    settings = {"bump_foil.model": model, "bump_foil.height_reference": "midsurface",
                "friction.coefficient": friction, "cycle.steps": steps}
    summary = program.run(binary, "cycle", "gen1.toml", folder, settings)
    forces = program.column(folder / "cycle.csv", "force_direct_N", by="direction_deg")
    for cycle in summary["cycles"]:
        cycle["force_direct_N"] = np.array(forces[cycle["direction_deg"]])
    return {round(cycle["direction_deg"]): cycle for cycle in summary["cycles"]}


def write(binary, folder, data, page):
    measured = read_records(data)
    cycles = {(row["variant"], row["friction"], row["direction_deg"]): row for row in measured["rows"]}
    runs = {(model, friction): run_program(binary, folder, model, friction, 100)
            for model in ("frame", "truss") for friction in (0.0, 0.1)}

    comparison = []
    for friction in (0.0, 0.1):
        for direction, name in NAMES.items():
            fe = cycles["held", friction, direction]
            frame, truss = runs["frame", friction][direction], runs["truss", friction][direction]
            loads, fe_loads = np.array(frame["bump_loads_N"]), np.array(fe["bump_loads_N"])
            along = np.abs(frame["force_direct_N"] - fe["force_direct_N"]).max() / fe["max_force_N"]
            loop = fe["loop_energy_J"] if friction else None
            comparison.append([
                friction, name, f"{fe['max_force_N']:.1f}", f"{frame['max_force_N']:.1f}",
                percent(frame["max_force_N"], fe["max_force_N"]),
                f"{100 * np.abs(loads - fe_loads).max() / fe_loads.max():.1f}", f"{100 * along:.1f}",
                f"{1e3 * loop:.2f}" if loop else "0", f"{1e3 * frame['loop_energy_J']:.2f}" if loop else "0",
                percent(frame["loop_energy_J"], loop) if loop else "", f"{truss['max_force_N']:.1f}",
                percent(truss["max_force_N"], fe["max_force_N"])])

    variants = []
    for variant, text in VARIANT_TEXT.items():
        rows = [cycles[variant, 0.1, direction] for direction in NAMES]
        mesh = measured["meshes"][variant]
        variants.append([text, f"{mesh['arc_elements']}, {mesh['flat_elements']}", mesh["unknowns"], mesh["contacts"],
                         rows[0]["steps"],
                         *(f"{row['max_force_N']:.1f}" if row["converged"] else "failed" for row in rows)])
    fill(page, {
        "comparison": table(["f", "", "FE (N)", "frame (N)", "%", "loads %", "loop %", "FE (mJ)", "frame (mJ)", "%",
                             "truss (N)", "%"], comparison),
        "variants": table(["solid elements", "per half arc, flat", "unknowns", "contacts", "steps", *NAMES.values()],
                          variants)})

    figure, axes = pyplot.subplots(figsize=(8.6, 4.7))
    micrometres = 1e6 * np.array(cycles["held", 0.1, 0]["displacement_m"])
    for (direction, name), (colour, _) in zip(NAMES.items(), STYLES):
        axes.plot(micrometres, runs["frame", 0.1][direction]["force_direct_N"], "-", color=colour, lw=1.6,
                  label=f"{name}, frame")
        axes.plot(micrometres[::5], cycles["held", 0.1, direction]["force_direct_N"][::5], "o", color=colour, ms=4,
                  mfc="none", label=f"{name}, solid elements")
    axes.set(xlabel="displacement of the journal (µm)", ylabel="direct force (N)", xlim=(0, 80), ylim=(0, None))
    axes.legend(frameon=False, fontsize=9)
    save(figure, page.parent / "fe_bearing.svg")
    pyplot.close(figure)
