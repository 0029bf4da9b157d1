"""Runs of the program that the pages compare with."""

import csv
import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


def run(program, command, folder, settings):
    """Runs `bumpfoil COMMAND` on the reference bearing with some keys set; returns summary.json."""
    arguments = [str(part) for key, value in settings.items() for part in ("--set", f"{key}={value}")]
    subprocess.run([str(program), command, str(ROOT / "examples/gen1.toml"), "-o", str(folder), "--force", "--quiet",
                    *arguments], check=True)
    return json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))


def cycle_rows(folder):
    """Rows of cycle.csv as numbers, by direction (degrees)."""
    rows = {}
    with open(Path(folder) / "cycle.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            rows.setdefault(round(float(row["direction_deg"])) % 360, []).append(row)
    return rows
