"""docs/verification/fe_strip.md: the program against strips of solid elements."""

import numpy as np
from matplotlib import pyplot

import program
from page import STYLES, fill, percent, save, table
from records import read_records


def run_program(binary, folder, row, model, geometry="linear"):
    """Summary of the strip of a record, with the forces of all increments."""
    settings = {"strip.bumps": row["bumps"], "strip.top_foil": str(row["top_foil"]).lower(), "strip.displacement": 20e-6,
                "strip.steps": 20, "strip.cycles": 1, "friction.coefficient": row["friction"],
                "bump_foil.model": model, "bump_foil.geometry": geometry}
    if model == "truss":
        settings["bump_foil.weld_at"] = "mid_flat"  # the only weld that it knows
    cycle = program.run(binary, "strip", "strip.toml", folder, settings)["cycles"][0]
    cycle["force_N"] = program.column(folder / "strip.csv", "force_direct_N")
    return cycle


def newtons(row):
    return f"{row['max_force_N']:.1f}" if row and row["converged"] else "failed" if row else ""


def millijoules(row):
    if row.get("jumps"):
        return f"{row['jumps']} jumps"
    return f"{1e3 * row['loop_energy_J']:.3f}" if row["friction"] else "0"


def load_deviation(cycle, row):
    loads, reference = np.array(cycle["bump_loads_N"]), np.array(row["bump_loads_N"])
    return f"{100 * np.abs(loads / reference - 1).max():.1f}"


def write(binary, folder, data, page):
    measured = read_records(data)["rows"]
    records = {(row["bumps"], row["friction"], row["top_foil"], row["displacements"], row["contact"]): row
               for row in measured}
    small, large, covered = [], [], []
    for row in measured:
        key = row["bumps"], row["friction"], row["top_foil"]
        if (row["displacements"], row["contact"]) != ("small", "nodes"):
            continue
        own = records.get((*key, "small", "surface"))
        own_large = records.get((*key, "large", "surface"))
        frame = run_program(binary, folder, row, "frame")
        bent = run_program(binary, folder, row, "frame", "nonlinear")
        start = [row["bumps"], row["friction"]]
        if row["top_foil"]:
            covered.append([*start, newtons(row), newtons(own), newtons(frame),
                            percent(frame["max_force_N"], row["max_force_N"]), newtons(own_large), newtons(bent),
                            percent(bent["max_force_N"], own_large["max_force_N"]) if own_large else ""])
            continue
        truss = run_program(binary, folder, row, "truss")
        loop = {**frame, "friction": row["friction"]}
        small.append([*start, newtons(own), newtons(row), percent(row["max_force_N"], own["max_force_N"]),
                      newtons(frame), percent(frame["max_force_N"], own["max_force_N"]), load_deviation(frame, own),
                      percent(truss["max_force_N"], own["max_force_N"]), millijoules(own), millijoules(row),
                      millijoules(loop)])
        large.append([*start, newtons(own_large), newtons(bent), percent(bent["max_force_N"], own_large["max_force_N"]),
                      load_deviation(bent, own_large), percent(frame["max_force_N"], own_large["max_force_N"]),
                      millijoules(own_large), millijoules({**bent, "friction": row["friction"]})])
        if key == (10, 0.1, False):
            plot(frame, bent, row, own, own_large, page.parent / "fe_strip.svg")
    start = ["bumps", "f"]
    fill(page, {
        "small": table([*start, "CalculiX (N)", "at nodes (N)", "%", "frame (N)", "%", "loads %", "truss %",
                        "CalculiX (mJ)", "at nodes (mJ)", "frame (mJ)"], small),
        "large": table([*start, "CalculiX (N)", "frame (N)", "%", "loads %", "linear frame %", "CalculiX (mJ)",
                        "frame (mJ)"], large),
        "covered": table([*start, "at nodes (N)", "CalculiX (N)", "frame (N)", "% of nodes", "CalculiX, large (N)",
                          "frame, large (N)", "%"], covered)})


def plot(frame, bent, nodes, own, own_large, file):
    """Loops and bump loads of ten bumps with friction 0.1."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10.5, 4.4))
    (blue, _), (red, _) = STYLES[:2]
    for cycle, record, colour, text in ((frame, own, blue, "small displacements"), (bent, own_large, red, "large")):
        micrometres = 1e6 * np.array(nodes["displacement_m"])
        left.plot(micrometres, cycle["force_N"], "-", color=colour, lw=1.6, label=f"frame, {text}")
        left.plot(1e6 * np.array(record["displacement_m"]), record["force_N"], "o", color=colour, ms=4, mfc="none",
                  label=f"CalculiX, {text}")
    left.set(xlabel="compression (µm)", ylabel="force of the plate (N)", xlim=(0, 20.5), ylim=(0, None))
    left.legend(frameon=False, fontsize=9)
    bumps = np.arange(1, 11)
    right.plot(bumps, frame["bump_loads_N"], "-", color=blue, lw=1.6, label="frame")
    right.plot(bumps, own["bump_loads_N"], "o", color=blue, ms=5, mfc="none", label="CalculiX")
    right.plot(bumps, nodes["bump_loads_N"], "x", color="#1a7f37", ms=5, label="contact at nodes")
    right.set(xlabel="bump, from the weld", ylabel="load at 20 µm, small displacements (N)", xticks=bumps,
              ylim=(0, None))
    right.legend(frameon=False, fontsize=9)
    save(figure, file)
    pyplot.close(figure)
