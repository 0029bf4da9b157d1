"""Results of the checks as JSON: a head and one row per line, numbers with eight digits."""

import json

import numpy as np


def plain(value):
    """Value without NumPy types, numbers shortened."""
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(entry) for entry in value]
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    if isinstance(value, (int, np.integer)):
        return int(value)
    if isinstance(value, (float, np.floating)):
        return float(f"{value:.8g}")
    return value


def write_records(file, head, rows):
    body = ",\n".join(json.dumps(plain(row)) for row in rows)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(plain(head))[:-1] + ',\n"rows": [\n' + body + "\n]}\n", encoding="utf-8")


def read_records(file):
    return json.loads(file.read_text(encoding="utf-8"))
