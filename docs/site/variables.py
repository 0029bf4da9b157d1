"""Prints the reference of all variables and columns that results have, as Markdown: small ones are made, and asked."""

import json
import subprocess
import sys
import tomllib
import warnings
from itertools import chain
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


def setting(text):
    """A key and its value, of the text that --set takes: a word needs no quotes there."""
    key, value = text.split("=", 1)
    try:
        return key, tomllib.loads(f"value = {value}")["value"]
    except tomllib.TOMLDecodeError:
        return key, value


def results_of_experiments():
    """Of each experiment, plain and with what adds variables to it: the runs that its schema is made of."""
    schema = subprocess.run([sys.executable, "-m", "bumpfoil", "schema", "--results"], capture_output=True, text=True, check=True)
    gen1 = bumpfoil.Case(EXAMPLES / "gen1.toml")
    for command, runs in json.loads(schema.stdout)["experiments"].items():
        plain = dict(map(setting, runs[0]["set"]))
        for run in runs:
            keys = dict(map(setting, run["set"]))
            besides = ", ".join(f"`{key}`" for key in keys if key not in plain)
            yield command, f"with {besides}" if besides else "", bumpfoil.run(command, gen1.replace(keys))


def results_of_many():
    """Of sweeps and ensembles."""
    gen1 = bumpfoil.Case(EXAMPLES / "gen1.toml", cycle={"directions": ["+X"], "steps": 2})
    drawn = {name: {"std": deviation} for name, deviation in SCATTER.items()}
    drawn["sleeve_waviness"] = {"harmonic": 3, "amplitude": "1 um"}
    swept = {"friction.coefficient": [0.1, 0.2]}
    motion = {"directions": ["+X", "+Y"], "amplitudes": ["1 um"], "steps": 2, "loads": [[0, -50]], "frequencies": ["1 Hz"]}
    two_speeds = {"speeds": ["12000 rpm", "14000 rpm"]}
    yield "sweep", "", bumpfoil.run_sweep(gen1, swept)
    yield "sweep", "of vibrations", bumpfoil.run_sweep(gen1, swept, command="vibration", vibration=motion)
    yield "sweep", "of running bearings", bumpfoil.run_sweep(EXAMPLES / "running.toml", swept, command="equilibrium", **FILM)
    yield "montecarlo", "", bumpfoil.run_montecarlo(gen1, samples=2, limits=["max_force > 1 N"], montecarlo=drawn)
    for command, of, case, tables in (
        ("equilibrium", "running bearings", "running.toml", FILM),
        ("unbalance", "unbalance", "rotor.toml", {"film": FILM["film"], "unbalance": two_speeds}),
        ("stability", "rotors", "rotor.toml", {"film": FILM["film"], "stability": two_speeds}),
    ):
        scatter = {"command": command, "radial_clearance": {"std": "1 um"}}
        yield "montecarlo", f"of {of}", bumpfoil.run_montecarlo(EXAMPLES / case, samples=2, montecarlo=scatter, **tables)


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
    for command, besides, result in chain(results_of_experiments(), results_of_many()):
        dataset = result.to_xarray()
        meanings = meanings_of(dataset)
        print(f"### {command} {besides}, besides\n" if besides else f"## {command}\n")
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
