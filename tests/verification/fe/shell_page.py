"""docs/verification/fe_shells.md: the program against shells over the whole width."""

import json
import subprocess

import numpy as np
from matplotlib import pyplot

from page import STYLES, fill, percent, save, table
from program import ROOT
from records import read_records

SHOWN = (0.0, 0.5, 0.9, 1.0)  # zeta
ZETA_EDGE = 0.9  # up to here the layer at the side edge does not count
KEYS = {"crest_w_m": "crests", "span_w_m": "between them"}


def run_program(study):
    """Rows of the program, by case, feet and modes."""
    rows = json.loads(subprocess.run([str(study)], cwd=ROOT / "tests", check=True, capture_output=True).stdout)
    return {(row["case"], row["feet"], row["modes"]): row for row in rows}


def micrometres(values):
    return ", ".join(f"{1e6 * value:.2f}" for value in values).replace("-", "−")


def errors(own, shells, zeta):
    """Least and largest error where zeta is as far out as given, in um."""
    difference = 1e6 * (np.array(own) - shells)[:, zeta]
    return f"{difference.min():.2f} to {difference.max():+.2f}".replace("-", "−")


def write(study, data, page):
    measured = read_records(data)
    zeta = np.array(measured["zeta"])
    shells = {(row["case"], row["feet"], row["refined"]): row for row in measured["rows"]}
    own = run_program(study)

    displacements, moments = [], []
    inside, edge = zeta <= ZETA_EDGE, zeta == 1.0
    for case, feet in (("held crests", "none"), ("nine bumps", "sliding"), ("nine bumps", "stuck")):
        for key, place in KEYS.items():
            fine = shells[case, feet, 2]
            if key not in fine:
                continue
            w = np.array(fine[key])
            # The line that is displaced most.
            line = np.argmax(w[:, 0])
            uniform, parabola = own[case, feet, 1][key], own[case, feet, 3][key]
            displacements.append([
                case, feet if feet != "none" else "", place,
                micrometres(w[line, np.isin(zeta, SHOWN)]),
                f"{1e6 * np.abs(np.array(shells[case, feet, 1][key]) - w).max():.2f}",
                errors(uniform, w, inside), errors(uniform, w, edge),
                errors(parabola, w, inside), errors(parabola, w, edge)])
    for feet in ("sliding", "stuck"):
        fine, coarse = shells["tilt", feet, 2]["moments_N_m"], shells["tilt", feet, 1]["moments_N_m"]
        program = own["tilt", feet, 3]["moments_N_m"]
        for bump in range(len(fine) + 1):
            part = slice(bump, bump + 1) if bump < len(fine) else slice(None)
            shell, coarser, frame = (sum(values[part]) for values in (fine, coarse, program))
            moments.append([feet, bump + 1 if bump < len(fine) else "all", f"{1e3 * shell:.2f}",
                            percent(coarser, shell), f"{1e3 * frame:.2f}", percent(frame, shell)])
    fill(page, {
        "displacements": table(["foils", "feet", "place", "shells, ζ = 0, 0.5, 0.9, 1 (µm)", "coarse mesh (µm)",
                                "uniform, to ζ = 0.9", "ζ = 1", "parabola, to ζ = 0.9", "ζ = 1"], displacements),
        "moments": table(["feet", "bump", "shells (N mm)", "coarse mesh %", "program (N mm)", "%"], moments)})
    plot(zeta, shells, own, page.with_suffix(".svg"))


def plot(zeta, shells, own, file):
    """Nine bumps across the half width: the crest in the middle and the span behind it."""
    figure, axes = pyplot.subplots(1, 2, figsize=(10.5, 4.4), sharey=True)
    smooth = np.linspace(0, 1, 50)
    for axis, feet in zip(axes, ("sliding", "stuck")):
        for (key, text), (colour, _) in zip((("span_w_m", "behind bump 5"), ("crest_w_m", "crest 5")), STYLES):
            def line(row):
                return 1e6 * np.array(row[key])[4]
            axis.plot(zeta, line(shells["nine bumps", feet, 2]), "o", color=colour, ms=5, mfc="none",
                      label=f"{text}, shells")
            for modes, style, name in ((3, "-", "parabola"), (1, ":", "uniform")):
                curve = np.polyfit(zeta, line(own["nine bumps", feet, modes]), 2)
                axis.plot(smooth, np.polyval(curve, smooth), style, color=colour, lw=1.6, label=f"{text}, {name}")
        axis.set(xlabel="ζ = 2 z / L", title=f"feet {feet}", xlim=(0, 1.02), ylim=(0, None))
    axes[0].set_ylabel("radial displacement of the top foil (µm)")
    axes[1].legend(frameon=False, fontsize=9)
    save(figure, file)
    pyplot.close(figure)
