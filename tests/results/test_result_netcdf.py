"""result.nc as xarray and Octave read it: the same numbers as in summary.json and cycle.csv, and as documented.

Usage: test_result_netcdf.py REPOSITORY PROGRAM OCTAVE
"""

import csv
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np
import xarray

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve()
OCTAVE = sys.argv[3]
CASE = ROOT / "examples/gen1.toml"
SORTED = [0, 2, 1, 3]  # +X, -X, +Y, -Y by their angles
STEPS = 10
# Ends of the names in summary.json and cycle.csv, and the units they stand for.
UNITS = {"_N_per_m": "N/m", "_Pa": "Pa", "_deg": "degree", "_N": "N", "_J": "J", "_m": "m", "_s": "s"}
FAILURE = ("failed_increment", "failed_displacement_m", "reason")
MODES = "open stick slip_forward slip_backward"


def run_cycle(folder, *options):
    return subprocess.run(
        [PROGRAM, "cycle", CASE, "-o", folder, "--quiet", "--set", f"cycle.steps={STEPS}", *options],
        capture_output=True,
        text=True,
        check=True,
    )


def split_unit(name):
    """("force_x", "N") for "force_x_N"."""
    for end, unit in UNITS.items():
        if name.endswith(end):
            return name.removesuffix(end), unit
    return name, "1"


