"""Prints the reference of all variables and columns that results have, as Markdown: small ones are made, and asked."""

import warnings
from pathlib import Path

import bumpfoil

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
BESIDES = "cycle of several pads, besides"
INTRODUCTION = """\
# Variables of results

What is in the files of each command, as they say it themselves: made by running the program. [Results](../results.md) says what
it means.
"""


def small_results():
    push = {"directions": ["+X"], "steps": 2}
    gen1 = bumpfoil.Case(EXAMPLES / "gen1.toml", cycle=push)
    points = [[0.0, -40e-6], [0.0, -45e-6]]
    drawn = {"bump_height": {"distribution": "normal", "std": "1 um"}, "samples": 2}
    motion = {"directions": ["+X", "+Y"], "amplitudes": ["1 um"], "steps": 2, "loads": [[0, -50]], "frequencies": ["1 Hz"]}
    coarse = {"film": {"columns_per_pitch": 4, "rows": 4}, "equilibrium": {"loads": [[10, 0]], "steps": 1}}
    yield "cycle", bumpfoil.run_cycle(gen1, solver={"name": "events"})
    yield BESIDES, bumpfoil.run_cycle(EXAMPLES / "three_pads.toml", cycle=push)
    yield "strip", bumpfoil.run_strip(EXAMPLES / "strip.toml", strip={"steps": 2, "top_foil": True})
    yield "path", bumpfoil.run_path(gen1, points)
    yield "vibration", bumpfoil.run_vibration(gen1, vibration=motion)
    yield "equilibrium", bumpfoil.run_equilibrium(EXAMPLES / "running.toml", **coarse)
    yield "sweep", bumpfoil.run_sweep(gen1, {"friction.coefficient": [0.1, 0.2]})
    yield "montecarlo", bumpfoil.run_montecarlo(gen1, montecarlo=drawn)


def rows_of(result):
    dataset = result.to_xarray()
    for name in [*dataset.coords, *dataset.data_vars]:
        attributes = dataset[name].attrs
        unit = attributes.get("units", "")
        meaning = attributes["long_name"].replace("|", "\\|")
        if "flag_meanings" in attributes:
            pairs = zip(attributes["flag_values"], attributes["flag_meanings"].split())
            meaning += ": " + ", ".join(f"{value} `{word}`" for value, word in pairs)
        yield f"| `{name}` | {', '.join(dataset[name].dims)} | {unit} | {meaning} |"


def main():
    print(INTRODUCTION)
    listed = []
    warnings.simplefilter("ignore", bumpfoil.RunWarning)  # of increments that are as few as can be
    for title, result in small_results():
        (netcdf,) = (name for name in result.files if name.endswith(".nc"))
        print(f"## {title}\n\n`{netcdf}`:\n")
        rows = list(rows_of(result))
        if title == BESIDES:
            rows = [row for row in rows if row not in listed]
        listed += rows
        print("| variable | dimensions | unit | meaning |", "|---|---|---|---|", *rows, "", sep="\n")
        for name in result.files:
            if name.endswith(".csv"):
                columns = result.files[name].decode().splitlines()[0].split(",")
                print(f"Columns of `{name}`:", ", ".join(f"`{column}`" for column in columns), "\n")


if __name__ == "__main__":
    main()
