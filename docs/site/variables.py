"""Prints the reference of all variables and columns that results have, as Markdown: small ones are made, and asked."""

import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import bumpfoil
from keys import meanings_of, rows_of_columns, rows_of_keys, rows_of_variables

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
INTRODUCTION = """\
# Variables of results

What is in the files of each command, as they say it themselves: made by running the program. [Results](../results.md) says what
it means. A column of a table and a key of `summary.json` with the name of a variable, and its unit after it, is that variable.
"""
FILM = {
    "film": {"columns_per_pitch": 4, "rows": 4, "h_lift_off": "1 um"},
    "equilibrium": {"loads": [[10, 0]], "steps": 1},
}
SCATTER = {
    "bump_height": "1 um",
    "bump_foil_thickness": "1 um",
    "top_foil_thickness": "1 um",
    "bump_length": "1 um",
    "friction_top_bump": 0.01,
    "friction_bump_sleeve": 0.01,
    "radial_clearance": "1 um",
}


def run_film(case):
    """Which the program alone has."""
    with tempfile.TemporaryDirectory() as folder:
        settings = ["equilibrium.speeds=['45000 rpm']", "equilibrium.positions=[['15 um', '0 um']]"]
        mesh = [f"film.{key}={value}" for key, value in FILM["film"].items() if key != "h_lift_off"]
        sets = [word for setting in [*settings, *mesh] for word in ("--set", setting)]
        subprocess.run([sys.executable, "-m", "bumpfoil", "film", case, "-o", folder, "--quiet", *sets], check=True)
        return bumpfoil.Result.load(folder)


