"""Pictures that gnuplot draws of the studies of `bumpfoil reproduce`: all of every curve is in them, and all can be read."""

import csv
import functools
import itertools
import re
import subprocess
from typing import NamedTuple

import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

#: Panels of the picture of every study.
PANELS = {"figure10": 4, "figure11": 8, "figure12": 8, "figure13": 12, "figure14": 12, "figure15": 2, "figure16": 18,
          "top_foil": 4, "scatter": 4, "height_reference": 4, "friction": 4, "increments": 2, "clearance": 4}

#: Where loops are shown from (um), as the journal touches nothing before.
CUT = {"figure12": 20, "height_reference": 30}


class Word(NamedTuple):
    """A text of a picture, with the place of its ink."""

    text: str
    left: float
    top: float
    right: float
    bottom: float
    size: float


# Most words stand in several panels, and to find the ends of their curves takes longer than all else here.
@functools.cache
def ink(text, size):
    """The box of a text that starts at the origin."""
    return TextPath((0, 0), text, size=size, prop=FontProperties(family="DejaVu Sans")).get_extents()


def words(picture):
    found = re.findall(r'<g transform="translate\(([\d.]+),([\d.]+)\)( rotate\(270\))?"[^>]*font-size="([\d.]+)"'
                       r'\s*text-anchor="(\w+)">\s*<text>(.*?)</text>', picture, re.DOTALL)
    for x, y, turned, size, anchor, inside in found:
        text = re.sub(r"<[^>]*>", "", inside).strip()
        if not text:
            continue
        box = ink(text, float(size))
        start = {"start": 0, "middle": -0.5 * box.width, "end": -box.width}[anchor]
        if turned:
            place = float(x) - box.y1, float(y) - start - box.width, float(x) - box.y0, float(y) - start
        else:
            place = float(x) + start, float(y) - box.y1, float(x) + start + box.width, float(y) - box.y0
        yield Word(text, *place, min(map(float, [size, *re.findall(r'font-size="([\d.]+)"', inside)])))


def test_every_study_has_one(studies):
    assert sorted(path.name for path in studies.iterdir()) == sorted(PANELS)


@pytest.mark.parametrize("study", PANELS)
def test_can_be_read(studies, study):
    picture = (studies / study / "picture.svg").read_text(encoding="utf-8")
    width, height = (float(size) for size in re.search(r'<svg\s+width="(\d+)" height="(\d+)"', picture).groups())
    assert study == "figure16" or height / width <= 234 / 190  # on a page
    written = list(words(picture))
    assert min(word.size for word in written) * 190 / width / 25.4 * 72 >= 7
    letters = {word.text[:3]: word.top for word in written if re.match(r"\([a-z]\)", word.text)}
    assert list(letters) == [f"({chr(ord('a') + i)})" for i in range(PANELS[study])]
    assert not [word for word in written if re.match(r"-\d", word.text)]
    # The legend, once, above all panels.
    legend = [word.text for word in written if word.bottom < letters["(a)"]]
    assert len(legend) == len(set(legend)) >= 2
    for word in written:
        assert 1 <= word.left and word.right <= width - 1 and 1 <= word.top and word.bottom <= height - 1, word
    for one, other in itertools.combinations(written, 2):
        overlap = min(one.right, other.right) - max(one.left, other.left), min(one.bottom, other.bottom) - max(one.top, other.top)
        assert min(overlap) <= 0, (one, other)


def extents(folder, study, script, variables):
    """What gnuplot says of the axes after every panel."""
    wanted = ", ".join(f"GPVAL_{name}" for name in variables)
    script, panels = re.subn(r"(?m)^( *)(plot (?:.*\\\n)*.*)$", rf'\1\2\n\1print "panel ", {wanted}', script)
    assert panels
    (folder / "tried.gp").write_text(script, encoding="utf-8")
    done = subprocess.run(["gnuplot", "-e", "picture = '/dev/null'", "tried.gp"], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    lines = [line.split()[1:] for line in done.stderr.splitlines() if line.startswith("panel ")]
    assert len(lines) == PANELS[study]
    return [[float(number) for number in line] for line in lines]


@pytest.mark.parametrize("study", PANELS)
def test_no_curve_is_cut(studies, study):
    folder = studies / study
    script = (folder / "picture.gp").read_text(encoding="utf-8")
    axes = extents(folder, study, script, ["X_MIN", "X_MAX", "Y_MIN", "Y_MAX"])
    loose = re.sub(r"(?m)^( *)set ([xy])range .*$", r"\1set autoscale \2", script)
    curves = extents(folder, study, loose, ["DATA_X_MIN", "DATA_X_MAX", "DATA_Y_MIN", "DATA_Y_MAX"])
    for panel, (axis, curve) in enumerate(zip(axes, curves)):
        if study in CUT:
            assert axis[0] == CUT[study]
            curve[0] = axis[0]
        assert axis[0] <= curve[0] and curve[1] <= axis[1], (panel, axis, curve)
        assert axis[2] <= curve[2] and curve[3] <= axis[3], (panel, axis, curve)
    if study in CUT:
        with open(folder / "loops.csv", encoding="utf-8") as file:
            before = [row for row in csv.DictReader(file) if 1e6 * float(row["displacement_m"]) < CUT[study]]
        assert before and all(abs(float(row["force_direct_N"])) < 1e-6 for row in before)
