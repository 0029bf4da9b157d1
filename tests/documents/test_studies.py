"""The numbers on the pages about the studies are those that the program computes.

Usage: test_studies.py REPOSITORY PROGRAM RESULTS    the last: what `bumpfoil reproduce --all` wrote

In docs/verification/paper.md every row of a table that begins with a number is a claim of the paper; the bold numbers in
it are compared, in their order, with what is computed here from the results of `bumpfoil reproduce`. Rows of the tables
between <!-- name --> and <!-- /name --> in docs/studies.md are compared as a whole.
"""

import csv
import json
import math
import re
import subprocess
import sys
import unittest
from functools import cache
from pathlib import Path

import dense_push

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve()
RESULTS = Path(sys.argv[3])

DIRECTIONS = {"+X": 0, "−X": 180, "+Y": 90, "−Y": 270}
SIGMAS = (10, 20)
BEARINGS = range(1, 7)


@cache
def table(study, name):
    with open(RESULTS / study / f"{name}.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@cache
def rows(study, name, run, direction):
    return [
        row
        for row in table(study, name)
        if row["run"] == run and float(row["direction_deg"]) == DIRECTIONS[direction]
    ]


def quantity(study, run, direction, key="max_force_N"):
    return float(rows(study, "quantities", run, direction)[0][key])


def elements(direction, key="force_direct_N"):
    """A column of the finite elements beside figure 12."""
    rows_of = [row for row in table("figure12", "finite_elements") if float(row["direction_deg"]) == DIRECTIONS[direction]]
    return [float(row[key]) for row in rows_of]


def loop_energy(forces_of, displacements):
    return sum(
        0.5 * (forces_of[i] + forces_of[i - 1]) * (displacements[i] - displacements[i - 1])
        for i in range(1, len(forces_of))
    )


def loads(study, run, direction, key="bump_load_N"):
    return [float(row[key]) for row in rows(study, "loads", run, direction)]


def forces(study, run, direction):
    return [float(row["force_direct_N"]) for row in rows(study, "loops", run, direction)]


def change(value, reference):
    """In per cent."""
    return 100 * (value / reference - 1)


def scattered(key, sigma, study=None, variant=""):
    """A quantity of the six bearings, +X."""
    study = study or ("figure13" if sigma == 10 else "figure14")
    return [quantity(study, f"scatter{sigma}-bearing{i}{variant}", "+X", key) for i in BEARINGS]


def text(value, digits=0, signed=False):
    number = f"{value:{'+' if signed else ''}.{digits}f}"
    if float(number) == 0.0:
        number = number.lstrip("+-")
    return number.replace("-", "−")


def texts(values, digits=0, signed=False):
    return [text(value, digits, signed) for value in values]


def range_texts(values, digits=0):
    return texts((min(values), max(values)), digits)


def friction_effect(model):
    return [
        change(quantity("figure10", f"{model}-friction", d), quantity("figure10", f"{model}-frictionless", d))
        for d in DIRECTIONS
    ]


def model_change(direction, friction, key="max_force_N"):
    return change(
        quantity("figure10", f"present-{friction}", direction, key),
        quantity("figure10", f"former-{friction}", direction, key),
    )


def path_deviation(direction, friction):
    """Largest difference of the models on the loading branch, in per cent of the largest force."""
    present = forces("figure10", f"present-{friction}", direction)[:101]
    former = forces("figure10", f"former-{friction}", direction)[:101]
    return 100 * max(abs(a - b) for a, b in zip(present, former)) / present[-1]


def load_differences(direction, friction, bumps):
    present = loads("figure11", f"present-{friction}", direction)
    former = loads("figure11", f"former-{friction}", direction)
    return [present[i - 1] - former[i - 1] for i in bumps]


def steepest(direction, friction, model):
    values = loads("figure11", f"{model}-{friction}", direction)
    return max(abs(a - b) for a, b in zip(values, values[1:]))


def loop_width(run, direction):
    """Largest difference of force between loading and unloading."""
    values = forces("figure10", run, direction)
    return max(abs(values[i] - values[200 - i]) for i in range(101))


def changes_of_state(study, run, direction, interface, upto=201):
    contacts = rows(study, "contacts", run, direction)[:upto]
    return [sum(int(row[f"newly_{state}_{interface}"]) for row in contacts) for state in ("open", "closed")]


@cache
def push_to_weld(sign):
    """The push to -X without friction by dense algebra, the top foil with the given sign."""
    done = subprocess.run(
        [str(PROGRAM), "properties", str(ROOT / "examples/gen1.toml"), "--json"], capture_output=True, check=True
    )
    return dense_push.push_to_weld(json.loads(done.stdout)["truss"], 79.5e-6, sign)


def mirrored_with_friction():
    """Force and journal loads for -X if the top foil helped the journal where it resists it, contacts unchanged.

    The top foil's own load over a bump is that of the journal less that of the bump; the weld is at -X.
    """
    run = "present-friction"
    journal, bumps = (loads("figure11", run, "−X", key) for key in ("journal_load_N", "bump_load_N"))
    over = [2 * b - j for j, b in zip(journal, bumps)]
    return sum(load * math.cos(theta) for load, theta in zip(over, dense_push.THETA)), over


def reading_effect(reading):
    """Of friction on the force, in per cent."""
    return [
        change(
            quantity("height_reference", f"present-friction-{reading}", d),
            quantity("height_reference", f"present-frictionless-{reading}", d),
        )
        for d in DIRECTIONS
    ]


def journal_gap(bump):
    """Between journal and undeformed top foil over a bump, full push to +Y, in um."""
    return 31.8 - 79.5 * math.sin((bump - 0.5) * 4.572 / 19.05)


def tall_bump_probability(sigma, clearance=31.8, bumps=26):
    """That at least one of the bumps is taller than the clearance, in per cent."""
    below = 0.5 * (1 + math.erf(clearance / sigma / math.sqrt(2)))
    return 100 * (1 - below**bumps)


def halved_increments():
    summaries = [
        json.loads(path.read_text(encoding="utf-8"))
        for study in ("figure10", "figure13", "figure14")
        for path in (RESULTS / study).glob("*/summary.json")
    ]
    return sum(cycle["substeps"] for summary in summaries for cycle in summary["cycles"])


def claims():
    """The bold numbers of every claim."""
    every = list(DIRECTIONS)
    present, bare, former = "present-friction", "present-frictionless", "former-friction"

    def cross(run):
        return [100 * quantity("figure10", run, d, "cross_force_at_max_N") / quantity("figure10", run, d) for d in every]

    def against(model, key):
        return [change(quantity("figure12", "truss", d, key), quantity("figure12", model, d, key)) for d in every]

    def against_elements(model):
        """Force and loop energy for the bumps of the finite elements."""
        run = f"{model}-midsurface"
        of_force = [change(quantity("figure12", run, d), elements(d)[100]) for d in every]
        of_loop = [
            change(
                quantity("figure12", run, d, "loop_energy_J"), loop_energy(elements(d), elements(d, "displacement_m"))
            )
            for d in every
        ]
        return texts(of_force, 1, signed=True) + texts(of_loop, 1, signed=True)

    def scatter_against_frame(key):
        return [
            change(truss, frame)
            for sigma in SIGMAS
            for truss, frame in zip(
                scattered(key, sigma, "scatter", "-truss"), scattered(key, sigma, "scatter", "-frame")
            )
        ]

    def estimates(sigma):
        fives, tens = (scattered(f"clearance_{n}N_m", sigma) for n in (5, 10))
        return [*range_texts([1e6 * v for v in fives]), *range_texts([1e6 * v for v in tens])]

    def perfect_clearance(newtons):
        return quantity("figure13", "perfect", "+X", f"clearance_{newtons}N_m")

    thin = "frictionless-top_foil_0.0102mm"
    return {
        1: [text(2.5 * 31.8, 1), text(1.5 * 31.8, 1)],
        2: texts([abs(v) for v in cross(present)]) + [text(max(abs(v) for v in cross(bare)), 1)],
        3: [text(max(loop_width(former, d) for d in every), 3)],
        4: texts([1e3 * quantity("figure10", present, d, "loop_energy_J") for d in every], 2),
        5: [text(max(loop_width(run, d) for run in (bare, "former-frictionless") for d in every), 3)],
        6: texts(friction_effect("present")) + texts(friction_effect("former")),
        7: texts([model_change(d, f) for f in ("friction", "frictionless") for d in ("+X", "−Y")], 1, signed=True)
        + texts([path_deviation(d, "friction") for d in ("+X", "−Y")], 1),
        8: texts([model_change(d, f) for f in ("friction", "frictionless") for d in ("−X", "+Y")], 1, signed=True),
        9: [t for run in (present, former, bare) for t in texts(loads("figure11", run, "−X")[:2])],
        10: [text(load_differences("−X", f, [1])[0], 1, signed=True) for f in ("friction", "frictionless")],
        11: [
            t
            for friction in ("friction", "frictionless")
            for t in texts(load_differences("−X", friction, [2, 3, 4, 5]), 1, signed=True)
        ],
        12: texts(loads("top_foil", thin, "−X")[:2], 1) + texts(loads("figure11", bare, "−X")[:2], 1),
        13: texts([model_change("−X", f) for f in ("frictionless", "friction")], 1, signed=True)
        + texts(
            [
                quantity("figure10", bare, "−X"),
                quantity("top_foil", thin, "−X"),
                quantity("figure10", "former-frictionless", "−X"),
            ],
            1,
        ),
        14: texts([model_change("+Y", f) for f in ("friction", "frictionless")], 1, signed=True),
        15: texts(load_differences("+Y", "friction", [1, 2, 3, 4]), signed=True)
        + [text(max(abs(v) for v in load_differences("+Y", "friction", range(5, 27))), 1)],
        16: texts(loads("top_foil", "top_foil_0.0102mm", "+Y")[:3]) + texts(loads("figure11", present, "+Y")[:3]),
        17: [t for d in ("+Y", "−X") for t in texts([steepest(d, "friction", m) for m in ("present", "former")])],
        18: texts(against("frame", "max_force_N"), 1, signed=True)
        + texts(against("frame-nonlinear", "max_force_N"), 1, signed=True)
        + texts(against("frame-nonlinear", "loop_energy_J"), 1, signed=True)
        + against_elements("truss")
        + against_elements("frame"),
        22: texts([100 * sigma / 508 for sigma in SIGMAS], 1),
        23: texts([f(scatter_against_frame("max_force_N")) for f in (min, max)], 1, signed=True),
        24: [text(sum(v > 0 for v in scatter_against_frame("max_force_N")))],
        25: texts([f(scatter_against_frame("loop_energy_J")) for f in (min, max)], 1, signed=True),
        26: [text(quantity("clearance", "clearance_-10um", "+X", "initial_journal_load_N"))],
        27: texts([1e6 * perfect_clearance(n) for n in (5, 10)], 1),
        28: [text(1e6 * (perfect_clearance(10) - perfect_clearance(5)), 1)],
        29: estimates(10) + estimates(20),
        30: texts(scattered("initial_journal_load_N", 20), 1),
        31: [text(sum(v > 0 for v in scattered("initial_journal_load_N", 10)))]
        + texts([tall_bump_probability(sigma) for sigma in SIGMAS]),
        32: [
            t
            for interface in ("top_bump", "journal_top", "bump_sleeve")
            for t in texts(changes_of_state("figure16", "scatter20-bearing4", "+X", interface))
        ],
        33: [
            rows("figure10", "contacts", present, "+X")[100][f"closed_{interface}"]
            for interface in ("journal_top", "top_bump", "bump_sleeve")
        ]
        + [text(sum(changes_of_state("figure10", present, d, "top_bump", 101)[0] for d in every))],
        37: [text(halved_increments())],
    }


def arguments():
    """The bold numbers in what the page says about differences."""
    bare = "present-frictionless"
    force, over, _ = push_to_weld(-1)
    force_with_friction, over_with_friction = mirrored_with_friction()
    former = {f: quantity("figure10", f"former-{f}", "−X") for f in ("friction", "frictionless")}
    thin = quantity("top_foil", "frictionless-top_foil_0.0102mm", "−X")
    return [
        text(model_change("−X", "frictionless", "elastic_energy_at_max_J"), 1, signed=True),
        text(change(thin, former["frictionless"]), 1, signed=True),
        text(quantity("figure10", bare, "−X") - thin),
        *texts(over[:2]),
        *texts(loads("figure11", "former-frictionless", "−X")[:2]),
        text(change(force, former["frictionless"]), 1, signed=True),
        *texts([a - b for a, b in zip(over_with_friction, loads("figure11", "former-friction", "−X"))][:5], signed=True),
        text(change(force_with_friction, former["friction"]), 1, signed=True),
        *texts([journal_gap(bump) for bump in (1, 2)]),
        *texts([quantity("figure12", model, "+Y", "cross_force_at_max_N") for model in ("truss", "frame", "frame-nonlinear")]),
        *texts(reading_effect("midsurface")),
    ]


def quantity_row(name, study, run, direction, columns):
    return [name, *(text(scale * quantity(study, run, direction, key), digits) for key, scale, digits in columns)]


def runs_of(study):
    return list(dict.fromkeys(row["run"] for row in table(study, "quantities")))


def by_direction(study, run, columns):
    """For each column the four directions."""
    return [text(scale * quantity(study, run, d, key), digits) for key, scale, digits in columns for d in DIRECTIONS]


def tables():
    """Rows of the tables of docs/studies.md."""
    force, loop = ("max_force_N", 1, 0), ("loop_energy_J", 1e3, 2)
    scatter_columns = [
        force,
        ("loaded_stiffness_N_per_m", 1e-6, 2),
        ("tangent_stiffness_loading_N_per_m", 1e-6, 1),
        ("cross_force_at_max_N", 1, 0),
        loop,
        ("loss_factor", 1, 3),
        ("initial_journal_load_N", 1, 1),
        ("clearance_5N_m", 1e6, 1),
        ("clearance_10N_m", 1e6, 1),
    ]
    scattered_rows = [quantity_row("perfect", "figure13", "perfect", "+X", scatter_columns)]
    for sigma, study in zip(SIGMAS, ("figure13", "figure14")):
        for i in BEARINGS:
            run = f"scatter{sigma}-bearing{i}"
            scattered_rows.append(quantity_row(f"{sigma} µm, {i}", study, run, "+X", scatter_columns))
    top_foil_rows = []
    for friction, prefix in (("0.1", ""), ("0", "frictionless-")):
        for thickness in ("0.0102", "0.102", "1.02"):
            run = f"{prefix}top_foil_{thickness}mm"
            shown = texts(loads("top_foil", run, "−X")[:3]) + texts(loads("top_foil", run, "+Y")[:3])
            top_foil_rows.append([friction, thickness, *by_direction("top_foil", run, [force]), *shown])
    increments = {run: by_direction("increments", run, [("max_force_N", 1, 1), ("loop_energy_J", 1e3, 3)])
                  for run in runs_of("increments")}
    return {
        "scattered": scattered_rows,
        "top_foil": top_foil_rows,
        "friction": [
            [text(0.05 * i, 2), *by_direction("friction", run, [force, ("loop_energy_J", 1e3, 1), ("loss_factor", 1, 3)])]
            for i, run in enumerate(runs_of("friction"))
        ],
        "increments": [
            [run.removeprefix("steps_"), *increments[run]]
            for run in [*(r for r in increments if r != "events"), "events"]
        ],
        "clearance": [
            [text(-10 + 5 * i), *by_direction("clearance", run, [force, ("loop_energy_J", 1e3, 1)])]
            for i, run in enumerate(runs_of("clearance"))
        ],
        "height_reference": [
            [name, *by_direction("height_reference", f"present-{friction}-{reading}", [force])]
            for name, reading, friction in (
                ("over the sleeve, f = 0.1", "overall", "friction"),
                ("over the sleeve, f = 0", "overall", "frictionless"),
                ("mid-surface, f = 0.1", "midsurface", "friction"),
                ("mid-surface, f = 0", "midsurface", "frictionless"),
            )
        ],
    }


def bold_numbers(line):
    return re.findall(r"\*\*([−+]?\d+(?:\.\d+)?)\*\*", line)


class Pages(unittest.TestCase):
    maxDiff = None

    def test_claims_of_the_paper(self):
        page = (ROOT / "docs/verification/paper.md").read_text(encoding="utf-8")
        lines = {int(n): line for line in page.splitlines() for n in re.findall(r"^\| (\d+) \|", line)}
        self.assertEqual(sorted(lines), list(range(1, len(lines) + 1)))
        expected = claims()
        self.assertEqual({n: bold_numbers(line) for n, line in lines.items()}, {n: expected.get(n, []) for n in lines})
        for n, line in lines.items():
            self.assertRegex(line.split("|")[3].strip(), r"^(met|partly met|not met|not checkable)$", n)
        self.assertEqual(bold_numbers(page.split("## Where we differ")[1]), arguments())

    def test_dense_push_is_that_of_the_program(self):
        force, over, closed = push_to_weld(1)
        # Both solve the same equations to rounding; the inverse of the compliance has lost five of sixteen digits.
        self.assertAlmostEqual(force / quantity("figure10", "present-frictionless", "−X"), 1.0, delta=1e-9)
        for dense, program in zip(over, loads("figure11", "present-frictionless", "−X", "journal_load_N")):
            self.assertAlmostEqual(dense, program, delta=1e-6)
        self.assertTrue((closed == push_to_weld(-1)[2]).all())

    def test_finite_elements_are_those_of_the_verification(self):
        records = json.loads((ROOT / "tests/data/fe/full_bearing.json").read_text(encoding="utf-8"))["rows"]
        for name, degrees in DIRECTIONS.items():
            held = [r for r in records if (r["variant"], r["friction"], r["direction_deg"]) == ("held", 0.1, degrees)]
            self.assertEqual(len(held), 1)
            for key in ("displacement_m", "force_direct_N", "force_cross_N"):
                self.assertEqual(elements(name, key), held[0][key])

    def test_tables_of_the_studies(self):
        page = (ROOT / "docs/studies.md").read_text(encoding="utf-8")
        for name, expected in tables().items():
            block = re.search(rf"<!-- {name} -->\n(.*?)<!-- /{name} -->", page, re.DOTALL).group(1)
            shown = [[cell.strip() for cell in line.strip("|").split("|")] for line in block.splitlines()[2:]]
            with self.subTest(name):
                self.assertEqual(shown, expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