def small_results():
    """Of each command, plain and with what adds variables to it."""
    push = {"directions": ["+X"], "steps": 2}
    gen1 = bumpfoil.Case(EXAMPLES / "gen1.toml", cycle=push)
    pads = bumpfoil.Case(EXAMPLES / "three_pads.toml", cycle=push)
    points = [[0.0, -40e-6], [0.0, -45e-6]]
    orbit = {"centre": ["0 um", "-40 um"], "semi_axes": ["2 um", "2 um"], "steps": 4, "orbits": 2}
    drawn = {name: {"std": deviation} for name, deviation in SCATTER.items()}
    drawn["sleeve_waviness"] = {"harmonic": 3, "amplitude": "1 um"}
    swept = {"friction.coefficient": [0.1, 0.2]}
    motion = {"directions": ["+X", "+Y"], "amplitudes": ["1 um"], "steps": 2, "loads": [[0, -50]], "frequencies": ["1 Hz"]}
    circles = {key: value for key, value in motion.items() if key != "directions"} | {"motion": "orbit"}
    yield "cycle", "", bumpfoil.run_cycle(gen1, solver={"name": "events"})
    yield "cycle", "foils whose bumps differ", bumpfoil.run_cycle(EXAMPLES / "graded.toml", cycle=push)
    yield "cycle", "several pads", bumpfoil.run_cycle(pads)
    yield "strip", "", bumpfoil.run_strip(EXAMPLES / "strip.toml", strip={"steps": 2, "top_foil": True})
    yield "path", "", bumpfoil.run_path(gen1, points)
    yield "path", "orbits", bumpfoil.run_path(gen1, path=orbit)
    yield "path", "several pads", bumpfoil.run_path(pads, points)
    yield "vibration", "", bumpfoil.run_vibration(gen1, vibration=motion)
    yield "vibration", "orbits", bumpfoil.run_vibration(gen1, vibration=circles)
    yield "vibration", "several pads", bumpfoil.run_vibration(pads, vibration=motion)
    yield "equilibrium", "", bumpfoil.run_equilibrium(EXAMPLES / "running.toml", limits=True, **FILM)
    yield "equilibrium", "several pads", bumpfoil.run_equilibrium(EXAMPLES / "running_pads.toml", **FILM)
    two_speeds = {"film": FILM["film"], "stability": {"speeds": ["12000 rpm", "14000 rpm"]}}
    yield "stability", "", bumpfoil.run_stability(EXAMPLES / "rotor.toml", **two_speeds)
    yield "unbalance", "", bumpfoil.run_unbalance(EXAMPLES / "rotor.toml", film=FILM["film"], unbalance=two_speeds["stability"])
    short = {"speed": {"to": "12000 rpm", "time": "11 ms"}, "steps_per_revolution": 20, "revolutions_per_spectrum": 1}
    yield "transient", "", bumpfoil.run_transient(EXAMPLES / "rotor.toml", film=FILM["film"], transient=short)
    yield "fit", "", bumpfoil.fit(EXAMPLES / "fit.toml", fit={"starts": 1})
    design = {"optimise": {"maximise": ["h_min"], "minimise": ["power"], "evaluations": 30, "starts": 1, "front": 1}}
    yield "optimise", "", bumpfoil.optimise(EXAMPLES / "optimise.toml", **design)
    yield "film", "", run_film(EXAMPLES / "gen1.toml")
    yield "sweep", "", bumpfoil.run_sweep(gen1, swept)
    yield "sweep", "vibrations", bumpfoil.run_sweep(gen1, swept, command="vibration", vibration=motion)
    yield "sweep", "running bearings", bumpfoil.run_sweep(EXAMPLES / "running.toml", swept, command="equilibrium", **FILM)
    yield "montecarlo", "", bumpfoil.run_montecarlo(gen1, samples=2, limits=["max_force > 1 N"], montecarlo=drawn)
    on_film = {"command": "equilibrium", "radial_clearance": {"std": "1 um"}}
    yield "montecarlo", "running bearings", bumpfoil.run_montecarlo(EXAMPLES / "running.toml", samples=2, montecarlo=on_film, **FILM)
    on_bearings = {"command": "stability", "radial_clearance": {"std": "1 um"}}
    unbalanced = {"film": FILM["film"], "unbalance": two_speeds["stability"]}
    of_unbalance = {"command": "unbalance", "radial_clearance": {"std": "1 um"}}
    yield "montecarlo", "unbalance", bumpfoil.run_montecarlo(EXAMPLES / "rotor.toml", samples=2, montecarlo=of_unbalance, **unbalanced)
    yield "montecarlo", "rotors", bumpfoil.run_montecarlo(EXAMPLES / "rotor.toml", samples=2, montecarlo=on_bearings, **two_speeds)


def list_new(name, head, rows, listed):
    """A table of the rows whose names and meanings were not listed before, if there are any."""
    new = [row for row in rows if (row[0], row[-1]) not in listed]
    listed |= {(row[0], row[-1]) for row in new}
    if new:
        bars = [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *new)]
        print(f"`{name}`:", "", *bars, "", sep="\n")


def main():
    print(INTRODUCTION)
    listed = {}
    warnings.simplefilter("ignore", bumpfoil.RunWarning)  # of increments that are as few as can be
    for command, besides, result in small_results():
        dataset = result.to_xarray()
        meanings = meanings_of(dataset)
        print(f"### {command} of {besides}, besides\n" if besides else f"## {command}\n")
        (netcdf,) = (name for name in result.files if name.endswith(".nc"))
        parts = {netcdf: (("variable", "dimensions", "unit", "meaning"), rows_of_variables(dataset))}
        for name in sorted(name for name in result.files if name.endswith(".csv")):
            columns = result.files[name].decode().splitlines()[0].split(",")
            parts[name] = (("column", "unit", "meaning"), rows_of_columns(columns, meanings))
        parts["summary.json"] = (("key", "unit", "meaning"), rows_of_keys(result.summary, meanings))
        for name, (head, rows) in parts.items():
            list_new(name, head, rows, listed.setdefault((command, name), set()))


if __name__ == "__main__":
    main()
