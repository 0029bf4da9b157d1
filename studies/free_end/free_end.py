"""Runs the states of docs/studies/free_end.md, and writes their numbers, its tables and its pictures.

Usage: free_end.py PROGRAM FOLDER

PROGRAM is bumpfoil; FOLDER takes the results of its runs. Numbers go to studies/free_end/free_end.csv, the tables into
the page, the pictures to docs/images/free_end*.svg.
"""

import csv
import re
import subprocess
import sys
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "free_end"
from matplotlib import pyplot

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "studies/free_end/free_end.csv"
PAGE = ROOT / "docs/studies/free_end.md"
PICTURES = ROOT / "docs/images"

RADIUS, CLEARANCE = 19.05, 31.8  # mm and um, of the bearing
RATIOS = (0.998, 1.0, 1.0025, 1.005, 1.01, 1.015, 1.02, 1.05, 1.1)
DIRECTIONS = {"+X": (1, 0), "+Y": (0, 1), "-X": (-1, 0), "-Y": (0, -1)}
LOADS = (10, 50, 100)  # N
COMMON = (
    "film.columns_per_pitch=6",
    "film.rows=8",
    "friction.coefficient=0",
    'gas.viscosity="1.85e-5 Pa s"',
    'equilibrium.paths="one"',
    'equilibrium.path="cold_start"',
)
# Three pads with these lobes (um), loads, and formed radii over that of the bearing: beyond, a pad with a lobe of 10 um
# presses on the journal at rest.
LOBES = (10, 0)
PAD_LOADS = (10, 20, 50)
PAD_RATIOS = (1.0, 1.0025, 1.005, 1.0075, 1.01, 1.0125)
PADS = [(lobe, direction, 45000) for lobe in LOBES for direction in ("+X", "-X")] + [(10, "+X", -45000)]
# A single pad of eight bumps, its middle at +X; positions of the journal along X over the clearance.
PLACES = (-0.6, -0.3, -0.1, 0.3, 0.6, 0.9)
PLACE_RATIOS = (1.0, 1.02, 1.1, 1.25)
PAD_ARC = 110.0065  # degrees


def formed(ratio):
    return f'top_foil.formed_radius="{RADIUS * ratio:.6f} mm"'


def at(speed):
    return f'equilibrium.speeds=["{speed} rpm"]'


def under(*loads, direction="+X"):
    x, y = DIRECTIONS[direction]
    return f"equilibrium.loads={[[load * x, load * y] for load in loads]}"


def pads_series(lobe, direction, speed):
    return f"three pads, lobe {lobe} um, {direction}, {speed} rpm"


def cases():
    """Series, value that varies in it, case file, settings of each run."""
    running = "running.toml"
    for speed in (45000, 20000, -45000):
        for ratio in RATIOS:
            yield f"radius, {speed} rpm", ratio, running, (formed(ratio), at(speed), under(*LOADS))
    for direction in ("+Y", "-Y"):
        for speed in (45000, -45000):
            for ratio in RATIOS[1:]:
                settings = (formed(ratio), at(speed), under(*LOADS, direction=direction))
                yield f"radius, {direction}, {speed} rpm", ratio, running, settings
    for thickness in (0.102, 0.15, 0.2):
        for ratio in (1.0, 1.01):
            settings = (formed(ratio), f'top_foil.thickness="{thickness} mm"', under(*LOADS))
            yield f"thickness, R_f/R {ratio}", thickness, running, settings
    for overhang in (0.1, 1.143, 2.286):
        for ratio in (1.0, 1.01):
            settings = (formed(ratio), f'top_foil.overhang="{overhang} mm"', under(*LOADS))
            yield f"overhang, R_f/R {ratio}", overhang, running, settings
    for pressure in (101325, 101832):
        settings = (formed(1.0), f'film.inlet_pressure="{pressure} Pa"', under(*LOADS))
        yield "inlet pressure, R_f/R 1.0", pressure, running, settings
    for lobe, direction, speed in PADS:
        lobes = [f'pad[{pad}].lobe="{lobe} um"' for pad in (1, 2, 3)]
        for ratio in PAD_RATIOS:
            for load in PAD_LOADS:  # each by itself: of several states the program says only of the first what flutters
                settings = (formed(ratio), at(speed), under(load, direction=direction), *lobes)
                yield pads_series(lobe, direction, speed), ratio, "gen3-three-pad.toml", settings
    for speed in (45000, 20000):
        for ratio in PLACE_RATIOS:
            places = [[place * CLEARANCE * 1e-6, 0] for place in PLACES]
            settings = ("bump_foil.bumps=8", f'bearing.weld_angle="{PAD_ARC / 2} deg"', formed(ratio), at(speed))
            settings += ("equilibrium.loads=[]", f"equilibrium.positions={places}")
            yield f"single pad, {speed} rpm", ratio, running, settings


