"""Measures what threads and ranks bring an ensemble; prints the tables of docs/scaling.md.

Usage: scaling.py PROGRAM [MPIRUN]

An idle machine has every run take the cores that it asks for: then wall times tell. On a busy one they tell how busy it
is; the processor time of a sample still says whether threads or ranks cost anything, and how much of the time that they
had they were at work.
"""

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CASE = ROOT / "examples/tolerances.toml"
SAMPLES = 5000
#: By turns, so that a machine that gets busier meanwhile treats all alike.
ROUNDS = 3


def seconds(command):
    """Wall and processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.monotonic()
    subprocess.run(command, check=True, capture_output=True)
    wall = time.monotonic() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def ensemble(program, folder, threads, launcher=()):
    changes = ["--set", "solver.name=events", "--samples", str(SAMPLES), "--threads", str(threads), "--force"]
    return [*launcher, str(program), "montecarlo", str(CASE), "-o", str(folder), *changes]


def main(program, mpirun):
    cores = os.cpu_count()
    with tempfile.TemporaryDirectory() as folder:
        runs = {f"{n} thread{'s' * (n > 1)}": ensemble(program, folder, n) for n in (1, cores)}
        if mpirun:
            for n in (1, cores):
                launcher = [mpirun, "--allow-run-as-root", "--bind-to", "none", "-n", str(n)]
                runs[f"{n} rank{'s' * (n > 1)}"] = ensemble(program, folder, 1, launcher)
        times = {name: [] for name in runs}
        for _ in range(ROUNDS):
            for name, command in runs.items():
                times[name].append(seconds(command))
    print(f"| {SAMPLES} samples, `events` | wall time | samples/s | against one | processor time | against one |")
    print("|---|--:|--:|--:|--:|--:|")
    for name, measured in times.items():
        wall, busy = min(wall for wall, _ in measured), min(busy for _, busy in measured)
        one = times["1 thread" if "thread" in name else "1 rank"]
        faster = min(wall for wall, _ in one) / wall
        dearer = busy / min(busy for _, busy in one)
        print(f"| {name} | {wall:.2f} s | {SAMPLES / wall:.0f} | {faster:.2f} x | {busy:.2f} s | {dearer:.2f} x |")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), sys.argv[2] if len(sys.argv) > 2 else None)
