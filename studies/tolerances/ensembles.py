"""Runs the ensembles of docs/studies/tolerances.md, and writes the page from what they give.

Usage: ensembles.py PROGRAM FOLDER [--heights N] [--others N] [--page]

PROGRAM is bumpfoil; FOLDER takes the results of the ensembles, and those that are there already are gone on with where
the program is the same. N bearings are drawn for each of the two ensembles with scattered heights alone, and for each of the others. --page only
writes the page anew, from the data that are there.
"""

import argparse
import json
import subprocess
from pathlib import Path

import netCDF4

import page

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "studies/tolerances/ensembles.json"
PAGE = ROOT / "docs/studies/tolerances.md"
CASE = ROOT / "examples/gen1.toml"

#: What scatters in each, as keys of [montecarlo]. Normal distributions; the standard deviation of the others is about a
#: half of what a drawing would allow.
ENSEMBLES = {
    "heights_10um": ["bump_height.std=10 um"],
    "heights_20um": ["bump_height.std=20 um"],
    "heights_5um": ["bump_height.std=5 um"],
    "heights_10um_correlated": ["bump_height.std=10 um", "bump_height.correlation_length=20 mm"],
    "bump_foil_thickness": ["bump_foil_thickness.std=2.5 um"],
    "top_foil_thickness": ["top_foil_thickness.std=2.5 um"],
    "bump_length": ["bump_length.std=25 um"],
    "friction_top_bump": ["friction_top_bump.std=0.02"],
    "friction_bump_sleeve": ["friction_bump_sleeve.std=0.02"],
    "radial_clearance": ["radial_clearance.std=2.5 um"],
}
#: The two that the paper's question is about.
HEIGHTS = ("heights_10um", "heights_20um")

QUANTITIES = (
    "max_force_N",
    "loaded_stiffness_N_per_m",
    "tangent_stiffness_loading_N_per_m",
    "loop_energy_J",
    "loss_factor",
    "take_up_m",
    "initial_journal_load_N",
    "clearance_5N_m",
    "clearance_10N_m",
)
SENSITIVE = ("max_force", "loaded_stiffness", "clearance_5N")
STATISTICS = ("count", "undefined", "mean", "std", "standard_error", "p5", "p50", "p95")
#: N that a journal at the centre is pressed by, in all, where a bearing counts as pressing.
SQUEEZED = 1.0
#: Samples whose forces are kept: a test runs them again.
KEPT = 3


def settings(name):
    """Arguments of the program for an ensemble."""
    changes = [*(f"montecarlo.{key}" for key in ENSEMBLES[name]), "solver.name=events"]
    return [word for change in changes for word in ("--set", change)]


def command(program, name, folder, samples):
    return [str(program), "montecarlo", str(CASE), "-o", str(folder), "--samples", str(samples), *settings(name)]


def rounded(value, digits=6):
    """As many digits as the page could need."""
    return None if value is None else float(f"{value:.{digits}g}")


def name_of(direction):
    return {0: "+X", 90: "+Y", 180: "-X", 270: "-Y"}[round(float(direction))]


def first_forces(folder):
    """Maximum forces of the first samples, by direction."""
    with netCDF4.Dataset(folder / "ensemble.nc") as ensemble:
        return {
            name_of(direction): [rounded(float(force), 10) for force in ensemble["max_force"][:KEPT, i]]
            for i, direction in enumerate(ensemble["direction"][:])
        }


def data_of(folder):
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    directions = {}
    for direction, quantities in summary["statistics"].items():
        sensitivities = summary["sensitivities"][direction]
        directions[direction] = {
            "statistics": {
                name: {key: rounded(quantities[name][key]) for key in STATISTICS} for name in QUANTITIES
            },
            "sensitivities": {
                name: {
                    factor: [rounded(one, 3) for one in values] if isinstance(values, list) else rounded(values, 3)
                    for factor, values in sensitivities[name].items()
                }
                for name in SENSITIVE
            },
        }
    for name, forces in first_forces(folder).items():
        directions[name]["first_forces_N"] = forces
    with netCDF4.Dataset(folder / "ensemble.nc") as ensemble:
        # The journal is at the centre: its load there is the same for all directions.
        squeezed = int((ensemble["initial_journal_load"][:, 0] > SQUEEZED).sum())
    return {
        "samples": summary["samples"],
        "failed": len(summary["failed"]),
        "squeezed_at_the_centre": squeezed,
        "directions": directions,
    }


def nominal(program, folder):
    """The bearing as drawn."""
    arguments = [str(program), "cycle", str(CASE), "-o", str(folder), "--force", "--quiet", "--solver", "events"]
    subprocess.run(arguments, check=True)
    cycles = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["cycles"]
    return {
        name_of(cycle["direction_deg"]): {
            name: rounded(cycle[name]) for name in QUANTITIES
        }
        for cycle in cycles
    }


def measure(program, results, heights, others):
    data = {"nominal": nominal(program, results / "nominal"), "ensembles": {}}
    for name in ENSEMBLES:
        folder = results / name
        samples = heights if name in HEIGHTS else others
        arguments = [*command(program, name, folder, samples), "--quiet"]
        # What another version of the program has begun is begun anew.
        if subprocess.run([*arguments, "--resume"], stderr=subprocess.DEVNULL).returncode != 0:
            subprocess.run([*arguments, "--force"], check=True)
        data["ensembles"][name] = data_of(folder)
        print(f"{name}: {data['ensembles'][name]['samples']} bearings", flush=True)
    DATA.write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--heights", type=int, default=10_000)
    parser.add_argument("--others", type=int, default=1_000)
    parser.add_argument("--page", action="store_true")
    given = parser.parse_args()
    if not given.page:
        given.folder.mkdir(parents=True, exist_ok=True)
        measure(given.program.resolve(), given.folder.resolve(), given.heights, given.others)
    PAGE.write_text(page.text(json.loads(DATA.read_text(encoding="utf-8"))), encoding="utf-8")
