#!/usr/bin/python3
"""Compare the results of two builds of the program, for changes that must not change numbers.

    scripts/compare_programs.py OLD NEW [--examples DIR] [--drawn N] [--seed S] [--tolerance T]

Runs every command on each case in examples/ that can take it, and as many of them with keys drawn at random, by both
programs. Compares exit codes, messages, and of every number in the files of netCDF, CSV, TOML and summary.json the
difference over the largest of its quantity. Prints a line per run; exit code 1 where one differs by more than the
tolerance. With --zero a quantity whose largest is less than that counts as zero (in SI units), as do residuals: other
compilers round otherwise.
"""

import argparse
import csv
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

EXAMPLES = Path(__file__).parent.parent / "examples"
# Of a run, not of its results.
NOT_COMPARED = {"run_id", "version", "commit", "wall_time_s", "wall_time", "files", "xxh3_128", "threads", "seconds"}
# Short runs: what is compared are numbers, not meshes.
SHORT = {
    "cycle": ["cycle.steps=20"],
    "strip": ["strip.steps=20"],
    "equilibrium": ["film.columns_per_pitch=4", "film.rows=6", "equilibrium.paths=one"],
    "stability": ["film.columns_per_pitch=4", "film.rows=4"],
    "unbalance": ["film.columns_per_pitch=4", "film.rows=4"],
    "transient": ["film.columns_per_pitch=4", "film.rows=4", 'transient.speed={from="12000 rpm", to="11000 rpm", time="20 ms"}'],
    "montecarlo": ["montecarlo.samples=4", "film.columns_per_pitch=4", "film.rows=4"],
    "path": ['path.centre=["0 um", "-45 um"]', 'path.semi_axes=["10 um", "5 um"]', "path.steps=20", "path.orbits=1"],
    "film": [
        "film.columns_per_pitch=4",
        "film.rows=6",
        'equilibrium.speeds=["45000 rpm"]',
        'equilibrium.positions=[["15 um", "-4 um"]]',
    ],
}


def commands_of(program, case):
    """The commands that can run a case, by the last lines of `check`, with their options: those that it has tables for,
    sweeps of them, and path and film, whose tables are given by SHORT."""
    done = subprocess.run([program, "check", case], capture_output=True, text=True, check=True)
    able = re.findall(r"^# (\w+): ok", done.stdout, re.MULTILINE)
    schema = subprocess.run([program, "schema"], capture_output=True, text=True, check=True)
    tables = json.loads(schema.stdout)["properties"]
    swept, sampled = (tables[name]["properties"]["command"]["enum"] for name in ("optimise", "montecarlo"))
    swept.remove("montecarlo")  # which [optimise] runs, too
    commands = [[name] for name in able]
    commands += [["sweep", "--command", name, "--over", "friction.coefficient=[0.05, 0.3]"] for name in able if name in swept]
    if "montecarlo" in able:
        commands += [["montecarlo", "--set", f"montecarlo.command={name}"] for name in sampled if name in able]
    if "cycle" in able:
        commands.append(["path"])
        if "equilibrium" not in able and "[[pad]]" not in case.read_text():
            commands.append(["film"])
    return commands


def run_by(command):
    """The command that does the work: that which a sweep repeats."""
    return command[command.index("--command") + 1] if "--command" in command else command[0]


def drawn_keys(rng, command):
    """Keys of a bearing of its own."""
    keys = [
        f"friction.coefficient={rng.choice([0.0, rng.uniform(0.02, 0.5)])}",
        f"bump_foil.thickness={rng.uniform(80, 130)} um",
        f"top_foil.thickness={rng.uniform(80, 200)} um",
    ]
    if command in ("cycle", "path", "vibration", "equilibrium", "film"):
        keys.append(f"bearing.radial_clearance={rng.uniform(20, 45)} um")
    if command == "cycle":
        keys.append(f"cycle.amplitude={rng.uniform(40, 90)} um")
        keys.append(f'cycle.directions=["{rng.uniform(0, 360)} deg"]')
        keys.append(f"solver.name={rng.choice(['events', 'newton'])}")
    if command == "equilibrium":
        keys.append(f'equilibrium.speeds=["{rng.uniform(2e4, 6e4)} rpm"]')
        angle, load = rng.uniform(0, 6.28), rng.uniform(10, 80)
        keys.append(f'equilibrium.loads=[["{load * np.cos(angle)} N", "{load * np.sin(angle)} N"]]')
    return keys


def run(program, command, case, keys, folder):
    """Exit code and errors."""
    line = [program, *command, str(case), "-o", str(folder), "--quiet"]
    for key in keys:
        line += ["--set", key]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr.replace(str(folder), "DIR")