def run(program, folder, case, settings):
    """Rows of equilibrium.csv, and what flutters in the first unstable of them; no rows if the program gives no state."""
    arguments = [word for setting in (*COMMON, *settings) for word in ("--set", setting)]
    command = [program, "equilibrium", ROOT / "examples" / case, "-o", folder, "--force", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    table = folder / "equilibrium.csv"
    if not table.exists():
        print(done.stderr, file=sys.stderr)
        return []
    with table.open() as lines:
        rows = list(csv.DictReader(lines))
    table.unlink()
    pad = re.search(r"the top foil of pad (\d) moves most", done.stderr)
    doubts = re.findall(r"load \((\S+), (\S+)\) N: whether the state is stable depends", done.stderr)
    doubtful = {(float(x), float(y)) for x, y in doubts}
    for row in rows:
        unstable = row["growth_held"] and float(row["growth_held"]) > 0
        row["flutters"] = f"pad {pad[1]}" if pad and unstable else ""
        if row.get("load_x_N"):
            row["force_x_N"] = ""  # it is the load
            row["doubtful"] = "yes" if (float(row["load_x_N"]), float(row["load_y_N"])) in doubtful else ""
    return rows


def collect(program, folder):
    keys = ("load_x_N", "load_y_N", "x_m", "status", "growth_held", "hold_down_N", "h_min_m", "torque_N_m", "force_x_N")
    return [
        {"series": series, "value": value, **{key: row.get(key, "") for key in (*keys, "flutters", "doubtful")}}
        for series, value, case, settings in cases()
        for row in run(program, folder, case, settings)
    ]


def states_of(rows, series):
    """Rows of a series by its value."""
    by_value = {}
    for row in rows:
        if row["series"] == series:
            by_value.setdefault(row["value"], []).append(row)
    return by_value


def table(head, lines):
    cells = (head, ["--:"] * len(head), *lines)
    return "\n".join(f"| {' | '.join(line)} |" for line in cells) + "\n"


def minus(text):
    return text.replace("-", "\N{MINUS SIGN}")


def growth_text(row):
    if not row["growth_held"]:
        return row["status"].replace("_", " ")
    what = f" ({row['flutters']})" if row["flutters"] else ""
    doubt = "?" if row["doubtful"] else ""
    return minus(f"{float(row['growth_held']):+.3f}") + what + doubt


def growths(states):
    return ", ".join(map(growth_text, states))


def numbers(states, key, scale, digits):
    return ", ".join(f"{scale * float(row[key]):{digits}}" if row[key] else "–" for row in states)


def radius_table(rows):
    loads = ", ".join(map(str, LOADS))
    head = ["R_f/R", f"growth: {loads} N", "hold-down (N)", "film (µm)", "torque (N mm)"]
    return table(head, [
        [f"{ratio:g}", growths(states), numbers(states, "hold_down_N", 1, ".2f"),
         numbers(states, "h_min_m", 1e6, "#.3g"), numbers(states, "torque_N_m", 1e3, ".2f")]
        for ratio, states in states_of(rows, "radius, 45000 rpm").items()
    ])  # fmt: skip


def ratio_table(rows, columns, ratios):
    """Growth over the formed radius, of series by the heads of their columns."""
    found = {head: states_of(rows, series) for head, series in columns.items()}
    return table(["R_f/R", *map(minus, found)], [[f"{ratio:g}", *(growths(one[ratio]) for one in found.values())] for ratio in ratios])


def means_table(rows):
    means = [
        ("unchanged", "thickness", 0.102),
        ("top foil 0.15 mm", "thickness", 0.15),
        ("top foil 0.2 mm", "thickness", 0.2),
        ("overhang 1.143 instead of 2.286 mm", "overhang", 1.143),
        ("overhang 0.1 mm", "overhang", 0.1),
        ("gas fed at 101,832 Pa, 507 Pa above ambient", "inlet pressure", 101832),
    ]
    lines = []
    for name, series, value in means:
        found = [states_of(rows, f"{series}, R_f/R {ratio}").get(value) for ratio in (1.0, 1.01)]
        lines.append([name, *(growths(states) if states else "not run" for states in found)])
    return table(["", "R_f = R", "R_f = 1.01 R"], lines)


def single_pad_table(rows):
    columns = {
        f"{speed:,} rpm: {ratio:g}": states_of(rows, f"single pad, {speed} rpm")[ratio]
        for speed in (45000, 20000)
        for ratio in PLACE_RATIOS
    }
    lines = [[minus(f"{place:g}"), *(growth_text(one[k]) for one in columns.values())] for k, place in enumerate(PLACES)]
    return table(["e", *columns], lines)


def tables(rows):
    """Those of the page, by name."""
    ways = [(direction, speed) for direction in ("+Y", "-Y") for speed in (45000, -45000)]
    return {
        "radius": radius_table(rows),
        "directions": ratio_table(
            rows,
            {"+X, -45,000 rpm": "radius, -45000 rpm"}
            | {f"{direction}, {speed:,} rpm": f"radius, {direction}, {speed} rpm" for direction, speed in ways},
            (1.0, 1.0025, 1.01, 1.02, 1.05, 1.1),
        ),
        "means": means_table(rows),
        "pads": ratio_table(
            rows,
            {f"lobe {lobe} µm, {direction}, {speed:,} rpm": pads_series(lobe, direction, speed) for lobe, direction, speed in PADS},
            PAD_RATIOS,
        ),
        "single": single_pad_table(rows),
    }


def fill(page, written):
    """Writes tables into the page, each between a comment that names it and one that ends it."""
    text = page.read_text(encoding="utf-8")
    for name, lines in written.items():
        between = re.compile(rf"(<!-- table:{name} -->\n).*?(<!-- /table -->)", re.DOTALL)
        text, count = between.subn(lambda mark: mark[1] + lines + mark[2], text)
        if count != 1:
            sys.exit(f"{page} has no table {name}")
    page.write_text(text, encoding="utf-8")


def plot_growth(axes, states, choose, label, **style):
    """Growth over the forming, of the state that is chosen of each run."""
    chosen = {ratio: choose(rows) for ratio, rows in states.items()}
    kept = [(100 * (ratio - 1), float(row["growth_held"])) for ratio, row in chosen.items() if row["growth_held"]]
    axes.plot(*zip(*kept), marker="o", label=label, **style)


def finish(figure, axes, name):
    for one in axes:
        one.axhline(0, color="0.5", linewidth=0.8)
    axes[0].set_ylabel("growth, journal held (per rad)")
    figure.tight_layout()
    figure.savefig(PICTURES / name, metadata={"Date": None})


def draw(rows):
    figure, axes = pyplot.subplots(figsize=(6.4, 3.6))
    for k, load in enumerate(LOADS):
        plot_growth(axes, states_of(rows, "radius, 45000 rpm"), lambda states: states[k], f"{load} N")
    axes.set(xlabel="formed flatter than the bearing (%)")
    axes.legend(title="load")
    finish(figure, [axes], "free_end.svg")

    figure, axes = pyplot.subplots(figsize=(8.4, 3.6))
    for color, direction in zip(("C0", "C1", "C2"), ("+X", "+Y", "-Y")):
        for speed, line in ((45000, "-"), (-45000, "--")):
            series = f"radius, {speed} rpm" if direction == "+X" else f"radius, {direction}, {speed} rpm"
            label = f"{minus(direction)}, gas enters at the {'free end' if speed > 0 else 'weld'}"
            plot_growth(axes, states_of(rows, series), lambda states: states[1], label, color=color, linestyle=line)
    axes.set(xlabel="formed flatter than the bearing (%)")
    axes.legend(title=f"load {LOADS[1]} N", loc="center left", bbox_to_anchor=(1.0, 0.5))
    finish(figure, [axes], "free_end_directions.svg")

    figure, axes = pyplot.subplots(1, 2, figsize=(9.6, 3.6))
    for color, direction in zip(("C0", "C1"), ("+X", "-X")):
        for lobe, line in zip(LOBES, ("-", "--")):
            states = states_of(rows, pads_series(lobe, direction, 45000))
            on = "on a pad" if direction == "+X" else "between pads"
            plot_growth(axes[0], states, lambda states: states[0], f"{on}, lobe {lobe} µm", color=color, linestyle=line)
    axes[0].set(xlabel="formed flatter than the bearing (%)", title=f"Three pads, {PAD_LOADS[0]} N")
    axes[0].legend(fontsize="small")
    for ratio, states in states_of(rows, "single pad, 45000 rpm").items():
        kept = [(place, float(row["growth_held"])) for place, row in zip(PLACES, states) if row["growth_held"]]
        axes[1].plot(*zip(*kept), marker="o", label=f"{100 * (ratio - 1):.3g} %")
    axes[1].set(xlabel="journal towards the pad, over the clearance", title="One pad")
    axes[1].legend(title="formed flatter", fontsize="small")
    finish(figure, axes, "free_end_pads.svg")


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    rows = collect(program, folder)
    with DATA.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    fill(PAGE, tables(rows))
    draw(rows)


if __name__ == "__main__":
    main()
