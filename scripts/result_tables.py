#!/usr/bin/python3
"""Writes the tables of variables in docs/results.md as the program describes them, each behind a comment that names it.

    scripts/result_tables.py PROGRAM [--check]

With --check it writes nothing: exit code 1 where the page is not what the program says.
"""

import difflib
import json
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).parent.parent / "docs/results.md"
#: A comment that names a table, and the table.
TABLE = re.compile(r"(?<=<!-- table: )([\w. -]+)( -->\n\n)(?:\|.*\n)+")


def variables_of(runs, number=0):
    """Of an experiment, as its small runs add them."""
    return runs[number]["variables"]


def is_dimension(variable):
    return variable["dims"] == [variable["name"]]


def over(*dims):
    """Variables over exactly these dimensions, no coordinates."""
    return lambda variable: variable["dims"] == list(dims) and not variable["coordinate"]


def over_none(variable):
    return not variable["dims"]


def table_rows(name, experiments):
    """The head of a table, and its rows."""
    command, _, part = name.partition(" ")
    runs = experiments[command]
    plain = variables_of(runs)
    if part == "csv":
        columns = [one for run in range(len(runs)) for one in variables_of(runs, run) if "csv" in one["tags"]]
        if command == "cycle":
            columns = [one for one in plain if one["name"] in ("direction", "increment")] + columns
        return ["column", "meaning"], [[f"`{one['key']}`", one["long_name"]] for one in columns]
    chosen = {
        "dimensions": is_dimension,
        "increments": over("direction", "increment"),
        "fields": lambda one: len(one["dims"]) == 3,
        "directions": lambda one: "direction" in one["dims"] and not {"increment", one["name"]} & set(one["dims"]),
        "geometry": lambda one: one["coordinate"] and not is_dimension(one) and "event" not in one["dims"],
        "events": lambda one: one["dims"] == ["event"],
        "states": lambda one: over("state")(one) and "csv" not in one["tags"],
        "film": lambda one: bool({"column", "row", "frequency"} & set(one["dims"])) and not is_dimension(one),
        "formed": over_none,
        "run": over_none,
        "speeds": lambda one: one["dims"] in (["speed"], ["bearing"], ["speed", "bearing"]) and not is_dimension(one),
        "motions": lambda one: {"mode", "station", "kind"} & set(one["dims"]) and not is_dimension(one),
        "steps": lambda one: one["dims"][:1] == ["step"],
        "revolutions": lambda one: one["dims"][:1] == ["revolution"] and not is_dimension(one),
        "spectra": lambda one: "spectrum" in one["dims"] and not is_dimension(one),
        "orbits": lambda one: True,
        "parameters": lambda one: {"parameter", "minimum"} & set(one["dims"]) and not is_dimension(one),
        "data": lambda one: "data" in one["dims"] and not is_dimension(one),
        "keys": lambda one: {"key", "aim", "limit"} & set(one["dims"]) and "point" not in one["dims"] and not is_dimension(one),
        "points": lambda one: {"point", "front"} & set(one["dims"]) and not is_dimension(one),
        "pads": lambda one: True,
        "rough": lambda one: "csv" not in one["tags"],
        "width": lambda one: True,
        "tilt": lambda one: True,
        "strips": lambda one: True,
        "slits": lambda one: True,
    }[part]
    variables = variables_of(runs, {"formed": 1, "orbits": 1, "pads": 2, "rough": 3, "width": 4, "tilt": 3, "strips": 4, "slits": 5}.get(part, 0))
    return ["variable", "dimensions", "units", "meaning"], [
        [f"`{one['name']}`", ", ".join(one["dims"]), one["unit"] or "flag", one["long_name"]]
        for one in variables
        if chosen(one)
    ]


def with_tables(text, experiments):
    """The page with its tables as they are to be."""

    def table(match):
        head, rows = table_rows(match.group(1), experiments)
        lines = [f"| {' | '.join(head)} |", "|---" * len(head) + "|", *(f"| {' | '.join(row)} |" for row in rows)]
        return match.group(1) + match.group(2) + "\n".join(lines) + "\n"

    return TABLE.sub(table, text)


def main():
    described = subprocess.run([sys.argv[1], "schema", "--results"], capture_output=True, check=True).stdout
    text = PAGE.read_text(encoding="utf-8")
    written = with_tables(text, json.loads(described)["experiments"])
    if "--check" not in sys.argv[2:]:
        PAGE.write_text(written, encoding="utf-8")
        return 0
    lines = text.splitlines(), written.splitlines()
    difference = list(difflib.unified_diff(*lines, "docs/results.md", "as described", lineterm=""))
    print("\n".join(difference) or f"{len(TABLE.findall(text))} tables are what the program describes.")
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main())