def numbers_of(value, name=""):
    """Every number of a JSON value, by name; lists of the same keys go together."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in NOT_COMPARED:
                yield from numbers_of(inner, f"{name}.{key}")
    elif isinstance(value, list):
        for inner in value:
            yield from numbers_of(inner, name)
    elif isinstance(value, (bool, str)):
        yield name, str(value)
    else:
        yield name, np.nan if value is None else float(value)


def quantities_of(folder):
    """All numbers and texts of the files of a run, as arrays by name."""
    found = {}
    summary = folder / "summary.json"
    if summary.exists():
        for name, value in numbers_of(json.loads(summary.read_text())):
            found.setdefault(f"summary{name}", []).append(value)
    for path in sorted(folder.glob("*.nc")):
        with netCDF4.Dataset(path) as file:
            file.set_auto_mask(False)
            for name, variable in file.variables.items():
                if name not in NOT_COMPARED:
                    found[f"{path.name}:{name}"] = np.asarray(variable[...]).ravel().tolist()
    for path in sorted(folder.glob("*.csv")):
        with path.open(newline="") as file:
            for row in csv.DictReader(file):
                for name, text in row.items():
                    if name not in NOT_COMPARED:
                        found.setdefault(f"{path.name}:{name}", []).append(number_or_text(text))
    for path in sorted(folder.glob("*.toml")):
        lines = [line for line in path.read_text().splitlines() if not line.startswith(("#", "source =", "run_id ="))]
        # Tables and keys, and the numbers between them, of each key by itself.
        for line in lines:
            key = line.split("=")[0].strip()
            found.setdefault(f"{path.name}:{key}", []).extend(map(number_or_text, re.split(r"[\s,\[\]]+", line)))
    return found


def number_or_text(text):
    """A cell of a table."""
    try:
        return float(text or "nan")
    except ValueError:
        return text


def difference(old, new, zero, added):
    """The largest difference over the largest of its quantity, and the quantity; infinite where texts differ. Names that
    the new program alone knows go to `added`."""
    worst, where = 0.0, ""
    for name in sorted(set(old) | set(new)):
        if name not in old:
            added.add(name)
            continue
        a, b = old.get(name), new.get(name)
        if a == b or (zero > 0.0 and "residual" in name):
            continue
        if a is None or b is None or len(a) != len(b):
            return float("inf"), name
        if any(p != q for p, q in zip(a, b) if isinstance(p, str) or isinstance(q, str)):
            return float("inf"), name
        x, y = (np.array([number for number in numbers if not isinstance(number, str)], dtype=float) for numbers in (a, b))
        if not np.array_equal(np.isnan(x), np.isnan(y)):
            return float("inf"), name
        largest = np.max(np.abs(x[~np.isnan(x)]), initial=0.0)
        if max(largest, np.max(np.abs(y[~np.isnan(y)]), initial=0.0)) < zero:
            continue
        relative = np.max(np.abs(x - y)[~np.isnan(x)], initial=0.0) / (largest if largest > 0.0 else 1.0)
        if relative > worst:
            worst, where = float(relative), name
    return worst, where


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--examples", type=Path, default=EXAMPLES, help="folder of cases, such as that of the old program")
    parser.add_argument("--drawn", type=int, default=100, help="cases drawn at random (100)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tolerance", type=float, default=1e-9, help="of the largest of each quantity (1e-9)")
    parser.add_argument("--zero", type=float, default=0.0, help="what is smaller counts as zero (0)")
    options = parser.parse_args()

    known = [(case, command) for case in sorted(options.examples.glob("*.toml")) for command in commands_of(options.old, case)]
    rng = random.Random(options.seed)
    runs = [(case, command, SHORT.get(run_by(command), [])) for case, command in known]
    for _ in range(options.drawn):
        case, command = rng.choice(known)
        runs.append((case, command, SHORT.get(run_by(command), []) + drawn_keys(rng, run_by(command))))
    same = within = beyond = 0
    added = set()
    for number, (case, command, keys) in enumerate(runs):
        with tempfile.TemporaryDirectory() as folder:
            folders = [Path(folder) / name for name in ("old", "new")]
            ends = [run(program, command, case, keys, where) for program, where in zip((options.old, options.new), folders)]
            worst, where = difference(*map(quantities_of, folders), options.zero, added)
        if ends[0] != ends[1]:
            worst, where = float("inf"), f"exit code or errors: {ends}"
        same += worst == 0.0
        within += 0.0 < worst <= options.tolerance
        beyond += worst > options.tolerance
        verdict = "same" if worst == 0.0 else f"{worst:.2g} in {where}"
        name = " ".join(command[:3:2])
        print(f"{number:4} {case.stem:18} {name:18} exit {ends[0][0]}  {verdict}", flush=True)
    if added:
        print("in the results of the new program alone:", ", ".join(sorted(added)))
    print(f"{len(runs)} runs: {same} the same, {within} within {options.tolerance:g}, {beyond} beyond")
    return 1 if beyond > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