class Read(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name) / "it's here"
        run_cycle(cls.folder, "--set", "bump_foil.height=0.5 mm")
        cls.summary = json.loads((cls.folder / "summary.json").read_text(encoding="utf-8"))
        with open(cls.folder / "cycle.csv", newline="", encoding="utf-8") as file:
            cls.rows = list(csv.DictReader(file))
        cls.result = xarray.open_dataset(cls.folder / "result.nc")

    @classmethod
    def tearDownClass(cls):
        cls.result.close()
        cls.directory.cleanup()

    def column(self, name):
        """Column of cycle.csv as (direction, increment)."""
        rows = np.array([float(row[name]) for row in self.rows]).reshape(4, 2 * STEPS + 1)
        return rows[SORTED]

    def test_dimensions_and_coordinates(self):
        self.assertEqual(
            dict(self.result.sizes),
            {"direction": 4, "increment": 2 * STEPS + 1, "bump": 26, "foot": 26, "clearance_force": 2},
        )
        np.testing.assert_array_equal(self.result.direction, [0, 90, 180, 270])
        np.testing.assert_array_equal(self.result.increment, np.arange(2 * STEPS + 1))
        np.testing.assert_array_equal(self.result.bump, np.arange(1, 27))
        np.testing.assert_array_equal(self.result.foot, np.arange(1, 27))
        self.assertEqual(self.result.theta.dims, ("bump",))

    def test_every_column_of_the_csv(self):
        for column in self.rows[0]:
            name, unit = split_unit(column)
            if name in ("direction", "increment", "branch", "status"):
                continue
            variable = self.result[name]
            self.assertEqual(variable.dims, ("direction", "increment"))
            self.assertEqual(variable.attrs["units"], unit)
            np.testing.assert_array_equal(variable, self.column(column), name)
        branch = [row["branch"] for row in self.rows[: 2 * STEPS + 1]]
        meanings = self.result.branch.attrs["flag_meanings"].split()
        self.assertEqual([meanings[int(flag)] for flag in self.result.branch[0]], branch)
        meanings = self.result.increment_status.attrs["flag_meanings"].split()
        flags = self.result.increment_status.values.ravel()
        self.assertEqual({meanings[int(flag)] for flag in flags}, {row["status"] for row in self.rows})

    def test_every_quantity_of_the_summary(self):
        names = {"iterations": "total_iterations", "factorisations": "total_factorisations", "substeps": "total_substeps"}
        for key in self.summary["cycles"][0]:
            # Places are found in the stresses of result.nc, failures in the statuses of the increments.
            if key.endswith("_at") or key in (*FAILURE, "clearances", "loop_energies_J", "warnings"):
                continue
            name, unit = split_unit(key)
            force = re.fullmatch(r"clearance_(.+)N", name)
            variable = self.result.clearance.sel(clearance_force=float(force[1])) if force else self.result[names.get(name, name)]
            values = [self.summary["cycles"][i][key] for i in SORTED]
            if key == "status":
                values = [variable.attrs["flag_meanings"].split().index(word) for word in values]
            expected = np.array(values, dtype=float)
            np.testing.assert_array_equal(variable.astype(float), expected, key)
            self.assertEqual(variable.attrs.get("units", "1"), unit)

    def test_displacement_is_a_coordinate_and_the_nearest_direction_is_found(self):
        self.assertIn("displacement", self.result.force_direct.coords)
        self.assertIn("displacement", self.result.normal_force_top_bump.coords)
        nearest = self.result.sel(direction=100, method="nearest")
        self.assertEqual(float(nearest.direction), 90)
        np.testing.assert_array_equal(nearest.force_x, self.result.sel(direction=90).force_x)

    def test_clearances(self):
        np.testing.assert_array_equal(self.result.clearance_force, [5, 10])
        self.assertEqual(self.result.clearance_force.units, "N")
        for cycle, row in zip([self.summary["cycles"][i] for i in SORTED], self.result.clearance):
            self.assertEqual([c["force_N"] for c in cycle["clearances"]], [5, 10])
            np.testing.assert_array_equal([c["displacement_m"] for c in cycle["clearances"]], row)

    def test_loads_and_forces_agree(self):
        turning = self.result.isel(increment=STEPS)
        for loads, interface in (
            ("bump_loads", "top_bump"),
            ("foot_loads", "bump_sleeve"),
            ("journal_loads", "journal_top"),
        ):
            np.testing.assert_array_equal(self.result[loads], turning[f"normal_force_{interface}"])
            self.assertEqual(self.result[f"state_{interface}"].attrs["flag_meanings"], MODES)
        # What holds the journal is the sum of the loads along the polar angles of the crests; 26 roundings of 1 kN.
        for axis, part in (("x", np.cos), ("y", np.sin)):
            force = (self.result.normal_force_journal_top * part(self.result.phi)).sum("bump")
            np.testing.assert_allclose(force, self.result[f"force_{axis}"], atol=1e-9)

    def test_gaps_are_those_of_the_displacements(self):
        result = self.result
        gap = (
            result.radial_clearance
            - (result.x * np.cos(result.phi) + result.y * np.sin(result.phi))
            + result.top_displacement
        )
        # A closed gap is zero to the resolution of contacts, 1e-12 m.
        np.testing.assert_allclose(gap.transpose(*result.gap_journal_top.dims), result.gap_journal_top, atol=1e-12)

    def test_every_variable_is_described(self):
        for name, variable in self.result.variables.items():
            self.assertTrue(variable.attrs["long_name"], name)
            self.assertTrue("units" in variable.attrs or "flag_meanings" in variable.attrs, name)
            self.assertIn(variable.dtype.kind, "fi", name)

    def test_provenance(self):
        attributes = self.result.attrs
        self.assertEqual(attributes["Conventions"], "CF-1.8")
        self.assertEqual(attributes["status"], "complete")
        self.assertEqual(attributes["case_text"], CASE.read_text(encoding="utf-8"))
        self.assertIn(self.summary["version"], attributes["source"])
        self.assertIn(self.summary["commit"], attributes["source"])
        self.assertRegex(attributes["date_created"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        # A shell takes the command line as it was given, spaces and quotes included.
        words = subprocess.run(
            ["sh", "-c", f"printf '%s\\n' {attributes['command_line']}"], capture_output=True, text=True, check=True
        ).stdout.splitlines()
        self.assertEqual(words[:5], ["bumpfoil", "cycle", str(CASE), "-o", str(self.folder)])
        self.assertIn("bump_foil.height=0.5 mm", words)

    def test_case_understood_gives_the_same_results(self):
        case = Path(self.directory.name) / "understood.toml"
        case.write_text(self.result.attrs["case_understood"], encoding="utf-8")
        again = Path(self.directory.name) / "again"
        subprocess.run([PROGRAM, "cycle", case, "-o", again, "--quiet"], check=True)
        with xarray.open_dataset(again / "result.nc") as repeated:
            xarray.testing.assert_equal(repeated.drop_vars("wall_time"), self.result.drop_vars("wall_time"))

    def test_octave_reads_the_same(self):
        script = """
            pkg load netcdf
            file = getenv("RESULT");
            for name = {"force_direct", "loop_energy", "direction", "state_bump_sleeve", "normal_force_top_bump"}
              values = double(ncread(file, name{1}));
              printf("%s;%s;%s\\n", name{1}, sprintf("%d ", size(values)), sprintf("%.17g ", values));
            end
            printf("status;%s;\\n", ncreadatt(file, "/", "status"));
            printf("units;%s;\\n", ncreadatt(file, "tangent_stiffness_loading", "units"));
            printf("variables;%d;\\n", numel(ncinfo(file).Variables));
        """
        done = subprocess.run(
            [OCTAVE, "--quiet", "--no-init-file", "--eval", script],
            env=dict(os.environ, RESULT=str(self.folder / "result.nc")),
            capture_output=True,
            text=True,
        )
        lines = dict(line.split(";", 1) for line in done.stdout.splitlines())
        self.assertEqual(lines.pop("status", done.stderr), "complete;")
        self.assertEqual(lines.pop("units"), "N/m;")
        self.assertEqual(lines.pop("variables"), f"{len(self.result.variables)};")
        self.assertEqual(len(lines), 5)
        for name, line in lines.items():
            shape, values = ([float(word) for word in part.split()] for part in line.split(";"))
            expected = self.result[name].values
            # Octave counts the dimensions from the other end, and a column is a matrix.
            self.assertEqual(shape, [*expected.shape[::-1], *([1] if expected.ndim == 1 else [])])
            np.testing.assert_array_equal(values, expected.ravel(), name)


class Partial(unittest.TestCase):
    def test_an_interrupted_run_is_flagged(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            # As ever, unless these tests run in the background of a shell without job control.
            signal.signal(signal.SIGINT, signal.default_int_handler)
            program = subprocess.Popen(
                [PROGRAM, "cycle", CASE, "-o", folder, "--quiet", "--set", "cycle.steps=20000"],
                stderr=subprocess.PIPE,
            )
            while not folder.exists() and program.poll() is None:
                time.sleep(0.005)
            time.sleep(0.2)
            program.send_signal(signal.SIGINT)
            program.communicate()
            self.assertEqual(program.returncode, 130)
            with xarray.open_dataset(folder / "result.nc") as result:
                self.assertEqual(result.attrs["status"], "partial")
                self.assertIn("interrupted", result.attrs["status_message"])
                self.assertEqual(result.converged[-1], 0)
                self.assertEqual(result.sizes["increment"], 40001)
                force = result.force_direct.values
                reached = np.isfinite(force)
                self.assertTrue(reached[0, 0])
                self.assertFalse(reached[-1, -1])
                # Nothing but what was computed is a number.
                self.assertEqual(reached.sum(), (folder / "cycle.csv").read_bytes().count(b"\n") - 1)


    def test_a_failed_run_says_what_where_and_why(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            strip = ["strip.bumps=3", "strip.steps=4", "strip.load=1 MN"]  # beyond what flat bumps carry
            options = [word for key in strip for word in ("--set", key)]
            done = subprocess.run([PROGRAM, "strip", CASE, "-o", folder, *options], capture_output=True, text=True)
            self.assertEqual(done.returncode, 3, done.stderr)
            cycle = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["cycles"][0]
            rows = list(csv.DictReader((folder / "strip.csv").read_text(encoding="utf-8").splitlines()))
            failed = cycle["failed_increment"]
            self.assertEqual(len(rows), failed + 1)
            self.assertEqual(rows[-1]["status"], cycle["status"])
            self.assertEqual(rows[-1]["force_direct_N"], "")
            self.assertEqual({row["status"] for row in rows[:-1]}, {"converged"})
            with xarray.open_dataset(folder / "result.nc") as result:
                meanings = result.increment_status.attrs["flag_meanings"].split()
                self.assertEqual(meanings[int(result.increment_status[0, failed])], cycle["status"])
                self.assertEqual(meanings[int(result.status[0])], cycle["status"])
                self.assertEqual(float(result.displacement[0, failed]), cycle["failed_displacement_m"])
                self.assertTrue(np.isnan(result.force_direct[0, failed]))
                sentence = result.attrs["status_message"]
            self.assertIn(f"increment {failed} of ", sentence)
            self.assertTrue(sentence.endswith(cycle["reason"]))
            self.assertIn(f"bumpfoil: {sentence}; the results in {folder} are partial and flagged as such", done.stderr)


def documented_variables(text):
    """Dimensions, unit and meaning of the variables in the tables of a text."""
    rows = re.findall(r"^\| `(\w+)` \| ([\w, ]*)\| ([^|]+) \| (.*) \|$", text, re.MULTILINE)
    return {name: (dims.strip(), unit, meaning) for name, dims, unit, meaning in rows}


def written_variables(result):
    return {
        str(name): (", ".join(variable.dims), variable.attrs.get("units", "flag"), variable.attrs["long_name"])
        for name, variable in result.variables.items()
    }


class Documentation(unittest.TestCase):
    TEXT = (ROOT / "docs/results.md").read_text(encoding="utf-8")
    FORMED = re.search(r"^### Formed top foils$.*?(?=^##)", TEXT, re.MULTILINE | re.DOTALL).group(0)
    PADS = re.search(r"^### Several pads$.*?(?=^##)", TEXT, re.MULTILINE | re.DOTALL).group(0)
    TILTED = re.search(r"^### A tilted journal$.*?(?=^##)", TEXT, re.MULTILINE | re.DOTALL).group(0)
    STRIPS = re.search(r"^### Strips$.*?(?=^##)", TEXT, re.MULTILINE | re.DOTALL).group(0)
    VARIABLES = documented_variables(
        TEXT[: TEXT.index("\n## Running bearings")]
        .replace(FORMED, "")
        .replace(PADS, "")
        .replace(TILTED, "")
        .replace(STRIPS, "")
    )

    def test_every_variable_is_documented_with_dimensions_units_and_meaning(self):
        with tempfile.TemporaryDirectory() as directory:
            run_cycle(Path(directory) / "results", "--solver", "events")
            with xarray.open_dataset(Path(directory) / "results/result.nc") as result:
                written = written_variables(result)
                attributes = set(result.attrs)
            keys = json.loads((Path(directory) / "results/summary.json").read_text(encoding="utf-8"))["cycles"][0]
            columns = (Path(directory) / "results/cycle.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
        self.assertEqual(self.VARIABLES, written)
        # Keys and columns mean what the variables mean.
        sections = re.split(r"^## ", self.TEXT, flags=re.MULTILINE)
        of_cycles = "".join(one for one in sections if one.startswith(("summary.json", "cycle.csv", "result.nc")))
        self.assertIn("| `converged` |", of_cycles)
        meanings = dict(re.findall(r"^\| `(\w+)` \| ([^|]*) \|$", of_cycles, re.MULTILINE))
        for key in [*keys, *columns]:
            name = split_unit(key)[0]
            candidates = {meaning for prefix in ("", "total_", "increment_") for meaning in written.get(prefix + name, ())[2:]}
            if key in meanings and candidates:
                self.assertIn(meanings[key], candidates, key)
        for name in attributes | {"status_message"}:
            self.assertIn(f"`{name}`", self.TEXT)

    def test_formed_foils_have_what_is_documented_besides(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            run_cycle(folder, "--solver", "events", "--set", "top_foil.formed_radius=seated")
            with xarray.open_dataset(folder / "result.nc") as result:
                written = written_variables(result)
        self.assertEqual(written, self.VARIABLES | documented_variables(self.FORMED))

    def test_a_tilted_journal_has_what_is_documented_besides(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            run_cycle(folder, "--solver", "events", "--set", "width.modes=3", "--set", 'width.tilt=["0.1 mrad", "0 mrad"]')
            with xarray.open_dataset(folder / "result.nc") as result:
                written = written_variables(result)
            keys = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["cycles"][0]
        self.assertEqual(written, self.VARIABLES | documented_variables(self.TILTED))
        for key in keys:
            self.assertIn(f"`{key}`", self.TEXT)

    def test_strips_that_differ_have_what_is_documented_besides(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            command = [PROGRAM, "cycle", ROOT / "examples/gen2-three-strips.toml", "-o", folder, "--quiet"]
            few = ["cycle.steps=4", "width.modes=2", 'cycle.directions=["+X"]']
            options = [word for key in few for word in ("--set", key)]
            subprocess.run([*command, "--solver", "events", *options], check=True)
            with xarray.open_dataset(folder / "result.nc") as result:
                written = written_variables(result)
                # The loads of all strips are those of all bumps.
                np.testing.assert_allclose(result.strip_load.sum("strip"), result.normal_force_top_bump.sum("bump"), atol=1e-6)
            keys = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["cycles"][0]
        besides = documented_variables(self.TILTED) | documented_variables(self.STRIPS)
        self.assertEqual(written.items() ^ (self.VARIABLES | besides).items(), set())
        for key in keys:
            self.assertIn(f"`{key}`", self.TEXT)

    def test_bearings_of_pads_have_what_is_documented_besides(self):
        of_pads = documented_variables(self.PADS)
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            command = [PROGRAM, "cycle", ROOT / "examples/three_pads.toml", "-o", folder, "--quiet", "--solver", "events"]
            subprocess.run([*command, "--set", "cycle.steps=4"], check=True)
            with xarray.open_dataset(folder / "result.nc") as result:
                written = written_variables(result)
        self.assertGreater(len(of_pads), 5)
        self.assertEqual(of_pads, {name: written.get(name) for name in of_pads})
        self.assertEqual(set(written), set(of_pads) | set(self.VARIABLES))
        at_welds = {name for name, (dims, _, _) in written.items() if "pad" in dims.split(", ")} - set(of_pads)
        self.assertTrue(at_welds and all("weld" in name for name in at_welds), at_welds)

    def test_a_strip_differs_as_documented(self):
        def named(start):
            item = re.search(rf"^\* {start}: (.*(?:\n  .*)*)$", self.TEXT, re.MULTILINE).group(1)
            return set(re.findall(r"`(\w+)`", item))

        documented = set(self.VARIABLES)
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            command = [PROGRAM, "strip", ROOT / "examples/strip.toml", "-o", folder, "--quiet", "--solver", "events"]
            subprocess.run([*command, "--set", "strip.top_foil=true"], check=True)
            with xarray.open_dataset(folder / "result.nc") as result:
                self.assertEqual({str(name) for name in result.variables}, documented - named("missing") | named("additional"))
                self.assertEqual(result.attrs["bumpfoil_command"], "strip")
                self.assertEqual(dict(result.sizes) | {"event": 0}, {"cycle": 2, "increment": 41, "bump": 10, "foot": 20, "event": 0})
                self.assertEqual(result.normal_force_bump_sleeve.dims, ("cycle", "increment", "foot"))
                # The plate holds what the bumps carry; roundings of 1 kN.
                np.testing.assert_allclose(result.normal_force_journal_top.sum("bump"), result.force_direct, atol=1e-9)
                force = result.force_direct.values.ravel()
            rows = list(csv.DictReader((folder / "strip.csv").read_text(encoding="utf-8").splitlines()))
            np.testing.assert_array_equal([float(row["force_direct_N"]) for row in rows], force)
            self.assertEqual([row["cycle"] for row in rows], ["1"] * 41 + ["2"] * 41)
            summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(summary["command"], "strip")
        for name in [*summary["cycles"][0], *rows[0]]:
            self.assertIn(f"`{name}`", self.TEXT)

    def test_every_key_and_column_is_documented(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory) / "results"
            run_cycle(folder)
            summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
            header = (folder / "cycle.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
        for name in [*summary, *summary["cycles"][0], *header]:
            self.assertIn(f"`{name}`", self.TEXT)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
