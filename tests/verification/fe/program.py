"""Runs of the program that the pages compare with."""

import csv
import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


def run(program, command, case, folder, settings):
    """Runs `bumpfoil COMMAND` on a case of examples/ with some keys set; returns summary.json."""
    arguments = [str(part) for key, value in settings.items() for part in ("--set", f"{key}={value}")]
    subprocess.run([str(program), command, str(ROOT / "examples" / case), "-o", str(folder), "--force", "--quiet",
                    *arguments], check=True)
    return json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))


def column(file, name, by=None):
    """A column of a CSV file as numbers; with `by` one list for each value of that column."""
    values = {}
    with open(file, encoding="utf-8") as lines:
        for row in csv.DictReader(lines):
            values.setdefault(float(row[by]) if by else None, []).append(float(row[name]))
    return values if by else values[None]
