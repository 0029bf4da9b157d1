"""Runs the states of docs/studies/free_end.md, and writes their numbers and its picture.

Usage: free_end.py PROGRAM FOLDER

PROGRAM is bumpfoil; FOLDER takes the results of its runs. Numbers go to studies/free_end/free_end.csv, the picture to
docs/images/free_end.svg.
"""

import csv
import subprocess
import sys
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "free_end"
from matplotlib import pyplot

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "studies/free_end/free_end.csv"
PICTURE = ROOT / "docs/images/free_end.svg"

RADIUS = 19.05  # mm, of the bearing
RATIOS = (0.998, 1.0, 1.0025, 1.005, 1.01, 1.015, 1.02, 1.05, 1.1)
COMMON = (
    "film.columns_per_pitch=6",
    "film.rows=8",
    "friction.coefficient=0",
    'gas.viscosity="1.85e-5 Pa s"',
    'equilibrium.paths="one"',
    'equilibrium.path="cold_start"',
)
LOADS = 'equilibrium.loads=[["10 N","0 N"],["50 N","0 N"],["100 N","0 N"]]'


def formed(ratio):
    return f'top_foil.formed_radius="{RADIUS * ratio:.6f} mm"'


def cases():
    """Names of the series, values that vary in each, and settings of the runs."""
    for speed in (45000, 20000, -45000):
        for ratio in RATIOS:
            yield f"radius, {speed} rpm", ratio, (formed(ratio), f'equilibrium.speeds=["{speed} rpm"]')
    for thickness in (0.102, 0.15, 0.2):
        for ratio in (1.0, 1.01):
            yield f"thickness, R_f/R {ratio}", thickness, (formed(ratio), f'top_foil.thickness="{thickness} mm"')
    for overhang in (0.1, 1.143, 2.286):
        for ratio in (1.0, 1.01):
            yield f"overhang, R_f/R {ratio}", overhang, (formed(ratio), f'top_foil.overhang="{overhang} mm"')
    for pressure in (101325, 101832):
        yield "inlet pressure, R_f/R 1", pressure, (formed(1.0), f'film.inlet_pressure="{pressure} Pa"')


def run(program, folder, settings):
    """Rows of equilibrium.csv; none if the program gives no state."""
    arguments = [word for setting in (*COMMON, LOADS, *settings) for word in ("--set", setting)]
    command = [program, "equilibrium", ROOT / "examples/running.toml", "-o", folder, "--force", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    table = folder / "equilibrium.csv"
    if not table.exists():
        print(done.stderr, file=sys.stderr)
        return []
    with table.open() as lines:
        rows = list(csv.DictReader(lines))
    table.unlink()
    return rows


def collect(program, folder):
    keys = ("load_x_N", "status", "growth_held", "hold_down_N", "h_min_m", "torque_N_m")
    return [
        {"series": series, "value": value, **{key: row[key] for key in keys}}
        for series, value, settings in cases()
        for row in run(program, folder, settings)
    ]


def draw(rows):
    figure, axes = pyplot.subplots(figsize=(6.4, 3.6))
    for load in ("10", "50", "100"):
        kept = [r for r in rows if r["series"] == "radius, 45000 rpm" and r["load_x_N"] == load and r["growth_held"]]
        flatter = [100 * (r["value"] - 1) for r in kept]
        axes.plot(flatter, [float(r["growth_held"]) for r in kept], marker="o", label=f"{load} N")
    axes.axhline(0, color="0.5", linewidth=0.8)
    axes.set(xlabel="formed flatter than the bearing (%)", ylabel="growth, journal held (per rad)")
    axes.legend(title="load")
    figure.tight_layout()
    figure.savefig(PICTURE, metadata={"Date": None})


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    rows = collect(program, folder)
    with DATA.open("w", newline="") as table:
        writer = csv.DictWriter(table, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    draw(rows)


if __name__ == "__main__":
    main()
