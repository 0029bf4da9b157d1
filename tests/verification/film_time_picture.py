"""Draws docs/verification/film_time.svg from what time_study prints.

Usage: time_study | film_time_picture.py
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "fe"))

from matplotlib import pyplot

from page import STYLES, save

PICTURE = Path(__file__).resolve().parents[2] / "docs/verification/film_time.svg"
QUARTER = 0.25  # revolutions, of the runs whose ends are compared


def rate(text):
    return complex(text.replace("i", "j"))


def read(lines):
    """Errors of growth rates, by BDF2 and by implicit Euler, and of ends: by name, points of step in revolutions and
    error."""
    growths, ends = {}, {}
    eigenvalue = 0j
    for line in lines:
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) == 1 and ": " in line:
            eigenvalue = rate(line.split(": ")[1].strip())
        elif len(cells) == 8:
            name = f"{float(cells[0]):,.0f} rpm, {float(cells[1]):g} N"
            for method, found in ((name, cells[3]), (f"{name}, implicit Euler", cells[7])):
                error = abs(rate(found) - eigenvalue) / abs(eigenvalue)
                growths.setdefault(method, []).append((1 / int(cells[2]), error))
        elif len(cells) == 5:
            steps = int(cells[2].split(" to ")[0])
            ends.setdefault(f"{cells[0]}, {cells[1]}", []).append((QUARTER / steps, float(cells[3])))
    return growths, ends


def plot(axes, errors, below):
    """Errors over the step, and a line of slope 2 below the series of this name."""
    for k, (name, points) in enumerate(errors.items()):
        color, line = STYLES[k]
        axes.loglog(*zip(*points), line, color=color, marker="o", markersize=4, label=name.replace("-", "\N{MINUS SIGN}"))
    (first, error), *_, (last, _) = errors[below]
    ends = (first, last)
    axes.loglog(ends, [0.5 * error * (step / first) ** 2 for step in ends], color="#888888", label="slope 2")
    axes.set_xlabel("step (revolutions)")
    steps = [step for step, _ in errors[below]]
    axes.minorticks_off()
    axes.set_xticks(steps, [f"1/{1 / step:.0f}" for step in steps])
    axes.set_ylim(bottom=axes.get_ylim()[0] / 20)  # room for the legend
    axes.legend(fontsize=8, loc="lower right")


def main():
    growths, ends = read(sys.stdin)
    figure, axes = pyplot.subplots(1, 2, figsize=(9.6, 4.0))
    plot(axes[0], growths, "12,000 rpm, 9.81 N")
    axes[0].set(title="Journal held: growth rate", ylabel="difference from the eigenvalue, part of it")
    plot(axes[1], ends, "disturbed film, equal")
    axes[1].set(title="End of a quarter of a revolution", ylabel="difference from half the step")
    save(figure, PICTURE)


if __name__ == "__main__":
    main()
