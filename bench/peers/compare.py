"""Times solvers beside each other and writes the ratios: results/bench/peers.json.

Usage: compare.py PEERS FOLDER

PEERS is bumpfoil_peers. CalculiX solves the strip of ten bumps with friction that the frame solves, once, in FOLDER.
"""

import json
import resource
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests/verification/fe"))
from calculix import run  # noqa: E402
from records import plain  # noqa: E402
from strip_deck import Strip, make_deck  # noqa: E402
from strips import read_deck_results  # noqa: E402


def children_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def with_ratios(rows):
    for row in rows:
        row["ratio_to_newton"] = row["seconds"] / rows[0]["seconds"]
    return rows


def main(peers, folder):
    # Threads of the linear algebra only get in each other's way in systems this small.
    measured = json.loads(subprocess.run([str(peers)], check=True, capture_output=True, text=True,
                                         env={"OPENBLAS_NUM_THREADS": "1"}).stdout)
    strip = Strip(bumps=10, friction=0.1)
    before = children_time()
    output = run(folder, strip.name, make_deck(strip))
    seconds = children_time() - before
    result = read_deck_results(folder, strip)
    measured["strip"].append({"name": "CalculiX", "seconds": seconds, "increments": result["increments"],
                              "converged": result["converged"], "iterations": output.count("iteration"),
                              "max_force_N": result["max_force_N"]})
    for rows in measured.values():
        with_ratios(rows)
    (folder / "peers.json").write_text(json.dumps(plain(measured), indent=1) + "\n", encoding="utf-8")
    for problem, rows in measured.items():
        for row in rows:
            print(f"{problem:8} {row['name']:28} {1e3 * row['seconds']:12.3f} ms {row['ratio_to_newton']:12.1f}")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve())
